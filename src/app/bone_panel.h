#pragma once

#include <QWidget>
#include <memory>

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

 private:
  std::unique_ptr<Ui::BonePanel> ui_;
  CaseController& controller_;
  FaceView& view_;
};

}  // namespace gnathion
