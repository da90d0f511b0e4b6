#include "app/bone_panel.h"

#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <QPixmap>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "app/case_controller.h"
#include "app/core_words.h"
#include "app/face_view.h"
#include "bone/cut_box.h"
#include "render/segment_colours.h"
#include "ui_bone_panel.h"

namespace gnathion {
namespace {

constexpr int level_rest_ms = 700;

std::array<double JawMotion::*, 6> members() {
  return {&JawMotion::forward_mm, &JawMotion::up_mm,    &JawMotion::left_mm,
          &JawMotion::pitch_deg,  &JawMotion::roll_deg, &JawMotion::yaw_deg};
}

void put(QDoubleSpinBox* box, double value) {
  const QSignalBlocker silent(box);
  box->setValue(value);
}

QIcon swatch(std::size_t segment) {
  const Eigen::Vector3d rgb = look_of_segment(segment).colour;
  QPixmap pixmap(14, 14);
  pixmap.fill(QColor::fromRgbF(rgb.x(), rgb.y(), rgb.z()));
  return pixmap;
}

QString cm3(double mm3) {
  return BonePanel::tr("%1 cm³").arg(QLocale().toString(mm3 / 1000, 'f', 1));
}

QString sentence(const std::string& text) {
  QString words = core_words(text);
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words.toHtmlEscaped();
}

}  // namespace

BonePanel::BonePanel(CaseController& controller, FaceView& view, QWidget* parent)
    : QWidget(parent),
      ui_(std::make_unique<Ui::BonePanel>()),
      controller_(controller),
      view_(view),
      level_(controller, view, this),
      editor_(controller, view, this) {
  ui_->setupUi(this);
  place_boxes_ = {ui_->cut_forward_box, ui_->cut_up_box,   ui_->cut_left_box,
                  ui_->cut_pitch_box,   ui_->cut_roll_box, ui_->cut_yaw_box};
  size_boxes_ = {ui_->cut_width_box, ui_->cut_length_box, ui_->cut_height_box};
  QHeaderView* header = ui_->segment_table->horizontalHeader();
  header->setSectionResizeMode(0, QHeaderView::Stretch);
  header->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  ui_->segment_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  connect_level();
  connect_segments();
  connect_cut();
  connect(&view_, &FaceView::case_shown, this, &BonePanel::show_case);
  connect(ui_->show_face_box, &QCheckBox::toggled, this, [this](bool shown) {
    view_.scene().set_face_visible(shown || !active_);
    view_.render_soon();
  });
  connect(&controller_, &CaseController::work_began, this, &BonePanel::update_enabled);
  connect(&controller_, &CaseController::work_ended, this, [this] {
    // An edit that failed or was cancelled leaves the level that the bone has.
    const bool choosing = level_rest_.isActive() || ui_->level_slider->isSliderDown();
    if (controller_.has_case() && !controller_.is_editing() && !choosing) {
      level_.hide();
      show_level_of_plan();
    }
    update_enabled();
  });
  show_cut();
}

BonePanel::~BonePanel() = default;

void BonePanel::connect_level() {
  level_rest_.setSingleShot(true);
  connect(&level_rest_, &QTimer::timeout, this, &BonePanel::take_level);
  connect(ui_->level_slider, &QSlider::valueChanged, this, &BonePanel::choose_level);
  connect(ui_->level_box, QOverload<int>::of(&QSpinBox::valueChanged), this,
          &BonePanel::choose_level);
  connect(ui_->level_slider, &QSlider::sliderReleased, this, &BonePanel::take_level);
  connect(&level_, &LevelPreview::failed, this, &BonePanel::show_failure);
}

void BonePanel::connect_segments() {
  QTableWidget* table = ui_->segment_table;
  connect(table, &QTableWidget::itemChanged, this, &BonePanel::segment_edited);
  connect(table, &QTableWidget::itemSelectionChanged, this, &BonePanel::update_enabled);
  connect(ui_->remove_segment_button, &QPushButton::clicked, this, &BonePanel::remove_segment);
  connect(ui_->change_cut_button, &QPushButton::clicked, this,
          [this] { editor_.start_change(static_cast<std::size_t>(chosen_segment())); });
}

void BonePanel::connect_cut() {
  const auto preset = [this](QPushButton* button, CutPreset which) {
    connect(button, &QPushButton::clicked, this, [this, which] { editor_.start(which); });
  };
  preset(ui_->chin_button, CutPreset::chin);
  preset(ui_->sagittal_button, CutPreset::mandible_body);
  preset(ui_->le_fort_button, CutPreset::maxilla);
  connect(ui_->blade_button, &QPushButton::clicked, &editor_, &CutEditor::start_blade);
  connect(ui_->box_button, &QPushButton::clicked, &editor_, &CutEditor::start_box);
  for (QDoubleSpinBox* box : place_boxes_) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &BonePanel::place_cut);
  }
  for (QDoubleSpinBox* box : size_boxes_) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &BonePanel::size_cut);
  }
  connect(ui_->cut_name_edit, &QLineEdit::textEdited, this, [this](const QString& name) {
    editor_.set_name(name);
    show_result();
  });
  connect(ui_->other_side_box, &QCheckBox::clicked, &editor_, &CutEditor::take_other_side);
  connect(ui_->cut_button, &QPushButton::clicked, &editor_, &CutEditor::apply);
  connect(ui_->cancel_cut_button, &QPushButton::clicked, &editor_, &CutEditor::close);
  connect(&editor_, &CutEditor::opened, this, &BonePanel::show_cut);
  connect(&editor_, &CutEditor::closed, this, &BonePanel::show_cut);
  connect(&editor_, &CutEditor::changed, this, [this] {
    if (editor_.is_open()) show_cut_numbers();
    show_result();
  });
  connect(&editor_, &CutEditor::failed, this, &BonePanel::show_failure);
}

