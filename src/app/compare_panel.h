#pragma once

#include <QWidget>
#include <memory>

namespace Ui {
class ComparePanel;
}

namespace gnathion {

class CaseController;
class FaceView;

/// The step "Compare": the face before and after, side by side, wiped, blended, and in numbers.
class ComparePanel : public QWidget {
  Q_OBJECT
 public:
  /// Both must outlive the panel.
  ComparePanel(CaseController& controller, FaceView& view, QWidget* parent = nullptr);
  ~ComparePanel() override;

  /// Called when the step is chosen, and when another is: what the panel adds to the view is there
  /// meanwhile only.
  void set_active(bool active);

 private:
  std::unique_ptr<Ui::ComparePanel> ui_;
  CaseController& controller_;
  FaceView& view_;
};

}  // namespace gnathion
