#pragma once

#include <QDialog>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/background_task.h"
#include "imaging/dicom_series.h"
#include "plan/surgical_case.h"

namespace Ui {
class SeriesDialog;
}

namespace gnathion {

/// Lists the DICOM series of a folder, read beside the window, and lets the user choose a CT.
/// Nothing of the patient is shown; descriptions, which may hold names, only when asked for.
class SeriesDialog : public QDialog {
  Q_OBJECT
 public:
  /// Begins to read at once; closes itself with failed() when the folder cannot be listed.
  explicit SeriesDialog(const std::filesystem::path& folder, QWidget* parent = nullptr);
  ~SeriesDialog() override;

 signals:
  void ct_chosen(const gnathion::CtSource& ct);
  void failed(const gnathion::Failure& failure);

 private:
  void list(std::vector<SeriesSummary> series);
  void fill_row(int row);
  void show_descriptions(bool shown);
  void choose();
  /// The series that is chosen; null: none that can be imported.
  const SeriesSummary* chosen() const;

  std::unique_ptr<Ui::SeriesDialog> ui_;
  std::filesystem::path folder_;
  std::vector<SeriesSummary> series_;
  BackgroundTask listing_;
};

}  // namespace gnathion