void BonePanel::set_active(bool active) {
  if (active == active_) return;
  active_ = active;
  if (!active) {
    level_rest_.stop();
    level_.hide();
    editor_.close();
    show_level_of_plan();
  }
  view_.scene().set_face_visible(!active || ui_->show_face_box->isChecked());
  view_.render_soon();
}

void BonePanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && editor_.is_open()) {
    editor_.close();
  } else {
    QWidget::keyPressEvent(event);
  }
}

/// After another case, an edit, an undo.
void BonePanel::show_case() {
  level_rest_.stop();
  show_level_of_plan();
  show_segments();
  view_.scene().set_face_visible(!active_ || ui_->show_face_box->isChecked());
  update_enabled();
}

// --- the level ----------------------------------------------------------------------------------

void BonePanel::show_level_of_plan() {
  if (controller_.has_case()) show_level(static_cast<int>(std::lround(controller_.plan().bone.hu)));
}

void BonePanel::show_level(int hu) {
  const QSignalBlocker silent_slider(ui_->level_slider), silent_box(ui_->level_box);
  ui_->level_slider->setValue(hu);
  ui_->level_box->setValue(hu);
}

void BonePanel::choose_level(int hu) {
  show_level(hu);
  editor_.close();
  level_.show(hu);
  if (!ui_->level_slider->isSliderDown()) level_rest_.start(level_rest_ms);
}

void BonePanel::take_level() {
  level_rest_.stop();
  SurgicalCase plan = controller_.plan();
  const int hu = ui_->level_box->value();
  if (std::lround(plan.bone.hu) == hu) {
    level_.hide();
    return;
  }
  plan.bone.hu = hu;
  controller_.edit(tr("Bone from %1 HU").arg(hu), std::move(plan));
}

// --- the segments -------------------------------------------------------------------------------

