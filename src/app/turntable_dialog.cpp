#include "app/turntable_dialog.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QPushButton>

#include "app/file_dialogs.h"
#include "ui_turntable_dialog.h"

namespace gnathion {

TurntableDialog::TurntableDialog(QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::TurntableDialog>()) {
  ui_->setupUi(this);
  ui_->buttons->button(QDialogButtonBox::Ok)->setText(tr("&Export"));
  connect(ui_->form_box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &TurntableDialog::suggest_target);
  connect(ui_->pictures_box, QOverload<int>::of(&QSpinBox::valueChanged), this,
          &TurntableDialog::check);
  connect(ui_->target_edit, &QLineEdit::textChanged, this, &TurntableDialog::check);
  connect(ui_->browse_button, &QPushButton::clicked, this, &TurntableDialog::browse);
  suggest_target();
}

TurntableDialog::~TurntableDialog() = default;

TurntableWish TurntableDialog::wish() const {
  TurntableWish wish;
  wish.show = ui_->show_box->currentIndex() == 0 ? TurntableWish::Show::before_and_predicted
                                                 : TurntableWish::Show::predicted;
  wish.form = ui_->form_box->currentIndex() == 0 ? TurntableWish::Form::film
                                                 : TurntableWish::Form::pictures;
  wish.pictures = ui_->pictures_box->value();
  wish.side = ui_->side_box->value() / 2 * 2;
  wish.target = QFile::encodeName(ui_->target_edit->text().trimmed()).toStdString();
  return wish;
}

/// The name's ending says which form it is.
void TurntableDialog::suggest_target() {
  const bool film = ui_->form_box->currentIndex() == 0;
  QString target = ui_->target_edit->text();
  if (target.isEmpty()) target = QDir::home().filePath(QStringLiteral("turning_face"));
  if (target.endsWith(QStringLiteral(".avi"))) target.chop(4);
  ui_->target_edit->setText(film ? target + QStringLiteral(".avi") : target);
  check();
}

void TurntableDialog::browse() {
  QFileDialog* dialog =
      new_target_dialog(this, "turntable_file_dialog", tr("Export the turning face"));
  if (ui_->form_box->currentIndex() == 0) {
    dialog->setNameFilter(tr("Films (*.avi)"));
    dialog->setDefaultSuffix("avi");
  }
  const QFileInfo target(ui_->target_edit->text());
  dialog->setDirectory(target.path());
  dialog->selectFile(target.fileName());
  connect(dialog, &QFileDialog::fileSelected, ui_->target_edit, &QLineEdit::setText);
  dialog->open();
}

void TurntableDialog::check() {
  const QFileInfo target(ui_->target_edit->text().trimmed());
  QString problem;
  if (target.filePath().isEmpty()) problem = tr("Say where to.");
  if (target.exists()) problem = tr("That exists already: choose another name.");
  if (problem.isEmpty() && !target.dir().exists()) problem = tr("The folder does not exist.");
  const double seconds = static_cast<double>(ui_->pictures_box->value()) / turntable_rate;
  ui_->remark_label->setText(problem.isEmpty() ? tr("One turn in %1 s, %2 pictures a second.")
                                                     .arg(QLocale().toString(seconds, 'f', 1))
                                                     .arg(turntable_rate)
                                               : problem);
  ui_->buttons->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
}

}  // namespace gnathion
