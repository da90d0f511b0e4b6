#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <filesystem>
#include <memory>

#include "app/landmark_tool.h"
#include "app/region_brush_tool.h"
#include "app/registration_brush.h"
#include "app/registration_editor.h"
#include "render/landmark_marks.h"
#include "render/region_overlay.h"
#include "render/skin_layer.h"

class QDoubleSpinBox;
namespace Ui {
class RegistrationPanel;
}

namespace gnathion {

class FaceView;
class PhotographsDialog;

/// The step "Photograph": which photograph is the face, and where it lies on the CT.
class RegistrationPanel : public QWidget {
  Q_OBJECT
 public:
  /// Both must outlive the panel.
  RegistrationPanel(CaseController& controller, FaceView& view, QWidget* parent = nullptr);
  ~RegistrationPanel() override;

  /// Called when the step is chosen, and when another is: what the panel adds to the view is there
  /// meanwhile only.
  void set_active(bool active);
  /// When the photograph that is being added from this file is there, it is fitted at once.
  void fit_when_added(const std::filesystem::path& photograph) { fit_next_ = photograph; }

  const RegistrationEditor& editor() const { return editor_; }
  const StableRegionEditor& stable_region() const { return stable_; }

 signals:
  void photograph_wanted();  ///< a file is to be chosen
  void fit_began();
  void failed(const gnathion::Failure& failure);

 private:
  enum class Show { photograph, ct, both };
  void set_up_tables();
  QStringList landmark_names() const;
  void connect_buttons();
  void connect_landmarks();
  void connect_stable_region();
  void connect_nudge();
  FitRegion fit_region() const;
  void set_brush(BrushMode mode);
  void show_surfaces(Show show);
  void choose_landmark(int row);
  void choose_next_landmark();
  void use_skin();
  void show_soon();
  void show_state();
  void fit_awaited();
  void show_place();
  void show_quality();
  void show_doubts();
  void show_landmarks();
  void show_nudge();
  void show_scene();
  void show_stable_region();
  void show_stable_outline();
  void show_marks();
  void show_tool();
  void begin_scene();
  void end_scene();
  void set_bones_drawn(bool drawn);
  void update_enabled();
  QString caption() const;

  std::unique_ptr<Ui::RegistrationPanel> ui_;
  CaseController& controller_;
  FaceView& view_;
  RegistrationEditor editor_;
  LandmarkTool tool_;
  StableRegionEditor stable_;
  RegionOverlay overlay_;
  RegionBrushTool brush_;
  BrushMode brush_mode_ = BrushMode::off;
  SkinLayer skin_;
  LandmarkMarks marks_;
  const TriangleMesh* shown_skin_ = nullptr;     ///< which the layer has
  std::shared_ptr<const SurfaceBrush> painted_;  ///< whose surface the overlay has
  Similarity painted_place_;                     ///< where the overlay has it
  std::array<QDoubleSpinBox*, 6> nudge_boxes_;   ///< in the order of JawMotion's members
  QTimer show_timer_;  ///< many changes in one turn of the event loop are shown once
  Show show_ = Show::both;
  PhotographsDialog* photographs_;  ///< a window of its own, owned by Qt
  bool active_ = false;
  bool has_scene_ = false;  ///< the view shows the photograph for this step
  std::filesystem::path fit_next_;
};

}  // namespace gnathion
