#include "app/compare_panel.h"

#include <QCursor>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QTableWidgetItem>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/answer_words.h"
#include "app/case_controller.h"
#include "app/face_view.h"
#include "app/place_words.h"
#include "render/colour_map.h"
#include "ui_compare_panel.h"

namespace gnathion {
namespace {

constexpr std::array modes{CompareMode::side_by_side, CompareMode::wipe, CompareMode::blend,
                           CompareMode::profile, CompareMode::predicted};

/// mm with a decimal more than is said elsewhere: an error below the tolerance is to be read.
QString fine(double mm) {
  return QLocale().toString(mm, 'f', mm < 1 ? 2 : 1);
}

QString litres_words(double mm3, bool with_sign) {
  const double cm3 = std::abs(mm3) < 50 ? 0 : mm3 / 1000;
  const QString sign = with_sign && cm3 > 0 ? QStringLiteral("+") : QString();
  return sign + QLocale().toString(cm3, 'f', 1).replace('-', QChar(0x2212));
}

}  // namespace

ComparePanel::ComparePanel(CaseController& controller, FaceView& view, QWidget* parent)
    : QWidget(parent),
      ui_(std::make_unique<Ui::ComparePanel>()),
      controller_(controller),
      view_(view),
      cursor_words_(new QLabel(view.canvas())),
      compare_(controller, view) {
  ui_->setupUi(this);
  cursor_words_->setObjectName("cursor_words");
  cursor_words_->setAttribute(Qt::WA_TransparentForMouseEvents);
  cursor_words_->setStyleSheet(
      "background: rgba(255, 255, 255, 215); color: #10161c; padding: 3px 6px; border-radius: 3px");
  cursor_words_->hide();
  QHeaderView* header = ui_->numbers_table->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::Stretch);
  ui_->numbers_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
  connect_look();
  connect_readouts();
  show_mode();
}

ComparePanel::~ComparePanel() = default;

void ComparePanel::connect_look() {
  connect(ui_->mode_box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &ComparePanel::show_mode);
  connect(ui_->wipe_slider, &QSlider::valueChanged, this,
          [this](int percent) { compare_.set_wipe(percent / 100.0); });
  connect(&compare_, &CompareView::wipe_dragged, this, [this](double fraction) {
    const QSignalBlocker silent(ui_->wipe_slider);
    ui_->wipe_slider->setValue(static_cast<int>(std::lround(100 * fraction)));
  });
  connect(ui_->blend_slider, &QSlider::valueChanged, this,
          [this](int percent) { compare_.set_blend(percent / 100.0); });
  connect(ui_->section_box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double left_mm) { compare_.set_section(left_mm); });
  connect(ui_->colour_check, &QCheckBox::toggled, &view_, &FaceView::set_colour_map_visible);
  connect(&view_, &FaceView::colour_map_switched, ui_->colour_check, &QCheckBox::setChecked);
  connect(ui_->range_box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] {
    show_range();
    show_histogram();
  });
  connect(ui_->quantity_box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &ComparePanel::show_histogram);
}

void ComparePanel::connect_readouts() {
  for (const auto changed :
       {&CaseController::motion_changed, &CaseController::refinement_changed}) {
    connect(&controller_, changed, this, &ComparePanel::update_numbers);
  }
  connect(ui_->distance_button, &QPushButton::toggled, this, [this](bool on) {
    compare_.set_measuring(on);
    show_distance();
  });
  connect(ui_->clear_button, &QPushButton::clicked, &compare_, &CompareView::clear_distance);
  connect(&compare_, &CompareView::distance_changed, this, &ComparePanel::show_distance);
  connect(&compare_, &CompareView::pointed, this, &ComparePanel::show_reading);
}

void ComparePanel::set_active(bool active) {
  compare_.set_active(active);
  cursor_words_->hide();
  if (active) {
    update_numbers();
    show_distance();
  }
}

void ComparePanel::show_mode() {
  const CompareMode mode = modes[static_cast<std::size_t>(ui_->mode_box->currentIndex())];
  compare_.set_mode(mode);
  const bool paper = mode == CompareMode::profile;
  for (QWidget* widget : std::initializer_list<QWidget*>{ui_->wipe_label, ui_->wipe_slider}) {
    widget->setVisible(mode == CompareMode::wipe);
  }
  for (QWidget* widget : std::initializer_list<QWidget*>{ui_->blend_label, ui_->blend_slider}) {
    widget->setVisible(mode == CompareMode::blend);
  }
  for (QWidget* widget : std::initializer_list<QWidget*>{ui_->section_label, ui_->section_box}) {
    widget->setVisible(paper);
  }
  ui_->colour_check->setEnabled(!paper);
  ui_->range_box->setEnabled(!paper);
  ui_->distance_button->setEnabled(!paper);
  show_distance();
}

void ComparePanel::show_range() {
  view_.set_change_range(ui_->range_box->value());
}

void ComparePanel::update_numbers() {
  if (!compare_.is_active() || !controller_.has_case()) return;
  const std::vector<int> none;
  const LoadedCase& loaded = controller_.loaded();
  change_ = face_change(loaded.anatomy->face.mesh.surface,
                        loaded.model ? loaded.model->moving_vertices() : none,
                        controller_.response().face, controller_.refined());
  show_numbers();
  show_volume();
  show_histogram();
}

