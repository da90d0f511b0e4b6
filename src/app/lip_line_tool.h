#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "app/region_editor.h"
#include "app/view_tool.h"
#include "geometry/bsp_tree.h"
#include "render/skin_line.h"

namespace gnathion {

class FaceView;

/// The line between the lips in the 3D view: shown as the plan has it, and traced with clicks from
/// corner to corner. Enter ends the line, Backspace takes the last click back, Escape drops the
/// line. The camera turns where a press misses the face. Each change of the plan is one step.
class LipLineTool : public QObject, public ViewTool {
  Q_OBJECT
 public:
  /// All must outlive the tool.
  LipLineTool(CaseController& controller, FaceView& view, RegionEditor& editor,
              QObject* parent = nullptr);

  /// Whether the line is drawn.
  void set_active(bool active);
  /// The face as it is shown, n×3, mm, LPS.
  void set_points(const Points& points);
  /// Draws the plan's line. \pre the editor has taken over the plan
  void take_plan();

  bool is_tracing() const { return tracing_; }
  int traced_count() const { return static_cast<int>(traced_.size()); }
  void begin();
  /// Takes the traced points as the plan's line when they are two or more.
  void finish();
  void drop();
  /// Looks for the line in the face's shape. noticed() of the controller says what is doubtful.
  void propose();
  void remove();

  bool pressed(const ViewPoint& at) override;
  void dragged(const ViewPoint&) override {}
  void released(const ViewPoint&) override {}
  void hovered(const ViewPoint&) override {}

 signals:
  void tracing_changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::optional<SurfacePoint> hit(const ViewPoint& at);
  void set_plan_line(const QString& step, std::vector<Eigen::Vector3d> line);
  void end_tracing();
  void tie_line();
  void draw();

  CaseController& controller_;
  FaceView& view_;
  RegionEditor& editor_;
  SkinLine mark_;
  bool active_ = false;
  bool tracing_ = false;
  Points points_;
  std::optional<BspTree> shown_tree_;        ///< of the face as it is shown; none: to be made anew
  std::optional<BspTree> rest_tree_;         ///< of the face at rest, likewise
  const SurfaceBrush* rest_face_ = nullptr;  ///< whose tree that is
  std::vector<SurfacePoint> traced_;
  std::vector<SurfacePoint> line_, knobs_;  ///< what is drawn, tied to the face
};

}  // namespace gnathion
