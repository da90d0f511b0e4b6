#include "app/photograph_dialog.h"

#include <QFile>
#include <QPushButton>
#include <array>

#include "ui_photograph_dialog.h"

namespace gnathion {
namespace {

/// Millimetres in a unit, by its place in the box; the first is none.
constexpr std::array<double, 4> mm_of_unit{0, 1, 10, 1000};

}  // namespace

PhotographDialog::PhotographDialog(const std::filesystem::path& obj, QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::PhotographDialog>()), obj_(obj) {
  ui_->setupUi(this);
  ui_->photograph_label->setText(
      tr("What <b>%1</b> does not say about itself:")
          .arg(QFile::decodeName(obj.filename().c_str()).toHtmlEscaped()));
  QPushButton* add = ui_->photograph_buttons->button(QDialogButtonBox::Ok);
  add->setText(tr("&Add the photograph"));
  add->setObjectName("photograph_add_button");
  ui_->photograph_unit_label->setBuddy(ui_->photograph_unit_box);
  connect(ui_->photograph_unit_box, qOverload<int>(&QComboBox::currentIndexChanged), this,
          &PhotographDialog::update_button);
  connect(ui_->photograph_frame_box, &QCheckBox::toggled, this, &PhotographDialog::update_button);
  connect(ui_->photograph_buttons, &QDialogButtonBox::accepted, this, &PhotographDialog::choose);
  connect(ui_->photograph_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  update_button();
}

PhotographDialog::~PhotographDialog() = default;

void PhotographDialog::update_button() {
  ui_->photograph_buttons->button(QDialogButtonBox::Ok)
      ->setEnabled(ui_->photograph_unit_box->currentIndex() > 0 &&
                   ui_->photograph_frame_box->isChecked());
}

void PhotographDialog::choose() {
  PhotographSource photograph{obj_, {}};
  photograph.lps_from_photograph.scale = mm_of_unit.at(ui_->photograph_unit_box->currentIndex());
  emit photograph_chosen(photograph);
  accept();
}

}  // namespace gnathion
