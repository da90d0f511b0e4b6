#pragma once

#include <QObject>
#include <QString>
#include <functional>

class QMessageBox;
class QWidget;

namespace gnathion {

class CaseController;

/// How a case leaves the window: saved, saved as, and the question what is to become of changes
/// that are not saved, before another case takes its place and before the window closes.
class CaseSaver : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this. Watches the closing of `window`.
  CaseSaver(CaseController& controller, QWidget& window);

  /// Into the case's file; of a case without one, as save_as().
  void save();
  /// Asks for the file first.
  void save_as();
  /// Calls `go_on` at once where nothing would be lost; otherwise when the user has saved or
  /// discarded the changes, and never when he cancels or saving fails.
  void before_leaving(std::function<void()> go_on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void ask(std::function<void()> go_on);
  void save_into(const QString& file);

  CaseController& controller_;
  QWidget& window_;
  QMessageBox* question_ = nullptr;     ///< null: none is open
  std::function<void()> after_saving_;  ///< empty: nothing waits for it
  bool may_close_ = false;
};

}  // namespace gnathion