void BonePanel::show_segments() {
  QTableWidget* table = ui_->segment_table;
  const QSignalBlocker silent(table);
  const std::vector<BoneSegment>& segments = controller_.loaded().anatomy->segments;
  table->setRowCount(static_cast<int>(segments.size()));
  for (std::size_t s = 0; s < segments.size(); ++s) {
    auto* name = new QTableWidgetItem(swatch(s), QString::fromStdString(segments[s].name));
    name->setFlags(name->flags() | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    name->setCheckState(Qt::Checked);
    auto* volume = new QTableWidgetItem(cm3(segments[s].volume_mm3));
    volume->setFlags(volume->flags() & ~Qt::ItemIsEditable);
    volume->setTextAlignment(static_cast<int>(Qt::AlignRight) | static_cast<int>(Qt::AlignVCenter));
    table->setItem(static_cast<int>(s), 0, name);
    table->setItem(static_cast<int>(s), 1, volume);
  }
  if (!segments.empty()) table->selectRow(static_cast<int>(segments.size()) - 1);
}

void BonePanel::segment_edited(QTableWidgetItem* item) {
  if (item->column() != 0) return;
  const auto s = static_cast<std::size_t>(item->row());
  const std::string old = controller_.loaded().anatomy->segments[s].name;
  view_.scene().set_bone_visible("segment " + old, item->checkState() == Qt::Checked);
  view_.render_soon();
  const std::string name = item->text().trimmed().toStdString();
  if (name == old) return;
  SurgicalCase plan = controller_.plan();
  const bool taken = std::any_of(plan.segments.begin(), plan.segments.end(),
                                 [&](const PlannedSegment& other) { return other.name == name; });
  if (name.empty() || taken || controller_.is_editing()) {
    const QSignalBlocker silent(ui_->segment_table);
    item->setText(QString::fromStdString(old));
    return;
  }
  plan.segments[s].name = name;
  controller_.edit(tr("Rename %1 to %2").arg(QString::fromStdString(old), item->text().trimmed()),
                   std::move(plan));
}

int BonePanel::chosen_segment() const {
  return ui_->segment_table->currentRow();
}

void BonePanel::remove_segment() {
  SurgicalCase plan = controller_.plan();
  const int s = chosen_segment();
  const QString name = QString::fromStdString(plan.segments[static_cast<std::size_t>(s)].name);
  plan.segments.erase(plan.segments.begin() + s);
  controller_.edit(tr("Remove the %1").arg(name), std::move(plan));
}

// --- the cut ------------------------------------------------------------------------------------

void BonePanel::show_cut() {
  const bool open = editor_.is_open();
  ui_->cut_group->setVisible(open);
  // One thing at a time, so that all of it is seen in a low window.
  ui_->segments_group->setVisible(!open);
  ui_->new_cut_group->setVisible(!open);
  if (open) {
    const bool blade = editor_.is_blade();
    ui_->cut_name_edit->setText(editor_.name());
    ui_->cut_group->setTitle(blade ? tr("Blade") : tr("Box"));
    ui_->other_side_box->setVisible(blade);
    ui_->other_side_box->setChecked(false);
    ui_->cut_height_label->setText(blade ? tr("Saw cut") : tr("Height"));
    ui_->cut_height_box->setMaximum(blade ? 5 : 300);
    show_cut_numbers();
  }
  show_result();
}

void BonePanel::show_cut_numbers() {
  const JawMotion placement = editor_.placement();
  for (std::size_t i = 0; i < place_boxes_.size(); ++i) {
    put(place_boxes_[i], placement.*members()[i]);
  }
  const Eigen::Vector3d half = editor_.half_extents();
  for (std::size_t i = 0; i < size_boxes_.size(); ++i) {
    put(size_boxes_[i], 2 * half(static_cast<Eigen::Index>(i)));
  }
}

/// Only the number that was changed: the others are shown rounded.
void BonePanel::place_cut() {
  JawMotion placement = editor_.placement();
  for (std::size_t i = 0; i < place_boxes_.size(); ++i) {
    if (place_boxes_[i] == sender()) placement.*members()[i] = place_boxes_[i]->value();
  }
  editor_.set_placement(placement);
}

void BonePanel::size_cut() {
  Eigen::Vector3d half = editor_.half_extents();
  for (std::size_t i = 0; i < size_boxes_.size(); ++i) {
    if (size_boxes_[i] == sender()) {
      half(static_cast<Eigen::Index>(i)) = 0.5 * size_boxes_[i]->value();
    }
  }
  editor_.set_half_extents(half);
}

void BonePanel::show_result() {
  update_enabled();
  if (!editor_.is_open()) return;
  const CutPreview& preview = editor_.preview();
  QString text;
  if (preview.segment_mm3 > 0) {
    text = tr("Comes off: <b>%1</b>, sawn area %2 cm²")
               .arg(cm3(preview.segment_mm3), QLocale().toString(preview.sawn_mm2 / 100, 'f', 1));
  }
  for (const double loose : preview.loose_mm3) {
    text += "<br>" + tr("Comes loose and is not moved: %1").arg(cm3(loose));
  }
  const auto warn = [&text](const QString& words) {
    if (!text.isEmpty()) text += "<br>";
    text += QString("<b style='color:#c0291f'>%1</b>").arg(words);
  };
  if (preview.refusal) {
    warn(sentence(preview.refusal->problem()) + ".");
    text += "<br>" + sentence(preview.refusal->remedy()) + ".";
  }
  if (editor_.is_name_taken()) warn(tr("Give a name that no other segment has."));
  ui_->cut_result_label->setText(text);
}

void BonePanel::update_enabled() {
  const bool ready = controller_.has_case() && !controller_.is_editing();
  const bool chosen = ready && chosen_segment() >= 0;
  ui_->level_group->setEnabled(ready);
  ui_->segment_table->setEnabled(ready);
  ui_->new_cut_group->setEnabled(ready && !editor_.is_starting());
  ui_->remove_segment_button->setEnabled(chosen);
  ui_->change_cut_button->setEnabled(chosen && !editor_.is_starting());
  ui_->cut_button->setEnabled(editor_.can_apply());
}

void BonePanel::show_failure(const Failure& failure) {
  update_enabled();
  emit failed(failure);
}

}  // namespace gnathion
