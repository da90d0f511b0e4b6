#include "app/tissue_dialog.h"

#include <QPushButton>

#include "ui_tissue_dialog.h"

namespace gnathion {
namespace {

// The entries of each box stand in the order of the enumeration.
template <typename T>
T chosen(const QComboBox* box) {
  return static_cast<T>(box->currentIndex());
}

template <typename T>
void choose(QComboBox* box, T value) {
  box->setCurrentIndex(static_cast<int>(value));
}

}  // namespace

TissueDialog::TissueDialog(const TissueModel& model, QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::TissueDialog>()), given_(model) {
  ui_->setupUi(this);
  show_model(model);
  connect(ui_->tissue_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(ui_->tissue_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(ui_->tissue_buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked,
          this, [this] { show_model({}); });
  connect(ui_->tissue_load_box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &TissueDialog::keep_to_force_transfer);
  keep_to_force_transfer();
}

TissueDialog::~TissueDialog() = default;

void TissueDialog::show_model(const TissueModel& model) {
  ui_->tissue_tolerance_box->setValue(model.tolerance_mm);
  choose(ui_->tissue_elements_box, model.elements);
  choose(ui_->tissue_strain_box, model.strain);
  choose(ui_->tissue_kinds_box, model.kinds);
  ui_->tissue_poisson_box->setValue(model.material.poisson);
  choose(ui_->tissue_load_box, model.load);
  ui_->tissue_edge_box->setValue(model.edge_mm);
  ui_->tissue_layers_box->setValue(model.layer_edges);
  ui_->tissue_reach_box->setValue(model.bone_reach_mm);
  ui_->tissue_released_box->setValue(model.released_mm);
  ui_->tissue_teeth_check->setChecked(model.slides_on_teeth);
}

/// Force transfer has linear elements and small strain only.
void TissueDialog::keep_to_force_transfer() {
  const bool force = chosen<LoadModel>(ui_->tissue_load_box) == LoadModel::force;
  if (force) {
    choose(ui_->tissue_elements_box, Elements::automatic);
    choose(ui_->tissue_strain_box, Strain::automatic);
  }
  ui_->tissue_elements_box->setEnabled(!force);
  ui_->tissue_strain_box->setEnabled(!force);
}

TissueModel TissueDialog::model() const {
  TissueModel model = given_;
  model.tolerance_mm = ui_->tissue_tolerance_box->value();
  model.elements = chosen<Elements>(ui_->tissue_elements_box);
  model.strain = chosen<Strain>(ui_->tissue_strain_box);
  model.kinds = chosen<TissueKinds>(ui_->tissue_kinds_box);
  model.material.poisson = ui_->tissue_poisson_box->value();
  model.load = chosen<LoadModel>(ui_->tissue_load_box);
  model.edge_mm = ui_->tissue_edge_box->value();
  model.layer_edges = ui_->tissue_layers_box->value();
  model.bone_reach_mm = ui_->tissue_reach_box->value();
  model.released_mm = ui_->tissue_released_box->value();
  model.slides_on_teeth = ui_->tissue_teeth_check->isChecked();
  return model;
}

}  // namespace gnathion
