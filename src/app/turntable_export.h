#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/case_controller.h"

namespace gnathion {

/// A film, or its pictures, of the face turning once round its vertical axis.
struct TurntableWish {
  enum class Form { film, pictures };
  enum class Show { predicted, before_and_predicted };
  Show show = Show::before_and_predicted;
  Form form = Form::film;
  int pictures = 96;               ///< of the whole turn
  int side = 720;                  ///< pixels of a face's picture, each way; even
  std::vector<std::string> bones;  ///< of the view's scene that are shown behind the face
  bool textured = true;            ///< the photograph on the face
  std::filesystem::path target;    ///< a file (.avi) or a folder, not there yet
};
inline constexpr int turntable_rate = 24;  ///< pictures a second

/// Draws a turntable picture by picture, one in each turn of the event loop, so that the window
/// goes on, and writes it: whole or, when cancelled or failed, not at all.
class TurntableExport : public QObject {
  Q_OBJECT
 public:
  explicit TurntableExport(QObject* parent = nullptr);
  ~TurntableExport() override;

  /// caption, before_caption: in the pictures. Nothing while another is drawn. What it shows is
  /// copied: the window may go on with another motion. Ends with finished(), cancelled() or
  /// failed().
  void start(const std::shared_ptr<const LoadedCase>& loaded, const Response& response,
             const QString& caption, const TurntableWish& wish);
  void cancel();
  bool is_running() const { return work_ != nullptr; }

 signals:
  void picture_written(int count);
  void finished(const QString& target);
  void cancelled();
  void failed(const gnathion::Failure& failure);

 private:
  struct Work;
  void step();

  std::unique_ptr<Work> work_;  ///< null: nothing is drawn
  QTimer turn_;
};

}  // namespace gnathion
