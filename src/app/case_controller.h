#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/background_task.h"
#include "app/loaded_case.h"

namespace gnathion {

/// How far a segment may be moved by the window's controls, either way.
inline constexpr double largest_shift_mm = 30;
inline constexpr double largest_turn_deg = 30;

/// What follows from the segments' motions: in every frame of a drag the answer of a model that is
/// linear in them, and when they rest that of the model that keeps the tolerance.
struct Response {
  std::vector<RigidMotion> poses;  ///< of the segments, LPS mm
  Points face;                     ///< n×3, mm, LPS, the predicted face; at rest without a model
  DistanceStatistics displacement;
  std::map<std::string, LandmarkResponse> landmarks;
};

/// How far the response to the present motions is from being the prediction.
enum class Refinement {
  none,     ///< there is no model: nothing to refine
  waiting,  ///< the motions have not rested yet
  running,  ///< beside the window
  done,     ///< the response is the prediction's
  refused,  ///< no model could follow the motions: failed() said why
  stopped,  ///< by the user
};

/// The model of the window and all that is done to it: the open case with its history, what was
/// computed from it, the segments' motions, the face that follows. Knows no widget. Long work runs
/// beside it and is published here, on the thread that owns this object; whoever shows the model
/// reads it when a signal says so.
class CaseController : public QObject {
  Q_OBJECT
 public:
  explicit CaseController(QObject* parent = nullptr);
  /// Cancels all work; an export that has begun is finished.
  ~CaseController() override;

  /// Opens a case beside the window, with its history. While it works, and when it fails or is
  /// cancelled, the case that is open stays as it is. Cancels an opening that is under way.
  void open_case(const std::filesystem::path& file);
  /// The embedded default case, written into `cache` first when it is not there.
  void open_demo_case(const std::filesystem::path& cache);
  /// A new case from images, its skin the face. Likewise beside the window.
  void import_ct(const CtSource& ct);
  /// What was left behind by a window that ended badly (app/recovery.h): opened as not saved.
  void recover_case(const std::filesystem::path& file, const std::filesystem::path& saved_as);
  /// Writes the case with its history; saved() or failed() follows at once. Images that lie in the
  /// demo case's cache, where they may be removed, are copied beside the file first, into a new
  /// folder named after it.
  void save_case(const std::filesystem::path& file);
  /// Writes the face predicted for the present motions into a new folder, as "obj", "glb" or "ply"
  /// (export_prediction()); ends with exported() or failed().
  /// Nothing happens while another export is under way. \pre has_model()
  void export_face(const std::filesystem::path& folder, const std::string& format = "obj");
  /// Cancels opening, editing and exporting.
  void cancel();
  bool is_exporting() const { return exporting_.is_running(); }
  bool is_editing() const { return editing_.is_running(); }
  bool is_working() const { return opening_.is_running() || is_editing() || is_exporting(); }

  /// The plan as it was last edited, also while what follows from that is still computed.
  const SurgicalCase& plan() const { return history().plan(); }
  /// A named step of the history. What follows from the plan is computed beside the window, then
  /// case_changed() tells. When it cannot be (the saw separates nothing), failed() says why and the
  /// step is taken back. A later edit takes an unfinished one along. \pre has_case()
  void edit(const QString& step, SurgicalCase plan);
  void undo();  ///< nothing when there is nothing to undo
  void redo();
  const PlanHistory& history() const {
    return pending_ ? *pending_ : *history_;
  }  ///< \pre has_case
  /// Whether the plan differs from what is on disk.
  bool is_modified() const;
  const std::filesystem::path& file() const { return file_; }  ///< empty: not saved yet

  /// Moves the active segment; values beyond largest_shift_mm and largest_turn_deg are cut to them.
  /// The response is the linear model's at once; a refinement under way is cancelled. It becomes a
  /// step of the history when the motion rests, with all that came before it since the last rest.
  /// \pre has_segments(). When the model refuses the motion, failed() says why and the old one
  /// stays.
  void set_motion(const JawMotion& motion);
  /// While held, as by a mouse that drags, a motion makes no step however long it rests.
  void hold_motion(bool held);
  /// Chooses the segment that set_motion() moves. \pre it is one of the case's.
  void set_active_segment(std::size_t segment);
  /// The quick response stays until the next motion.
  void stop_refining();

  bool has_case() const { return loaded_ != nullptr; }
  bool has_segments() const { return has_case() && !loaded_->anatomy->segments.empty(); }
  bool has_model() const { return has_case() && loaded_->model != nullptr; }
  const LoadedCase& loaded() const { return *loaded_; }
  std::shared_ptr<const LoadedCase> shared_case() const { return loaded_; }
  std::size_t active_segment() const { return active_; }
  const JawMotion& motion() const { return motions_[active_]; }  ///< \pre has_segments()
  const std::vector<JawMotion>& motions() const { return motions_; }
  const Response& response() const { return response_; }
  Refinement refinement() const { return refinement_; }
  /// The model that answers while dragging: on quadratic elements once they are ready.
  const FaceModel& quick_model() const { return sharp_ ? *sharp_ : *loaded_->model; }
  /// Of the present motions, by the model that keeps the tolerance, checked and measured; null
  /// until the refinement is done.
  const Prediction* refined() const { return refined_.get(); }
  std::shared_ptr<const Prediction> shared_prediction() const { return refined_; }

 signals:
  void case_opened();   ///< another case
  void case_changed();  ///< the same case after an edit, an undo or a redo of more than motions
  void history_changed();
  void motion_changed();
  void active_segment_changed();
  void refinement_changed();
  void refinement_stage(const QString& stage);
  void saved(const QString& file);
  void exported(const QString& folder);
  void work_began(const QString& what);
  void work_stage(const QString& stage);
  void work_ended();
  void noticed(const QString& notice);
  void failed(const gnathion::Failure& failure);

 private:
  struct Opened;
  void connect_work(BackgroundTask& task);
  void open(const QString& what, std::function<Opened(Progress&)> read);
  void publish(const Opened& opened);
  void take(std::shared_ptr<const LoadedCase> loaded, std::vector<JawMotion> motions);
  void go_to(PlanHistory history);
  void finish_edit(std::shared_ptr<const LoadedCase> loaded);
  void take_back_edit();
  void commit_motion();
  SurgicalCase plan_with_motions() const;
  SurgicalCase shown_plan() const;
  void keep_demo_images(const std::filesystem::path& file);
  void await_rest();
  void rest();
  void sharpen();
  void refine();
  void publish(std::shared_ptr<const Prediction> prediction);
  void set_refinement(Refinement refinement);

  std::shared_ptr<const LoadedCase> loaded_;
  std::optional<PlanHistory> history_;  ///< of what is shown
  std::optional<PlanHistory> pending_;  ///< with the edit that is being computed
  std::shared_ptr<const SurgicalCase> saved_plan_;
  std::filesystem::path file_;
  std::filesystem::path demo_cache_;  ///< what lies in it is not the user's to keep
  std::vector<JawMotion> motions_;    ///< of the segments
  std::size_t active_ = 0;
  bool held_ = false;
  Response response_;
  Refinement refinement_ = Refinement::none;
  std::shared_ptr<const FaceModel> sharp_;  ///< on quadratic elements; null: not ready
  std::shared_ptr<const Prediction> refined_;
  QTimer rest_;  ///< runs out when the motions have rested
  BackgroundTask opening_;
  BackgroundTask editing_;
  BackgroundTask sharpening_;
  BackgroundTask refining_;
  BackgroundTask exporting_;
};

}  // namespace gnathion
