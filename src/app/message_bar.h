#pragma once

#include <QFrame>
#include <memory>

#include "app/background_task.h"

namespace Ui {
class MessageBar;
}
class QScrollArea;

namespace gnathion {

/// A message above the view that stays until it is closed or another takes its place: it stops
/// nobody's work.
class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);
  ~MessageBar() override;

  void show_failure(const Failure& failure);
  void show_notice(const QString& title, const QString& text);
  /// Below the notices that are shown under the same title already, or as show_notice.
  void add_notice(const QString& title, const QString& text);

 private:
  void show_text(const QString& colour, const QString& title, const QString& text,
                 const QString& remedy);

  std::unique_ptr<Ui::MessageBar> ui_;
  QScrollArea* text_area_;
};

}  // namespace gnathion
