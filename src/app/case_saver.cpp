#include "app/case_saver.h"

#include <QDir>
#include <QEvent>
#include <QFile>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <utility>

#include "app/case_controller.h"
#include "app/file_dialogs.h"

namespace gnathion {
namespace {

/// A name for the file of a case that has none yet.
QString suggested_name(const SurgicalCase& plan) {
  QString name = QString::fromStdString(plan.name).simplified();
  name.replace(QRegularExpression("[/\\\\:*?\"<>|]"), "_");
  return (name.isEmpty() ? QString("case") : name) + ".gnathion.json";
}

}  // namespace

CaseSaver::CaseSaver(CaseController& controller, QWidget& window)
    : controller_(controller), window_(window) {
  window_.installEventFilter(this);
}

void CaseSaver::save() {
  if (controller_.file().empty()) {
    save_as();
  } else {
    save_into(QFile::decodeName(controller_.file().c_str()));
  }
}

void CaseSaver::save_as() {
  QFileDialog* dialog = new_file_dialog(&window_, "save_dialog", tr("Save the case"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilter(tr("Case files (*.json)"));
  dialog->setDefaultSuffix("gnathion.json");
  const QString file = QFile::decodeName(controller_.file().c_str());
  dialog->setDirectory(file.isEmpty() ? QDir::homePath() : QFileInfo(file).path());
  dialog->selectFile(file.isEmpty() ? suggested_name(controller_.plan())
                                    : QFileInfo(file).fileName());
  connect(dialog, &QFileDialog::fileSelected, this, &CaseSaver::save_into);
  connect(dialog, &QFileDialog::rejected, this, [this] { after_saving_ = nullptr; });
  dialog->open();
}

void CaseSaver::save_into(const QString& file) {
  bool is_saved = false;
  const QMetaObject::Connection listener =
      connect(&controller_, &CaseController::saved, this, [&is_saved] { is_saved = true; });
  controller_.save_case(QFile::encodeName(file).toStdString());
  disconnect(listener);
  const std::function<void()> go_on = std::exchange(after_saving_, nullptr);
  if (is_saved && go_on) go_on();
}

void CaseSaver::before_leaving(std::function<void()> go_on) {
  if (!controller_.is_modified()) {
    go_on();
  } else if (question_ != nullptr) {
    question_->raise();
  } else {
    ask(std::move(go_on));
  }
}

void CaseSaver::ask(std::function<void()> go_on) {
  const QString name = QString::fromStdString(controller_.plan().name);
  question_ =
      new QMessageBox(QMessageBox::Question, tr("Changes that are not saved"),
                      name.isEmpty() ? tr("The case has changes that are not saved.")
                                     : tr("“%1” has changes that are not saved.").arg(name),
                      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
  question_->setObjectName("unsaved_box");
  question_->setAttribute(Qt::WA_DeleteOnClose);
  question_->setInformativeText(tr("Discarded changes cannot be brought back."));
  question_->setDefaultButton(QMessageBox::Save);
  question_->button(QMessageBox::Save)->setObjectName("unsaved_save_button");
  question_->button(QMessageBox::Discard)->setObjectName("unsaved_discard_button");
  question_->button(QMessageBox::Cancel)->setObjectName("unsaved_cancel_button");
  connect(question_, &QMessageBox::finished, this, [this, go_on = std::move(go_on)](int answer) {
    question_ = nullptr;
    if (answer == QMessageBox::Discard) go_on();
    if (answer != QMessageBox::Save) return;
    after_saving_ = go_on;
    save();
  });
  question_->open();
}

bool CaseSaver::eventFilter(QObject* watched, QEvent* event) {
  const bool closes = watched == &window_ && event->type() == QEvent::Close;
  if (!closes || may_close_ || !controller_.is_modified()) {
    return QObject::eventFilter(watched, event);
  }
  event->ignore();
  before_leaving([this] {
    may_close_ = true;
    window_.close();
  });
  return true;
}

}  // namespace gnathion
