#pragma once

#include <QObject>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/background_task.h"
#include "app/case_controller.h"
#include "geometry/bsp_tree.h"
#include "registration/registration.h"
#include "tissue/region_shape.h"

namespace gnathion {

/// A place of the photograph and how well it lies on the CT's skin there.
struct Placement {
  Similarity lps_from_photograph;
  bool is_measured = false;  ///< quality and distance_mm are known
  RegistrationQuality quality = {};
  Eigen::VectorXd distance_mm = {};  ///< n, of its vertices above the skin; NaN where it is far
  bool is_fitted = false;            ///< by shape: convergence and doubts say something
  std::vector<RegistrationDoubt> doubts = {};
};

/// What the landmarks are picked on.
enum class PickedSurface { photograph, ct };

/// A place of the face, as far as it is picked.
struct PickedLandmark {
  std::string name;  ///< for files: "nose_tip"
  PickedPlace at;
};

/// Which part of the photograph decides a fit: what is painted as stable, or else the upper face
/// that is proposed; or all of it.
enum class FitRegion { stable, whole };

/// Where the photograph lies on the CT: the plan's place, and a proposal that the user takes or
/// leaves. Fits and measures beside the window; knows no widget. Lives on the window's thread.
class RegistrationEditor : public QObject {
  Q_OBJECT
 public:
  /// The controller must outlive the editor.
  explicit RegistrationEditor(CaseController& controller, QObject* parent = nullptr);

  /// While active the present place is measured; when not, nothing is computed.
  void set_active(bool active);
  /// Takes over what the plan says: another place drops the proposal.
  void take_plan();
  /// Whether the case's face is a photograph: all that follows needs one.
  bool has_photograph() const { return photograph_ != nullptr; }
  /// Own frame and unit.
  const TriangleMesh& photograph() const;
  /// Null until it is computed.
  const TriangleMesh* skin() const { return skin_ ? &skin_->mesh : nullptr; }
  /// The photograph in its own frame, made ready for a brush and for rays; null until then.
  std::shared_ptr<const SurfaceBrush> brush() const { return brush_; }
  std::shared_ptr<const BspTree> photograph_tree() const { return photograph_tree_; }
  /// Flags of forehead and bridge of the nose where the photograph is shown; empty: not known yet.
  Selection proposed_region() const;

  const Placement& present() const { return present_; }
  const Placement* proposal() const { return proposal_ ? &*proposal_ : nullptr; }
  const Placement& shown() const { return proposal_ ? *proposal_ : present_; }
  bool is_fitting() const { return fitting_.is_running(); }
  bool is_measuring() const { return measuring_.is_running(); }

  /// Each ends with changed() and a proposal, or with failed(), when nothing has changed.
  /// region: stable: what is painted; nothing is proposed before the place is known.
  void fit_automatically(FitRegion region, bool scale);
  /// \pre three landmarks are complete
  void fit_to_landmarks(bool scale);
  /// From the place that is shown.
  void refine(FitRegion region, bool scale);
  /// The place since the last fit moved by hand, about the photograph's middle.
  void set_nudge(const JawMotion& nudge);
  const JawMotion& nudge() const { return nudge_; }
  /// The proposal as a step of the history; it stays until the step is made.
  void accept();
  void reject();
  void cancel();

  const std::vector<PickedLandmark>& landmarks() const { return landmarks_; }
  /// The known ones in their order, then what else the case names. A place that is set is a step
  /// of the history with keep_landmarks() only: a drag sets many.
  void set_landmark(std::size_t landmark, PickedSurface on, const Eigen::Vector3d& lps);
  void keep_landmarks() { keep_landmarks(tr("Pick a landmark")); }
  void clear_landmark(std::size_t landmark);
  std::size_t complete_landmarks() const { return pairs().size(); }
  /// mm, of the complete ones, where the photograph is shown; before: where the last fit began.
  std::map<std::string, double> residuals() const;
  std::map<std::string, double> residuals_before() const;
  /// Where the line meets the surface first, mm, LPS; the photograph where it is shown.
  std::optional<Eigen::Vector3d> place_in_sight(PickedSurface on, const Eigen::Vector3d& eye,
                                                const Eigen::Vector3d& direction) const;

 signals:
  void changed();
  void landmarks_changed();  ///< nothing else has
  void fit_began();
  void stage_began(const QString& stage);
  void failed(const gnathion::Failure& failure);

 private:
  struct Skin {
    explicit Skin(TriangleMesh surface);
    TriangleMesh mesh;
    SkinTarget target;
    BspTree tree;
  };
  struct Job;
  using Fit = std::function<Registration(const Job&, Progress&)>;
  Job job() const;
  void keep(const Job& job);
  void start(Fit fit);
  void measure();
  void propose(Placement placement);
  std::vector<LandmarkPair> pairs() const;
  void take_landmarks();
  void keep_landmarks(const QString& step);
  const PhotographSource* planned() const;
  std::vector<bool> painted_flags() const;
  void drop_proposal();

  CaseController& controller_;
  bool active_ = false;
  std::shared_ptr<const LoadedCase> photograph_;    ///< the case that it was taken from, or null
  std::shared_ptr<const BspTree> photograph_tree_;  ///< own frame; null: not made yet
  std::shared_ptr<const SurfaceBrush> brush_;       ///< likewise
  std::shared_ptr<const CtVolume> ct_;
  SkinSurfaceOptions skin_options_;
  std::shared_ptr<const Skin> skin_;  ///< of `ct_` by `skin_options_`; null: not made yet
  Placement present_;
  std::optional<Placement> proposal_;
  Similarity before_;      ///< where the last fit began
  Similarity nudge_base_;  ///< where the nudge begins
  JawMotion nudge_;
  std::vector<PickedLandmark> landmarks_;
  BackgroundTask measuring_;  // last: their workers stop first
  BackgroundTask fitting_;
};

}  // namespace gnathion
