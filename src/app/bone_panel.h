#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <memory>

#include "app/cut_editor.h"
#include "app/level_preview.h"

class QDoubleSpinBox;
class QTableWidgetItem;
namespace Ui {
class BonePanel;
}

namespace gnathion {

class CaseController;
class FaceView;

/// The step "Bone": the level of the bone's surface, the segments, and the cuts that make them.
class BonePanel : public QWidget {
  Q_OBJECT
 public:
  /// Both must outlive the panel.
  BonePanel(CaseController& controller, FaceView& view, QWidget* parent = nullptr);
  ~BonePanel() override;

  /// Called when the step is chosen, and when another is: what the panel adds to the view is there
  /// meanwhile only.
  void set_active(bool active);

 signals:
  void failed(const gnathion::Failure& failure);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void connect_level();
  void connect_segments();
  void connect_cut();
  void show_case();
  void show_level_of_plan();
  void show_level(int hu);
  void choose_level(int hu);
  void take_level();
  void show_segments();
  void segment_edited(QTableWidgetItem* item);
  void remove_segment();
  int chosen_segment() const;
  void show_cut();
  void show_cut_numbers();
  void show_result();
  void place_cut();
  void size_cut();
  void update_enabled();
  void show_failure(const Failure& failure);

  std::unique_ptr<Ui::BonePanel> ui_;
  CaseController& controller_;
  FaceView& view_;
  bool active_ = false;
  std::array<QDoubleSpinBox*, 6> place_boxes_;  ///< in the order of JawMotion's members
  std::array<QDoubleSpinBox*, 3> size_boxes_;   ///< in the order of box_of()'s half extents
  QTimer level_rest_;  ///< runs out when a level typed or stepped to has rested
  LevelPreview level_;
  CutEditor editor_;
};

}  // namespace gnathion
