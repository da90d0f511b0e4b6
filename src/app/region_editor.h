#pragma once

#include <QObject>
#include <array>
#include <memory>
#include <vector>

#include "app/background_task.h"
#include "app/case_controller.h"
#include "app/painted_surface.h"
#include "tissue/face_symmetry.h"
#include "tissue/region_shape.h"

namespace gnathion {

/// What the brush paints.
enum class BrushTarget {
  region,   ///< the part of the face that may deform
  sliding,  ///< where the tissue slides over the bone: mucosa over teeth and gums
};

/// The region of the open case as it is being painted: a stroke changes what is shown at once, and
/// the plan, as one step, when it ends. Knows no widget. Lives on the window's thread.
class RegionEditor : public QObject, public PaintedSurface {
  Q_OBJECT
 public:
  /// The controller must outlive the editor.
  explicit RegionEditor(CaseController& controller, QObject* parent = nullptr);

  /// Takes over what the plan says, unless a stroke is being painted. Makes a new face ready for
  /// the brush: about 0.2 s for 100 000 triangles. \pre has_case()
  void take_plan();
  /// false: nothing was taken over yet.
  bool has_face() const { return brush_ != nullptr; }
  /// Whether the suggested region is known; strokes begin on it. false: it is being computed.
  bool is_known() const { return known_; }

  const SurfaceBrush& brush() const { return *brush_; }  ///< \pre has_face()
  const Selection& region() const { return region_; }
  const Selection& sliding() const { return sliding_; }
  const RegionOutline& outline() const { return outline_; }
  const RegionOutline& sliding_outline() const { return sliding_outline_; }
  /// As of the last stroke that ended.
  const std::vector<RegionFault>& faults() const { return faults_; }
  bool is_stroke() const override { return stroke_; }
  /// Null also while the suggested region is not known: strokes begin on it.
  const TriangleMesh* surface() const override;
  std::vector<std::array<EdgePoint, 2>> circle(const SurfacePoint& centre,
                                               double radius) const override;
  bool is_mirroring() const { return mirroring_.is_running(); }

  /// \pre has_face() for all that follow
  /// What the next stroke paints.
  void set_target(BrushTarget target) { target_ = target; }
  void begin_stroke(bool erases) override;
  /// Skin hidden in a pocket, as within the mouth, is not painted.
  void stamp(const SurfacePoint& at, double radius) override;
  void end_stroke() override;
  void drop_stroke() override;

  void grow(double mm);
  void shrink(double mm);
  void smooth(double mm);
  /// Keeps the largest piece, fills holes of less than 2 cm².
  void tidy();
  void clear();
  /// Within `reach` mm of the segments, computed beside the window.
  void suggest(double reach);
  /// Adds the mirror image. Beside the window; mirrored() or failed() follows.
  void mirror();

 signals:
  void changed();         ///< region, sliding area or their outlines
  void faults_changed();  ///< faults() or is_known()
  void mirroring_changed();
  /// error_mm: mean distance of the mirrored face from the face.
  void mirrored(double error_mm);
  void failed(const gnathion::Failure& failure);

 private:
  bool same_face(const TriangleMesh& face) const;
  void set_face(const TriangleMesh& face);
  Selection region_of_plan() const;
  bool is_suggestion_awaited() const;
  bool is_hidden(int vertex);
  void set_region(const Selection& region, const QString& step);
  void commit(const QString& step);
  void outline_again();

  CaseController& controller_;
  std::shared_ptr<const SurfaceBrush> brush_;
  std::shared_ptr<const PocketSearch> pockets_;
  enum class Depth : unsigned char { unknown, open, hidden };
  std::vector<Depth> depth_;  ///< of the face's vertices, asked when first painted
  Selection region_, sliding_;
  RegionOutline outline_, sliding_outline_;
  std::vector<RegionFault> faults_;
  bool known_ = false;
  bool stroke_ = false;
  bool erases_ = false;
  BrushTarget target_ = BrushTarget::region;   ///< of the next stroke
  BrushTarget painted_ = BrushTarget::region;  ///< of the present one
  BackgroundTask mirroring_;                   // last: its worker stops first
};

}  // namespace gnathion
