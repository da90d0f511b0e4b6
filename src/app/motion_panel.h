#pragma once

#include <QStringList>
#include <QWidget>
#include <array>
#include <memory>

#include "app/case_controller.h"

class QDoubleSpinBox;
namespace Ui {
class MotionPanel;
}

namespace gnathion {

/// The active segment, the numbers of its motion in anatomical words, and what the face does.
class MotionPanel : public QWidget {
  Q_OBJECT
 public:
  explicit MotionPanel(QWidget* parent = nullptr);
  ~MotionPanel() override;

  /// What the segments are called; the choice is hidden where there is one.
  void set_segments(const QStringList& names);
  void show_active_segment(int segment);
  /// Shows a motion without reporting it as edited.
  void show_motion(const JawMotion& motion);
  void show_response(const Response& response);
  /// false: a model of forces, which cannot turn the bone.
  void set_turns_enabled(bool enabled);

 signals:
  void motion_edited(const gnathion::JawMotion& motion);
  void segment_chosen(int segment);

 private:
  JawMotion motion_shown() const;

  std::unique_ptr<Ui::MotionPanel> ui_;
  std::array<QDoubleSpinBox*, 6> boxes_;  ///< in the order of JawMotion's members
};

}  // namespace gnathion
