#pragma once

#include <QDialog>
#include <memory>

#include "plan/surgical_case.h"

namespace Ui {
class TissueDialog;
}

namespace gnathion {

/// What the tissue is made of and how exactly it is computed. accepted() when the user has chosen;
/// the model() is then what is wanted.
class TissueDialog : public QDialog {
  Q_OBJECT
 public:
  explicit TissueDialog(const TissueModel& model, QWidget* parent = nullptr);
  ~TissueDialog() override;

  /// The model that was given, with what the dialog shows in its place.
  TissueModel model() const;

 private:
  void show_model(const TissueModel& model);
  void keep_to_force_transfer();

  std::unique_ptr<Ui::TissueDialog> ui_;
  TissueModel given_;
};

}  // namespace gnathion
