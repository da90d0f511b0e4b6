#pragma once

#include <QStringList>
#include <QWidget>
#include <memory>
#include <vector>

#include "app/recovery.h"

class QListWidget;
namespace Ui {
class WelcomePage;
}

namespace gnathion {

/// What the window shows before a case is open: the ways to open one, those that were open last,
/// and those that a crash has left behind. It says what the user wants and opens nothing.
class WelcomePage : public QWidget {
  Q_OBJECT
 public:
  explicit WelcomePage(QWidget* parent = nullptr);
  ~WelcomePage() override;

  /// Absolute paths, the latest first.
  void show_recent(const QStringList& files);
  void show_left_behind(const std::vector<LeftBehind>& cases);
  /// Whether something that may be dropped hovers over the window.
  void set_drop_welcome(bool welcome);

 signals:
  void demo_wanted();
  void case_wanted();
  void dicom_folder_wanted();
  void volume_wanted();
  void recent_wanted(const QString& file);
  void forget_wanted(const QString& file);
  void clear_wanted();
  /// key: of a LeftBehind.
  void recover_wanted(const QString& key);
  void discard_wanted(const QString& key);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show_drop_frame();
  void connect_buttons();
  void connect_recent();
  void connect_left_behind();
  void update_buttons();

  std::unique_ptr<Ui::WelcomePage> ui_;
  bool drop_welcome_ = false;
};

}  // namespace gnathion
