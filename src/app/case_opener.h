#pragma once

#include <QObject>
#include <QString>
#include <filesystem>

#include "app/background_task.h"

class QMimeData;
class QWidget;

namespace gnathion {

class CaseController;
class CaseSaver;
class RecentCases;

/// How a case comes into the window: chosen in a dialog, from the list of recent ones, or dropped
/// anywhere on the window. Asks first where changes of the open case would be lost.
class CaseOpener : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this. Watches what is dropped on `window`.
  CaseOpener(CaseController& controller, CaseSaver& saver, RecentCases& recent, QWidget& window);

  void ask_case();
  void ask_dicom_folder();
  void ask_volume();
  void ask_photograph_file();
  void open_demo();
  /// A file or folder of any kind that Gnathion knows (io/input_kind.h); failed() for others.
  void take(const QString& path);
  /// In the user's cache folder, where it may be removed at any time.
  static std::filesystem::path demo_cache();

 signals:
  void failed(const gnathion::Failure& failure);
  /// Its step has begun. to_be_fitted: the user says that it does not lie on the CT yet.
  void photograph_added(const std::filesystem::path& file, bool to_be_fitted);
  /// Something that may be dropped has come over the window, or has left it.
  void drop_hovers(bool hovers);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void take_path(const std::filesystem::path& path);
  void list_series(const std::filesystem::path& folder);
  void ask_photograph(const std::filesystem::path& obj);
  void drop(const QMimeData& data);

  CaseController& controller_;
  CaseSaver& saver_;
  RecentCases& recent_;
  QWidget& window_;
};

}  // namespace gnathion
