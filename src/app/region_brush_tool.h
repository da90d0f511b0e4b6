#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/painted_surface.h"
#include "app/view_tool.h"
#include "geometry/bsp_tree.h"
#include "geometry/rigid_motion.h"

namespace gnathion {

class FaceView;
class RegionOverlay;

/// What the mouse does while the brush is in the hand.
enum class BrushMode { off, paint, erase };

/// The brush in the 3D view: the left button paints along the mouse's way, Shift turns painting
/// into erasing and erasing into painting, Ctrl with the wheel changes the radius, Escape drops the
/// stroke. The camera turns where a press misses the face.
class RegionBrushTool : public QObject, public ViewTool {
  Q_OBJECT
 public:
  static constexpr double least_radius = 1;     ///< mm
  static constexpr double largest_radius = 40;  ///< mm

  /// All must outlive the tool.
  RegionBrushTool(FaceView& view, PaintedSurface& surface, RegionOverlay& overlay,
                  QObject* parent = nullptr);

  void set_mode(BrushMode mode) { mode_ = mode; }
  double radius() const { return radius_; }
  /// mm, cut to its limits.
  void set_radius(double mm);
  /// The face as it is shown, n×3, mm, LPS: rays are cast at it from the next press on.
  void set_points(const Points& points);
  /// The same where a tree of the surface is made already; `lps_from_tree`: from its frame.
  void set_points(const Points& points, std::shared_ptr<const BspTree> tree,
                  const Similarity& lps_from_tree);

  bool pressed(const ViewPoint& at) override;
  void dragged(const ViewPoint& at) override;
  void released(const ViewPoint& at) override;
  void hovered(const ViewPoint& at) override;
  void left() override;

 signals:
  void radius_changed(double mm);
  void stroke_began();
  void stroke_ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Hit {
    SurfacePoint on;
    Eigen::Vector3d place;  ///< of the face as it is shown
  };
  std::optional<Hit> hit(const ViewPoint& at);
  bool erases(const ViewPoint& at) const;
  void stamp_to(const ViewPoint& at);
  void show_cursor(const std::optional<Hit>& at, bool erasing);
  Points cursor_at(const Hit& at) const;

  FaceView& view_;
  PaintedSurface& surface_;
  RegionOverlay& overlay_;
  BrushMode mode_ = BrushMode::off;
  double radius_ = 10;
  Points points_;
  std::shared_ptr<const BspTree> tree_;  ///< of the face as it is shown; null: to be made anew
  Similarity lps_from_tree_;
  std::optional<ViewPoint> last_;
  std::optional<Eigen::Vector3d> last_place_;
  bool stroke_erases_ = false;
};

}  // namespace gnathion
