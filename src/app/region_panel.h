#pragma once

#include <QWidget>
#include <memory>

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

 private:
  std::unique_ptr<Ui::RegionPanel> ui_;
  CaseController& controller_;
  FaceView& view_;
};

}  // namespace gnathion
