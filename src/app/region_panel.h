#pragma once

#include <QWidget>
#include <memory>

#include "app/lip_line_tool.h"
#include "app/region_brush_tool.h"
#include "app/region_editor.h"
#include "render/region_overlay.h"

class QShortcut;

namespace Ui {
class RegionPanel;
}

namespace gnathion {

class CaseController;
class FaceView;

/// The step "Region": the part of the face that may deform, painted with a brush.
class RegionPanel : public QWidget {
  Q_OBJECT
 public:
  /// Both must outlive the panel.
  RegionPanel(CaseController& controller, FaceView& view, QWidget* parent = nullptr);
  ~RegionPanel() override;

  /// Called when the step is chosen, and when another is: what the panel adds to the view is there
  /// meanwhile only.
  void set_active(bool active);

  const RegionEditor& editor() const { return editor_; }
  const LipLineTool& lips() const { return lips_; }

 private:
  void connect_brush();
  void connect_stroke();
  void connect_changes();
  void connect_lips();
  void connect_model();
  void set_mode(BrushMode mode);
  void take_plan();
  void show_outline();
  QString state_words(bool& is_wrong) const;
  void show_state();
  void show_lips();
  void show_supports();
  void show_points();
  void update_enabled();
  bool is_model_current() const;

  std::unique_ptr<Ui::RegionPanel> ui_;
  CaseController& controller_;
  FaceView& view_;
  RegionEditor editor_;
  RegionOverlay overlay_;
  RegionBrushTool tool_;
  LipLineTool lips_;
  const SurfaceBrush* shown_face_ = nullptr;  ///< whose face the overlay has
  bool active_ = false;
  BrushMode mode_ = BrushMode::off;
  std::vector<QShortcut*> shortcuts_;
};

}  // namespace gnathion
