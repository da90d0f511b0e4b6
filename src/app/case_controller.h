#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/background_task.h"
#include "app/loaded_case.h"

namespace gnathion {

/// How far a segment may be moved by the window's controls, either way.
inline constexpr double largest_shift_mm = 30;
inline constexpr double largest_turn_deg = 30;

/// What follows from the segments' motions: in every frame of a drag the linear model's answer, and
/// when they rest that of the model that keeps the tolerance.
struct Response {
  std::vector<RigidMotion> poses;  ///< of the segments, LPS mm
  Points face;                     ///< n×3, mm, LPS, the predicted face
  DistanceStatistics displacement;
  std::map<std::string, LandmarkResponse> landmarks;
};

/// How far the response to the present motions is from being the prediction.
enum class Refinement {
  waiting,  ///< the motions have not rested yet
  running,  ///< beside the window
  done,     ///< the response is the prediction's
  refused,  ///< no model could follow the motions: failed() said why
  stopped,  ///< by the user
};

/// The model of the window and all that is done to it: the open case, the segments' motions, the
/// face that follows. Knows no widget. Long work runs beside it and is published here, on the
/// thread that owns this object; whoever shows the model reads it when a signal says so.
class CaseController : public QObject {
  Q_OBJECT
 public:
  explicit CaseController(QObject* parent = nullptr);
  /// Cancels opening and refining; an export that has begun is finished.
  ~CaseController() override;

  /// Opens a case beside the window. While it works, and when it fails or is cancelled, the case
  /// that is open stays as it is. Cancels an opening that is under way.
  void open_case(const std::filesystem::path& file);
  /// The embedded default case, written into `cache` first when it is not there.
  void open_demo_case(const std::filesystem::path& cache);
  /// Writes the face predicted for the present motions; ends with exported() or failed().
  /// Nothing happens while another export is under way.
  void export_face(const std::filesystem::path& folder);
  /// Cancels opening and exporting.
  void cancel();
  bool is_exporting() const { return exporting_.is_running(); }
  bool is_working() const { return opening_.is_running() || exporting_.is_running(); }

  /// Moves the active segment; values beyond largest_shift_mm and largest_turn_deg are cut to them.
  /// The response is the linear model's at once; a refinement under way is cancelled.
  /// \pre has_case(). When the model refuses the motion, failed() says why and the old one stays.
  void set_motion(const JawMotion& motion);
  /// Chooses the segment that set_motion() moves. \pre it is one of the case's.
  void set_active_segment(std::size_t segment);
  /// The quick response stays until the next motion.
  void stop_refining();

  bool has_case() const { return loaded_ != nullptr; }
  const LoadedCase& loaded() const { return *loaded_; }
  std::shared_ptr<const LoadedCase> shared_case() const { return loaded_; }
  std::size_t active_segment() const { return active_; }
  const JawMotion& motion() const { return motions_[active_]; }  ///< of the active segment
  const std::vector<JawMotion>& motions() const { return motions_; }
  const Response& response() const { return response_; }
  Refinement refinement() const { return refinement_; }
  /// Of the present motions, by the model that keeps the tolerance, checked and measured; null
  /// until the refinement is done.
  const Prediction* refined() const { return refined_.get(); }

 signals:
  void case_opened();
  void motion_changed();
  void active_segment_changed();
  void refinement_changed();
  void refinement_stage(const QString& stage);
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
  void await_rest();
  void refine();
  void publish(std::shared_ptr<const Prediction> prediction);
  void set_refinement(Refinement refinement);

  std::shared_ptr<const LoadedCase> loaded_;
  std::vector<JawMotion> motions_{1};  ///< of the segments
  std::size_t active_ = 0;
  Response response_;
  Refinement refinement_ = Refinement::waiting;
  std::shared_ptr<const Prediction> refined_;
  QTimer rest_;  ///< runs out when the motions have rested
  BackgroundTask opening_;
  BackgroundTask refining_;
  BackgroundTask exporting_;
};

}  // namespace gnathion
