#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "app/case_controller.h"
#include "app/painted_surface.h"
#include "tissue/region_shape.h"

namespace gnathion {

/// The stable region of the photograph as it is being painted: the vertices that decide a fit. It
/// begins as the proposed one; a stroke changes what is shown at once, and the plan, as one step,
/// when it ends. Knows no widget. Lives on the window's thread.
class StableRegionEditor : public QObject, public PaintedSurface {
  Q_OBJECT
 public:
  /// The controller must outlive the editor.
  explicit StableRegionEditor(CaseController& controller, QObject* parent = nullptr);

  /// What is painted on: the photograph in its own frame, the millimetres in its unit where it is
  /// shown, and the region that is proposed there (a flag a vertex; empty: not known yet). brush:
  /// null: there is none yet. A stroke goes on unless the photograph is another.
  void set_photograph(std::shared_ptr<const SurfaceBrush> brush, double mm_per_unit,
                      const Selection& proposed);
  /// Takes over what the plan says, unless a stroke is being painted.
  void take_plan();

  /// Whether the plan says which; otherwise it is the proposed one.
  bool is_painted() const { return !planned().empty(); }
  const Selection& region() const { return region_; }
  const RegionOutline& outline() const { return outline_; }
  double area_cm2() const { return outline_.area_mm2 * mm_per_unit_ * mm_per_unit_ / 100; }
  /// The proposed one again, as a step.
  void take_proposal();

  const TriangleMesh* surface() const override;
  std::vector<std::array<EdgePoint, 2>> circle(const SurfacePoint& centre,
                                               double radius) const override;
  bool is_stroke() const override { return stroke_; }
  void begin_stroke(bool erases) override;
  void stamp(const SurfacePoint& at, double radius) override;
  /// Where nothing is left the proposed region is taken again.
  void end_stroke() override;
  void drop_stroke() override;

 signals:
  void changed();

 private:
  std::vector<int> planned() const;
  void show_outline();
  void commit(const QString& step, std::vector<int> vertices);

  CaseController& controller_;
  std::shared_ptr<const SurfaceBrush> brush_;
  double mm_per_unit_ = 1;
  Selection proposed_;
  Selection region_;
  RegionOutline outline_;
  bool stroke_ = false;
  bool erases_ = false;
  QTimer outline_timer_;  ///< many stamps in one turn of the event loop: one outline
};

}  // namespace gnathion
