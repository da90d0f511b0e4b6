#pragma once

#include <QDialog>
#include <filesystem>
#include <memory>

#include "plan/surgical_case.h"

namespace Ui {
class PhotographDialog;
}

namespace gnathion {

/// Asks what an OBJ file does not say: its unit of length, and that it lies on the CT. Neither is
/// assumed: the user has to state both.
class PhotographDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PhotographDialog(const std::filesystem::path& obj, QWidget* parent = nullptr);
  ~PhotographDialog() override;

 signals:
  void photograph_chosen(const gnathion::PhotographSource& photograph);

 private:
  void update_button();
  void choose();

  std::unique_ptr<Ui::PhotographDialog> ui_;
  std::filesystem::path obj_;
};

}  // namespace gnathion
