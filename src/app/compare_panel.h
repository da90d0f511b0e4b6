#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "app/compare_view.h"
#include "prediction/face_change.h"

class QLabel;
namespace Ui {
class ComparePanel;
}

namespace gnathion {

/// The step "Compare": the face before and after, side by side, wiped, blended, as profiles, and in
/// numbers.
class ComparePanel : public QWidget {
  Q_OBJECT
 public:
  /// Both must outlive the panel.
  ComparePanel(CaseController& controller, FaceView& view, QWidget* parent = nullptr);
  ~ComparePanel() override;

  /// Called when the step is chosen, and when another is: what the panel adds to the view is there
  /// meanwhile only.
  void set_active(bool active);

  const CompareView& compare_view() const { return compare_; }
  /// What the numbers say; of the present answer while the panel is active.
  const FaceChange& change() const { return change_; }

 private:
  void connect_look();
  void connect_readouts();
  void show_mode();
  void show_range();
  void update_numbers();
  void show_numbers();
  void show_histogram();
  void show_volume();
  void show_reading(const std::optional<FaceReading>& reading);
  void show_distance();

  std::unique_ptr<Ui::ComparePanel> ui_;
  CaseController& controller_;
  FaceView& view_;
  QLabel* cursor_words_;  ///< beside the mouse, over the view
  FaceChange change_;
  CompareView compare_;
};

}  // namespace gnathion
