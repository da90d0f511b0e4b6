#pragma once

#include <QDialog>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/background_task.h"
#include "plan/surgical_case.h"
#include "scan/scan_frame.h"

namespace Ui {
class PhotographDialog;
}

namespace gnathion {

/// Asks what a face scan does not say: its unit of length, and whether it lies on the CT. A unit is
/// proposed from the scan's size, which is read beside the window; neither is assumed: the user has
/// to state both.
class PhotographDialog : public QDialog {
  Q_OBJECT
 public:
  /// face: n×3, mm, LPS, the present one: before it is where a photograph begins that has to be
  /// fitted.
  PhotographDialog(const std::filesystem::path& obj, const Points& face, QWidget* parent = nullptr);
  ~PhotographDialog() override;

 signals:
  /// to_be_fitted: it is in the stated unit, upright and faces forward as far as its shape tells,
  /// with its front where that of the present face is; no more.
  void photograph_chosen(const gnathion::PhotographSource& photograph, bool to_be_fitted);

 private:
  void update_button();
  void choose();
  void read_scan_size();
  void show_proposal(const ProposedUnit& unit);

  std::unique_ptr<Ui::PhotographDialog> ui_;
  std::filesystem::path obj_;
  Eigen::Vector3d front_;              ///< of the present face, LPS mm
  std::optional<Similarity> upright_;  ///< scale 1, front at the origin; none: not read yet
  BackgroundTask reading_;             // last: its worker stops first
};

}  // namespace gnathion
