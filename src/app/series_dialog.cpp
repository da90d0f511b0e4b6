#include "app/series_dialog.h"

#include <QFile>
#include <QHeaderView>
#include <QPushButton>
#include <array>

#include "imaging/series_use.h"
#include "ui_series_dialog.h"

namespace gnathion {
namespace {

enum Column { modality, description, slices, size, spacing, use };

QString use_words(SeriesUse use) {
  switch (use) {
    case SeriesUse::usable:
      return SeriesDialog::tr("can be imported");
    case SeriesUse::not_ct:
      return SeriesDialog::tr("no: not a CT");
    case SeriesUse::too_few:
      return SeriesDialog::tr("no: too few slices for a volume");
  }
  return {};
}

}  // namespace

SeriesDialog::SeriesDialog(const std::filesystem::path& folder, QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::SeriesDialog>()), folder_(folder) {
  ui_->setupUi(this);
  ui_->series_label->setText(
      tr("Series in <b>%1</b>").arg(QFile::decodeName(folder.filename().c_str()).toHtmlEscaped()));
  ui_->series_label->setToolTip(QFile::decodeName(folder.c_str()));
  QPushButton* import = ui_->series_buttons->button(QDialogButtonBox::Ok);
  import->setText(tr("&Import"));
  import->setObjectName("series_import_button");
  import->setEnabled(false);
  ui_->series_buttons->button(QDialogButtonBox::Cancel)->setObjectName("series_cancel_button");
  ui_->show_descriptions_box->setEnabled(false);
  QHeaderView* header = ui_->series_table->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(use, QHeaderView::Stretch);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  connect(ui_->series_buttons, &QDialogButtonBox::accepted, this, &SeriesDialog::choose);
  connect(ui_->series_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(ui_->series_table, &QTableWidget::itemActivated, this, &SeriesDialog::choose);
  connect(ui_->series_table, &QTableWidget::itemSelectionChanged, this,
          [this, import] { import->setEnabled(chosen() != nullptr); });
  connect(ui_->show_descriptions_box, &QCheckBox::toggled, this, &SeriesDialog::show_descriptions);
  connect(this, &QDialog::rejected, &listing_, &BackgroundTask::cancel);
  connect(&listing_, &BackgroundTask::failed, this, [this](const Failure& failure) {
    emit failed(failure);
    reject();
  });
  listing_.start([this, folder](Progress& progress) {
    return [this, series = list_series(folder, progress)] { list(series); };
  });
}

SeriesDialog::~SeriesDialog() = default;

void SeriesDialog::list(std::vector<SeriesSummary> series) {
  series_ = std::move(series);
  ui_->series_progress->hide();
  QTableWidget* table = ui_->series_table;
  table->setRowCount(static_cast<int>(series_.size()));
  int first_usable = -1, usable = 0;
  bool described = false;
  for (int row = 0; row < table->rowCount(); ++row) {
    fill_row(row);
    described = described || !series_[row].description.empty();
    if (use_of(series_[row]) != SeriesUse::usable) continue;
    if (usable++ == 0) first_usable = row;
  }
  show_descriptions(false);
  ui_->show_descriptions_box->setEnabled(described);
  ui_->series_stage->setText(
      usable == 0 ? tr("None of these can be imported. Choose a folder with a CT of the head.")
                  : tr("Choose the CT of the head to import."));
  if (usable == 1) table->selectRow(first_usable);
  table->setFocus();
}

void SeriesDialog::fill_row(int row) {
  const SeriesSummary& series = series_[row];
  const SeriesUse series_use = use_of(series);
  const std::array<QString, 6> texts{QString::fromStdString(series.modality),
                                     QString(),
                                     QString::number(series.slices),
                                     tr("%1 × %2").arg(series.size.x()).arg(series.size.y()),
                                     tr("%1 × %2")
                                         .arg(series.pixel_spacing.x(), 0, 'g', 4)
                                         .arg(series.pixel_spacing.y(), 0, 'g', 4),
                                     use_words(series_use)};
  for (int column = 0; column < static_cast<int>(texts.size()); ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    if (series_use != SeriesUse::usable) item->setFlags(Qt::NoItemFlags);
    ui_->series_table->setItem(row, column, item);
  }
}

void SeriesDialog::show_descriptions(bool shown) {
  for (int row = 0; row < ui_->series_table->rowCount(); ++row) {
    const QString text = QString::fromStdString(series_[row].description);
    ui_->series_table->item(row, description)
        ->setText(shown || text.isEmpty() ? text : tr("(hidden)"));
  }
}

const SeriesSummary* SeriesDialog::chosen() const {
  const QList<QTableWidgetItem*> items = ui_->series_table->selectedItems();
  if (items.isEmpty()) return nullptr;
  const SeriesSummary& series = series_[items.first()->row()];
  return use_of(series) == SeriesUse::usable ? &series : nullptr;
}

void SeriesDialog::choose() {
  const SeriesSummary* series = chosen();
  if (series == nullptr) return;
  emit ct_chosen({folder_, series->uid});
  accept();
}

}  // namespace gnathion
