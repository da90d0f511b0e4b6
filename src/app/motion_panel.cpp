#include "app/motion_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLocale>
#include <QSignalBlocker>

#include "app/motion_words.h"
#include "ui_motion_panel.h"

namespace gnathion {
namespace {

std::array<double JawMotion::*, 6> members() {
  return {&JawMotion::forward_mm, &JawMotion::up_mm,    &JawMotion::left_mm,
          &JawMotion::pitch_deg,  &JawMotion::roll_deg, &JawMotion::yaw_deg};
}

QString fixed(double value, int decimals) {
  // A value that rounds to zero is written without a sign.
  const QString text = QLocale().toString(value, 'f', decimals);
  return text.toDouble() == 0 ? QLocale().toString(0.0, 'f', decimals) : text;
}

void put(QTableWidget* table, int row, int column, const QString& text) {
  if (table->item(row, column) == nullptr) {
    auto* item = new QTableWidgetItem;
    item->setTextAlignment(static_cast<int>(Qt::AlignVCenter) |
                           static_cast<int>(column == 0 ? Qt::AlignLeft : Qt::AlignRight));
    table->setItem(row, column, item);
  }
  table->item(row, column)->setText(text);
}

}  // namespace

MotionPanel::MotionPanel(QWidget* parent)
    : QWidget(parent), ui_(std::make_unique<Ui::MotionPanel>()) {
  ui_->setupUi(this);
  boxes_ = {ui_->forward_box, ui_->up_box,   ui_->left_box,
            ui_->pitch_box,   ui_->roll_box, ui_->yaw_box};
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const double limit = i < 3 ? largest_shift_mm : largest_turn_deg;
    boxes_[i]->setRange(-limit, limit);
    connect(boxes_[i], QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this] { emit motion_edited(motion_shown()); });
  }
  connect(ui_->reset_button, &QPushButton::clicked, this, [this] { emit motion_edited({}); });
  connect(ui_->segment_box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &MotionPanel::segment_chosen);
  ui_->segment_box->hide();
  QHeaderView* header = ui_->landmark_table->horizontalHeader();
  header->setSectionResizeMode(0, QHeaderView::Stretch);
  header->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  ui_->no_landmarks_label->hide();  // until a case says so
  ui_->landmark_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
}

MotionPanel::~MotionPanel() = default;

JawMotion MotionPanel::motion_shown() const {
  JawMotion motion;
  for (std::size_t i = 0; i < boxes_.size(); ++i) motion.*members()[i] = boxes_[i]->value();
  return motion;
}

void MotionPanel::set_segments(const QStringList& names) {
  const QSignalBlocker silent(ui_->segment_box);
  ui_->segment_box->clear();
  ui_->segment_box->addItems(names);
  ui_->segment_box->setVisible(names.size() > 1);
}

void MotionPanel::show_active_segment(int segment) {
  const QSignalBlocker silent(ui_->segment_box);
  ui_->segment_box->setCurrentIndex(segment);
}

void MotionPanel::show_motion(const JawMotion& motion) {
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const double value = motion.*members()[i];
    // Setting the value that a box has would disturb the text that is being typed into it.
    if (boxes_[i]->value() == value) continue;
    const QSignalBlocker silent(boxes_[i]);
    boxes_[i]->setValue(value);
  }
}

void MotionPanel::show_response(const Response& response) {
  ui_->mean_value->setText(tr("%1 mm").arg(fixed(response.displacement.mean, 1)));
  ui_->p95_value->setText(tr("%1 mm").arg(fixed(response.displacement.p95, 1)));
  ui_->max_value->setText(tr("%1 mm").arg(fixed(response.displacement.max, 1)));
  QTableWidget* table = ui_->landmark_table;
  const bool any = !response.landmarks.empty();
  table->setVisible(any);
  ui_->no_landmarks_label->setVisible(!any);
  table->setRowCount(static_cast<int>(response.landmarks.size()));
  int row = 0;
  for (const auto& [name, landmark] : response.landmarks) {
    put(table, row, 0, landmark_words(name));
    put(table, row, 1, fixed(landmark.displacement.norm(), 1));
    put(table, row, 2, landmark.bone_mm > 0 ? fixed(landmark.ratio, 2) : QString(QChar(0x2013)));
    ++row;
  }
}

void MotionPanel::set_turns_enabled(bool enabled) {
  for (QDoubleSpinBox* box : {ui_->pitch_box, ui_->roll_box, ui_->yaw_box}) {
    box->setEnabled(enabled);
  }
}

}  // namespace gnathion