void ComparePanel::show_numbers() {
  const bool refined = controller_.refined() != nullptr;
  const AnswerWords said = answer_words(controller_, {});
  ui_->answer_label->setText(!controller_.has_model() ? said.status
                             : refined                ? tr("<b>Refined answer</b>")
                                       : tr("<b>Quick answer, not refined yet</b>: its error is "
                                            "not known"));
  ui_->answer_label->setToolTip(said.status);
  const QString unknown(QChar(0x2013));
  const auto put = [&](int row, const DistanceStatistics* of) {
    const std::array<QString, 3> texts =
        of != nullptr ? std::array{fine(of->mean), fine(of->p95), fine(of->max)}
                      : std::array{unknown, unknown, unknown};
    for (int column = 0; column < 3; ++column) {
      auto* item = new QTableWidgetItem(texts[static_cast<std::size_t>(column)]);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      ui_->numbers_table->setItem(row, column, item);
    }
  };
  const bool any = controller_.has_model();
  put(0, any ? &change_.displacement_size : nullptr);
  put(1, refined ? &change_.signed_size : nullptr);
  put(2, change_.error ? &*change_.error : nullptr);
}

void ComparePanel::show_volume() {
  if (!controller_.has_model()) {
    ui_->volume_label->clear();
    return;
  }
  const QString gained = litres_words(change_.volume_mm3, true);
  ui_->volume_label->setText(change_.error
                                 ? tr("Volume gained: %1 cm³ (± %2 cm³)")
                                       .arg(gained, litres_words(change_.volume_error_mm3(), false))
                                 : tr("Volume gained: %1 cm³ (quick answer)").arg(gained));
}

void ComparePanel::show_histogram() {
  const bool is_signed = ui_->quantity_box->currentIndex() == 0;
  const Eigen::VectorXd& values = is_signed ? change_.signed_mm : change_.displacement;
  if (values.size() == 0) {
    ui_->histogram_view->show_words(controller_.has_model()
                                        ? tr("The signed change is measured when the refined "
                                             "answer is ready.")
                                        : tr("No region moves yet."));
    return;
  }
  std::vector<HistogramView::Mark> marks;
  if (is_signed) {
    Eigen::Index extreme = 0;
    const Eigen::ArrayXd sizes = values.array().isNaN().select(0, values.array().abs());
    sizes.maxCoeff(&extreme);
    const double p95 = change_.signed_size.p95;
    const double mean = values.array().isNaN().select(0, values.array()).sum() /
                        std::max<double>(static_cast<double>(change_.signed_size.count), 1);
    marks = {{mean, tr("mean")},
             {values[extreme] < 0 ? -p95 : p95, tr("95 %")},
             {values[extreme], tr("max")}};
  } else {
    const DistanceStatistics& size = change_.displacement_size;
    marks = {{size.mean, tr("mean")}, {size.p95, tr("95 %")}, {size.max, tr("max")}};
  }
  const double fixed = ui_->range_box->value();
  const double range = fixed > 0 ? fixed : round_half_range(values);
  ui_->histogram_view->show_values(gnathion::histogram(values), std::move(marks),
                                   is_signed ? range : 0);
}

void ComparePanel::show_reading(const std::optional<FaceReading>& reading) {
  cursor_words_->setVisible(reading.has_value());
  if (!reading) {
    ui_->reading_label->setText(tr("Point at the face to read its change."));
    return;
  }
  const Eigen::Vector3d moved_by = reading->after - reading->before;
  QStringList lines;
  lines << tr("%1 of the scan's origin%2")
               .arg(direction_words(reading->on_before ? reading->before : reading->after),
                    reading->on_before ? tr(" (before)") : QString());
  lines << (moved_by.norm() < 0.05
                ? tr("does not move")
                : tr("moves %1: %2").arg(mm_words(moved_by.norm()), direction_words(moved_by)));
  lines << (reading->signed_mm ? tr("signed change %1").arg(mm_words(*reading->signed_mm, true))
                               : tr("quick answer: signed change not measured yet"));
  ui_->reading_label->setText(lines.join("\n"));
  cursor_words_->setText(lines.join("\n"));
  cursor_words_->adjustSize();
  const QWidget* canvas = view_.canvas();
  QPoint place = canvas->mapFromGlobal(QCursor::pos()) + QPoint(18, 18);
  place.setX(std::clamp(place.x(), 0, std::max(canvas->width() - cursor_words_->width(), 0)));
  if (place.y() + cursor_words_->height() > canvas->height()) {
    place.ry() -= cursor_words_->height() + 36;
  }
  cursor_words_->move(place);
}

void ComparePanel::show_distance() {
  const auto distance = compare_.distance();
  ui_->clear_button->setEnabled(compare_.ends() > 0);
  if (distance) {
    ui_->distance_label->setText(
        tr("Before %1, predicted %2 (%3)%4")
            .arg(mm_words(distance->before), mm_words(distance->after),
                 mm_words(distance->after - distance->before, true),
                 controller_.refined() != nullptr ? QString() : tr(", quick answer")));
  } else if (!ui_->distance_button->isChecked()) {
    ui_->distance_label->setText(tr("Straight distance between two points of the face, in mm."));
  } else {
    ui_->distance_label->setText(compare_.ends() == 0 ? tr("Click the first point on the face.")
                                                      : tr("Click the second point on the face."));
  }
}

}  // namespace gnathion
