#include "app/photograph_dialog.h"

#include <QFile>
#include <QPushButton>
#include <QRadioButton>
#include <array>

#include "app/core_words.h"
#include "scan/scan_import.h"
#include "ui_photograph_dialog.h"

namespace gnathion {
namespace {

/// Millimetres in a unit, by its place in the box; the first is none.
constexpr std::array<double, 4> mm_of_unit{0, 1, 10, 1000};

/// Of points in LPS, in any unit: the middle of the front of their box.
Eigen::Vector3d front_of(const Points& points) {
  const Eigen::Vector3d least = points.colwise().minCoeff(), most = points.colwise().maxCoeff();
  return {(least.x() + most.x()) / 2, least.y(), (least.z() + most.z()) / 2};
}

}  // namespace

PhotographDialog::PhotographDialog(const std::filesystem::path& obj, const Points& face,
                                   QWidget* parent)
    : QDialog(parent),
      ui_(std::make_unique<Ui::PhotographDialog>()),
      obj_(obj),
      front_(front_of(face)) {
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
  for (QRadioButton* button : {ui_->photograph_fit_button, ui_->photograph_on_ct_button}) {
    connect(button, &QRadioButton::toggled, this, &PhotographDialog::update_button);
  }
  connect(ui_->photograph_buttons, &QDialogButtonBox::accepted, this, &PhotographDialog::choose);
  connect(ui_->photograph_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  update_button();
  read_scan_size();
}

PhotographDialog::~PhotographDialog() = default;

/// Its size proposes a unit, its shape the way it looks.
void PhotographDialog::read_scan_size() {
  connect(&reading_, &BackgroundTask::failed, this, [this](const Failure& failure) {
    ui_->photograph_proposal_label->setText(
        tr("It cannot be read: %1. What to do: %2.")
            .arg(failure.problem.toHtmlEscaped(), failure.remedy.toHtmlEscaped()));
  });
  reading_.start([this](Progress& progress) {
    const ObjDocument scan = read_scan(obj_, progress);
    const TriangleMesh& surface = scan.mesh().surface;
    const ProposedUnit unit = proposed_units(surface.vertices).front();
    progress.check();
    Similarity upright;
    upright.rotation = scan_axes(surface).lps_from_scan;
    upright.translation = -front_of(moved(surface.vertices, upright));
    return [this, unit, upright] {
      upright_ = upright;
      show_proposal(unit);
      update_button();
    };
  });
}

void PhotographDialog::show_proposal(const ProposedUnit& unit) {
  QString reason = core_words(unit.reason).toHtmlEscaped();
  if (!reason.isEmpty()) reason[0] = reason[0].toUpper();
  ui_->photograph_proposal_label->setText(
      unit.name.empty() ? tr("No usual unit would make it as large as a head. %1.").arg(reason)
                        : tr("Likely unit by its size: <b>%1</b>. %2.")
                              .arg(QString::fromStdString(unit.name).toHtmlEscaped(), reason));
}

void PhotographDialog::update_button() {
  const bool fits = ui_->photograph_fit_button->isChecked() && upright_;
  ui_->photograph_buttons->button(QDialogButtonBox::Ok)
      ->setEnabled(ui_->photograph_unit_box->currentIndex() > 0 &&
                   (fits || ui_->photograph_on_ct_button->isChecked()));
}

void PhotographDialog::choose() {
  const double mm = mm_of_unit.at(ui_->photograph_unit_box->currentIndex());
  const bool fits = ui_->photograph_fit_button->isChecked();
  PhotographSource photograph{obj_, fits ? *upright_ : Similarity{}};
  photograph.lps_from_photograph.scale = mm;
  photograph.lps_from_photograph.translation *= mm;
  if (fits) photograph.lps_from_photograph.translation += front_;
  emit photograph_chosen(photograph, fits);
  accept();
}

}  // namespace gnathion
