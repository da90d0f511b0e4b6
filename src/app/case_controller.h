#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/background_task.h"
#include "app/loaded_case.h"

namespace gnathion {

/// How far a segment may be moved by the window's controls, either way.
inline constexpr double largest_shift_mm = 30;
inline constexpr double largest_turn_deg = 30;

/// Beyond this the linear model is not to be trusted; docs/evidence.md has the measurements.
inline constexpr double trusted_shift_mm = 5;
inline constexpr double trusted_turn_deg = 10;

/// What follows from the segment's motion at once, in every frame of a drag.
struct Response {
  RigidMotion pose;  ///< of the segment, LPS mm
  Points face;       ///< n×3, mm, LPS, the predicted face
  DistanceStatistics displacement;
  std::map<std::string, LandmarkResponse> landmarks;
};

/// The model of the window and all that is done to it: the open case, the segment's motion, the
/// face that follows. Knows no widget. Long work runs beside it and is published here, on the
/// thread that owns this object; whoever shows the model reads it when a signal says so.
class CaseController : public QObject {
  Q_OBJECT
 public:
  explicit CaseController(QObject* parent = nullptr);
  /// Cancels opening and checking; an export that has begun is finished.
  ~CaseController() override;

  /// Opens a case beside the window. While it works, and when it fails or is cancelled, the case
  /// that is open stays as it is. Cancels an opening that is under way.
  void open_case(const std::filesystem::path& file);
  /// The embedded default case, written into `cache` first when it is not there.
  void open_demo_case(const std::filesystem::path& cache);
  /// Writes the face predicted for the present motion; ends with exported() or failed().
  /// Nothing happens while another export is under way.
  void export_face(const std::filesystem::path& folder);
  /// Cancels opening and exporting.
  void cancel();
  bool is_exporting() const { return exporting_.is_running(); }
  bool is_working() const { return opening_.is_running() || exporting_.is_running(); }

  /// Moves the segment; values beyond largest_shift_mm and largest_turn_deg are cut to them.
  /// \pre has_case(). When the model refuses the motion, failed() says why and the old one stays.
  void set_motion(const JawMotion& motion);

  bool has_case() const { return loaded_ != nullptr; }
  const LoadedCase& loaded() const { return *loaded_; }
  const JawMotion& motion() const { return motion_; }
  const Response& response() const { return response_; }
  /// Of the present motion, checked by a direct solve and measured; null until that is done.
  const Prediction* checked() const { return checked_.get(); }
  /// The present motion is larger than the linear model is good for.
  bool is_beyond_trust() const;

 signals:
  void case_opened();
  void motion_changed();
  void checked_changed();
  void exported(const QString& folder);
  void work_began(const QString& what);
  void work_stage(const QString& stage);
  void work_ended();
  void noticed(const QString& notice);
  void failed(const gnathion::Failure& failure);

 private:
  void connect_work(BackgroundTask& task);
  void open(const QString& what, std::function<std::filesystem::path(Progress&)> case_file);
  void publish(std::shared_ptr<const LoadedCase> loaded);
  Response response_to(const LoadedCase& loaded, const JawMotion& motion) const;
  void check();

  std::shared_ptr<const LoadedCase> loaded_;
  JawMotion motion_;
  Response response_;
  std::shared_ptr<const Prediction> checked_;
  QTimer rest_;  ///< runs out when the motion has rested
  BackgroundTask opening_;
  BackgroundTask checking_;
  BackgroundTask exporting_;
};

}  // namespace gnathion
