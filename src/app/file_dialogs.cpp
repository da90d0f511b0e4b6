#include "app/file_dialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>

namespace gnathion {

QFileDialog* new_file_dialog(QWidget* parent, const char* name, const QString& title) {
  auto* dialog = new QFileDialog(parent, title);
  dialog->setObjectName(name);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  return dialog;
}

QFileDialog* new_target_dialog(QWidget* parent, const char* name, const QString& title) {
  QFileDialog* dialog = new_file_dialog(parent, name, title);
  dialog->setOption(QFileDialog::DontConfirmOverwrite);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setFileMode(QFileDialog::AnyFile);
  return dialog;
}

QFileDialog* new_folder_dialog(QWidget* parent, const char* name, const QString& title,
                               const QString& suggested) {
  QFileDialog* dialog = new_target_dialog(parent, name, title);
  dialog->setLabelText(QFileDialog::FileName,
                       QCoreApplication::translate("gnathion::FileDialogs", "New folder:"));
  dialog->setLabelText(QFileDialog::Accept,
                       QCoreApplication::translate("gnathion::FileDialogs", "Export"));
  dialog->setDirectory(QDir::homePath());
  dialog->selectFile(suggested);
  return dialog;
}

}  // namespace gnathion
