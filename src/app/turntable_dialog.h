#pragma once

#include <QDialog>
#include <memory>

#include "app/turntable_export.h"

namespace Ui {
class TurntableDialog;
}

namespace gnathion {

/// Asks what turns, how large, and where to.
class TurntableDialog : public QDialog {
  Q_OBJECT
 public:
  explicit TurntableDialog(QWidget* parent = nullptr);
  ~TurntableDialog() override;

  TurntableWish wish() const;

 private:
  void suggest_target();
  void browse();
  void check();

  std::unique_ptr<Ui::TurntableDialog> ui_;
};

}  // namespace gnathion
