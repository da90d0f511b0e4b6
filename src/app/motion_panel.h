#pragma once

#include <QWidget>
#include <array>
#include <memory>

#include "app/case_controller.h"

class QDoubleSpinBox;
namespace Ui {
class MotionPanel;
}

namespace gnathion {

/// The numbers of a motion in anatomical words, and what the face does.
class MotionPanel : public QWidget {
  Q_OBJECT
 public:
  explicit MotionPanel(QWidget* parent = nullptr);
  ~MotionPanel() override;

  /// Shows a motion without reporting it as edited.
  void show_motion(const JawMotion& motion);
  void show_response(const Response& response);
  /// false: a model of forces, which cannot turn the bone.
  void set_turns_enabled(bool enabled);

 signals:
  void motion_edited(const gnathion::JawMotion& motion);

 private:
  JawMotion motion_shown() const;

  std::unique_ptr<Ui::MotionPanel> ui_;
  std::array<QDoubleSpinBox*, 6> boxes_;  ///< in the order of JawMotion's members
};

}  // namespace gnathion
