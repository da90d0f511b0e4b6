#include "app/registration_panel.h"

#include <QFile>
#include <QHeaderView>
#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include <vtkRenderer.h>

#include "app/core_words.h"
#include "app/face_view.h"
#include "app/photographs_dialog.h"
#include "app/theme.h"
#include "ui_registration_panel.h"

namespace gnathion {
namespace {

constexpr double veil = 0.3;           // opacity of the skin over the photograph
constexpr double colour_range = 4;     // mm at the ends of the colours
constexpr double least_on_skin = 0.4;  // share of the photograph within 2 mm; else it is told

enum LandmarkColumn { name_column, photograph_column, ct_column, before_column, now_column };

std::array<double JawMotion::*, 6> members() {
  return {&JawMotion::forward_mm, &JawMotion::up_mm,    &JawMotion::left_mm,
          &JawMotion::pitch_deg,  &JawMotion::roll_deg, &JawMotion::yaw_deg};
}

QString words_for(const std::string& landmark) {
  const std::pair<const char*, QString> words[] = {
      {"nasion", RegistrationPanel::tr("Nasion")},
      {"nose_tip", RegistrationPanel::tr("Nose tip")},
      {"canthus_outer_right", RegistrationPanel::tr("Outer canthus R")},
      {"canthus_inner_right", RegistrationPanel::tr("Inner canthus R")},
      {"canthus_inner_left", RegistrationPanel::tr("Inner canthus L")},
      {"canthus_outer_left", RegistrationPanel::tr("Outer canthus L")},
      {"mouth_corner_right", RegistrationPanel::tr("Mouth corner R")},
      {"mouth_corner_left", RegistrationPanel::tr("Mouth corner L")},
      {"pogonion", RegistrationPanel::tr("Pogonion (chin)")}};
  const auto* found = std::find_if(std::begin(words), std::end(words),
                                   [&](const auto& word) { return landmark == word.first; });
  return found == std::end(words) ? QString::fromStdString(landmark) : found->second;
}

QString mm(double value, int digits = 2) {
  return QLocale().toString(value, 'f', digits);
}

QString percent(double share) {
  return RegistrationPanel::tr("%1 %").arg(std::lround(100 * share));
}

QTableWidgetItem* read_only(const QString& text, bool number = true) {
  auto* item = new QTableWidgetItem(text);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  if (number) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return item;
}

/// As high as its rows, so that only the page scrolls.
void fit_height(QTableWidget* table) {
  const int height = table->horizontalHeader()->sizeHint().height() +
                     table->rowCount() * table->verticalHeader()->defaultSectionSize() +
                     2 * table->frameWidth();
  table->setFixedHeight(height);
  table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void list(QTableWidget* table, const QStringList& rows) {
  table->setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < table->rowCount(); ++row) {
    if (table->item(row, 0) != nullptr && table->item(row, 0)->text() == rows[row]) continue;
    table->setItem(row, 0, read_only(rows[row], false));
    for (int column = 1; column < table->columnCount(); ++column) {
      table->setItem(row, column, read_only("–"));
    }
  }
  fit_height(table);
}

void set_up(QTableWidget* table, const QStringList& columns, const QStringList& rows) {
  table->setColumnCount(static_cast<int>(columns.size()));
  table->setHorizontalHeaderLabels(columns);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 6);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->horizontalHeader()->setHighlightSections(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setTabKeyNavigation(false);
  list(table, rows);
}

/// Begins with a capital; for rich text.
QString sentence(QString words) {
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words.toHtmlEscaped();
}

}  // namespace

RegistrationPanel::RegistrationPanel(CaseController& controller, FaceView& view, QWidget* parent)
    : QWidget(parent),
      ui_(std::make_unique<Ui::RegistrationPanel>()),
      controller_(controller),
      view_(view),
      editor_(controller),
      tool_(editor_),
      stable_(controller),
      brush_(view, stable_, overlay_),
      photographs_(new PhotographsDialog(controller, view, this)) {
  ui_->setupUi(this);
  nudge_boxes_ = {ui_->nudge_forward_box, ui_->nudge_up_box,   ui_->nudge_left_box,
                  ui_->nudge_pitch_box,   ui_->nudge_roll_box, ui_->nudge_yaw_box};
  ui_->show_both_button->setChecked(true);
  show_timer_.setSingleShot(true);
  connect(&show_timer_, &QTimer::timeout, this, &RegistrationPanel::show_state);
  set_up_tables();
  connect_buttons();
  connect_landmarks();
  connect_stable_region();
  connect_nudge();
  connect(&editor_, &RegistrationEditor::changed, this, &RegistrationPanel::show_soon);
  connect(&editor_, &RegistrationEditor::failed, this, &RegistrationPanel::failed);
  connect(&editor_, &RegistrationEditor::landmarks_changed, this, [this] {
    if (!active_) return;
    show_landmarks();
    update_enabled();
    show_marks();
    view_.render_soon();
  });
  connect(&editor_, &RegistrationEditor::fit_began, this, &RegistrationPanel::fit_began);
  connect(&editor_, &RegistrationEditor::stage_began, this,
          [this](const QString& stage) { ui_->fit_stage_label->setText(sentence(stage)); });
  connect(&view_, &FaceView::case_shown, this, [this] {
    if (has_scene_) set_bones_drawn(false);  // they may be new
    show_state();
  });
  connect(&controller_, &CaseController::refinement_changed, this, &RegistrationPanel::show_soon);
  connect(&controller_, &CaseController::motion_changed, this, &RegistrationPanel::show_soon);
}

RegistrationPanel::~RegistrationPanel() {
  set_active(false);
}

void RegistrationPanel::set_up_tables() {
  set_up(ui_->quality_table, {tr("Distance to the CT's skin"), tr("Plan"), tr("Proposed")},
         {tr("RMS, mm"), tr("Median, mm"), tr("95th percentile, mm"), tr("Within 2 mm"),
          tr("Near the skin"), tr("Size, mm a unit")});
  ui_->quality_table->setSelectionMode(QAbstractItemView::NoSelection);
  ui_->quality_table->setFocusPolicy(Qt::NoFocus);
  set_up(ui_->registration_landmark_table,
         {tr("Landmark"), tr("Photo"), tr("CT"), tr("Before"), tr("Now, mm")}, landmark_names());
}

QStringList RegistrationPanel::landmark_names() const {
  QStringList names;
  for (const PickedLandmark& landmark : editor_.landmarks()) names << words_for(landmark.name);
  return names;
}

void RegistrationPanel::connect_buttons() {
  connect(ui_->add_photograph_button, &QAbstractButton::clicked, this,
          &RegistrationPanel::photograph_wanted);
  connect(ui_->use_skin_button, &QAbstractButton::clicked, this, &RegistrationPanel::use_skin);
  connect(ui_->project_photographs_button, &QAbstractButton::clicked, photographs_, [this] {
    photographs_->show();
    photographs_->raise();
  });
  connect(photographs_, &PhotographsDialog::failed, this, &RegistrationPanel::failed);
  connect(ui_->accept_fit_button, &QAbstractButton::clicked, &editor_, &RegistrationEditor::accept);
  connect(ui_->reject_fit_button, &QAbstractButton::clicked, &editor_, &RegistrationEditor::reject);
  connect(ui_->cancel_fit_button, &QAbstractButton::clicked, &editor_, &RegistrationEditor::cancel);
  const auto scale = [this] { return ui_->fit_scale_box->isChecked(); };
  connect(ui_->fit_auto_button, &QAbstractButton::clicked, this,
          [this, scale] { editor_.fit_automatically(fit_region(), scale()); });
  connect(ui_->fit_landmarks_button, &QAbstractButton::clicked, this,
          [this, scale] { editor_.fit_to_landmarks(scale()); });
  connect(ui_->refine_button, &QAbstractButton::clicked, this,
          [this, scale] { editor_.refine(fit_region(), scale()); });
  const std::pair<QAbstractButton*, Show> shows[] = {
      {ui_->show_photograph_button, Show::photograph},
      {ui_->show_ct_button, Show::ct},
      {ui_->show_both_button, Show::both}};
  for (const auto& [button, show] : shows) {
    connect(button, &QAbstractButton::clicked, this, [this, show = show] { show_surfaces(show); });
  }
}

void RegistrationPanel::connect_landmarks() {
  QTableWidget* table = ui_->registration_landmark_table;
  connect(table, &QTableWidget::currentCellChanged, this,
          [this](int row) { choose_landmark(row); });
  connect(&tool_, &LandmarkTool::picked, this, &RegistrationPanel::choose_next_landmark);
  connect(ui_->clear_landmark_button, &QAbstractButton::clicked, this,
          [this] { editor_.clear_landmark(tool_.landmark()); });
  connect(ui_->pick_button, &QAbstractButton::toggled, this, [this](bool picks) {
    if (picks) set_brush(BrushMode::off);
    // Both at once hide each other.
    if (picks && show_ == Show::both) show_surfaces(Show::photograph);
    show_state();
  });
  table->setCurrentCell(0, 0);
}

void RegistrationPanel::connect_stable_region() {
  const std::pair<QAbstractButton*, BrushMode> brushes[] = {
      {ui_->stable_paint_button, BrushMode::paint}, {ui_->stable_erase_button, BrushMode::erase}};
  for (const auto& [button, mode] : brushes) {
    connect(button, &QAbstractButton::clicked, this,
            [this, mode = mode](bool on) { set_brush(on ? mode : BrushMode::off); });
  }
  connect(ui_->stable_propose_button, &QAbstractButton::clicked, &stable_,
          &StableRegionEditor::take_proposal);
  connect(ui_->fit_region_box, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    if (fit_region() == FitRegion::whole) set_brush(BrushMode::off);
    show_state();
  });
  connect(ui_->stable_radius_box, qOverload<double>(&QDoubleSpinBox::valueChanged), &brush_,
          &RegionBrushTool::set_radius);
  connect(&brush_, &RegionBrushTool::radius_changed, ui_->stable_radius_box,
          &QDoubleSpinBox::setValue);
  connect(&stable_, &StableRegionEditor::changed, this, &RegistrationPanel::show_stable_outline);
  // Smooth edges cost a software renderer most of a frame.
  connect(&brush_, &RegionBrushTool::stroke_began, this,
          [this] { view_.renderer()->SetUseFXAA(false); });
  connect(&brush_, &RegionBrushTool::stroke_ended, this, &RegistrationPanel::show_state);
}

FitRegion RegistrationPanel::fit_region() const {
  return ui_->fit_region_box->currentIndex() == 0 ? FitRegion::stable : FitRegion::whole;
}

/// The brush in the hand is for the photograph alone: colours and the veil would hide its paint.
void RegistrationPanel::set_brush(BrushMode mode) {
  brush_mode_ = mode;
  brush_.set_mode(mode);
  ui_->stable_paint_button->setChecked(mode == BrushMode::paint);
  ui_->stable_erase_button->setChecked(mode == BrushMode::erase);
  if (mode == BrushMode::off) {
    show_state();
    return;
  }
  ui_->pick_button->setChecked(false);
  ui_->fit_region_box->setCurrentIndex(0);
  show_surfaces(Show::photograph);
}

void RegistrationPanel::connect_nudge() {
  for (std::size_t i = 0; i < nudge_boxes_.size(); ++i) {
    connect(nudge_boxes_[i], qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this, i](double value) {
              JawMotion nudge = editor_.nudge();
              nudge.*members()[i] = value;
              editor_.set_nudge(nudge);
            });
  }
}

void RegistrationPanel::set_active(bool active) {
  if (!active && !active_) return;
  active_ = active;
  editor_.set_active(active);
  if (active) {
    show_state();
  } else {
    photographs_->hide();
    end_scene();
  }
}

void RegistrationPanel::show_surfaces(Show show) {
  show_ = show;
  ui_->show_photograph_button->setChecked(show == Show::photograph);
  ui_->show_ct_button->setChecked(show == Show::ct);
  ui_->show_both_button->setChecked(show == Show::both);
  if (show == Show::both) ui_->pick_button->setChecked(false);
  if (show != Show::photograph && brush_mode_ != BrushMode::off) set_brush(BrushMode::off);
  show_state();
}

void RegistrationPanel::choose_landmark(int row) {
  if (row < 0) return;
  tool_.set_landmark(static_cast<std::size_t>(row));
  show_soon();
}

/// The next one that is not picked on this surface yet.
void RegistrationPanel::choose_next_landmark() {
  const auto& landmarks = editor_.landmarks();
  for (std::size_t i = tool_.landmark() + 1; i < landmarks.size(); ++i) {
    const PickedPlace& at = landmarks[i].at;
    const auto& place = show_ == Show::ct ? at.lps : at.photograph;
    if (place) continue;
    ui_->registration_landmark_table->setCurrentCell(static_cast<int>(i), 0);
    return;
  }
}

void RegistrationPanel::use_skin() {
  SurgicalCase plan = controller_.plan();
  plan.photograph.reset();
  plan.region.vertices.clear();  // they count the photograph's vertices
  plan.region.erased = false;
  plan.tissue.sliding_vertices.clear();
  controller_.edit(tr("Use the CT's skin"), std::move(plan));
}

void RegistrationPanel::show_soon() {
  if (active_ && !show_timer_.isActive()) show_timer_.start(0);
}

void RegistrationPanel::show_state() {
  if (!active_ || !controller_.has_case()) return;
  show_place();
  show_quality();
  show_doubts();
  show_landmarks();
  show_nudge();
  update_enabled();
  show_scene();
  fit_awaited();
}

/// Once the photograph that was added is there; where it could not be added, nothing.
void RegistrationPanel::fit_awaited() {
  if (fit_next_.empty() || controller_.is_editing()) return;
  const bool there =
      editor_.has_photograph() && controller_.loaded().plan.photograph->obj == fit_next_;
  fit_next_.clear();
  if (there) editor_.fit_automatically(fit_region(), ui_->fit_scale_box->isChecked());
}

void RegistrationPanel::show_place() {
  if (!editor_.has_photograph()) {
    ui_->photograph_state_label->setText(
        tr("No photograph: the face is the CT's own skin, without colours."));
    return;
  }
  const auto& obj = controller_.loaded().plan.photograph->obj;
  ui_->photograph_state_label->setText(
      tr("<b>%1</b>, %2 triangles")
          .arg(QFile::decodeName(obj.filename().c_str()).toHtmlEscaped(),
               QLocale().toString(static_cast<int>(editor_.photograph().triangles.rows()))));
  ui_->photograph_state_label->setToolTip(QFile::decodeName(obj.c_str()));
}

void RegistrationPanel::show_quality() {
  const std::array<const Placement*, 2> columns{
      editor_.has_photograph() ? &editor_.present() : nullptr, editor_.proposal()};
  for (int column = 1; column <= 2; ++column) {
    const Placement* place = columns[static_cast<std::size_t>(column - 1)];
    QStringList words;
    if (place != nullptr && place->is_measured) {
      const RegistrationQuality& q = place->quality;
      words << mm(q.rms_mm) << mm(q.median_mm) << mm(q.p95_mm) << percent(q.agrees)
            << percent(q.near);
    } else {
      for (int row = 0; row < 5; ++row) words << (place != nullptr ? "…" : "–");
    }
    words << (place != nullptr ? QLocale().toString(place->lps_from_photograph.scale, 'g', 5)
                               : "–");
    for (int row = 0; row < words.size(); ++row) {
      ui_->quality_table->item(row, column)->setText(words[row]);
    }
  }
}

void RegistrationPanel::show_doubts() {
  const Placement* proposal = editor_.proposal();
  QStringList words;
  bool warns = false;
  if (proposal != nullptr && proposal->is_fitted) {
    warns = !proposal->doubts.empty();
    for (const RegistrationDoubt& doubt : proposal->doubts) {
      words << tr("%1. What to do: %2.")
                   .arg(sentence(core_words(doubt.problem)),
                        core_words(doubt.remedy).toHtmlEscaped());
    }
    if (!warns) {
      words << tr("The fit came to rest after %1 steps; nothing speaks against it. Look whether "
                  "left is left, then accept it.")
                   .arg(proposal->quality.iterations);
    }
  } else if (proposal != nullptr) {
    words << tr("A proposal: the plan keeps its place until you accept it.");
  } else if (editor_.has_photograph() && editor_.present().is_measured) {
    warns = editor_.present().quality.agrees * editor_.present().quality.near < least_on_skin;
    if (warns) words << tr("The photograph does not lie on the CT's skin. What to do: fit it.");
  }
  const QString text = words.join("<br>");
  ui_->doubt_label->setText(
      warns ? QString("<b style='color:%1'>%2</b>").arg(warning_colour(palette()).name(), text)
            : text);
  ui_->doubt_label->setVisible(!words.isEmpty());
  ui_->accept_fit_button->setText(warns && proposal != nullptr ? tr("&Accept all the same")
                                                               : tr("&Accept"));
}

void RegistrationPanel::show_landmarks() {
  const auto now = editor_.residuals(), before = editor_.residuals_before();
  const auto& landmarks = editor_.landmarks();
  QTableWidget* table = ui_->registration_landmark_table;
  list(table, landmark_names());
  for (int row = 0; row < table->rowCount(); ++row) {
    const PickedLandmark& landmark = landmarks[static_cast<std::size_t>(row)];
    const auto residual = [&](const std::map<std::string, double>& of) {
      const auto found = of.find(landmark.name);
      return found == of.end() ? QString("–") : mm(found->second, 1);
    };
    table->item(row, photograph_column)->setText(landmark.at.photograph ? "✓" : "–");
    table->item(row, ct_column)->setText(landmark.at.lps ? "✓" : "–");
    table->item(row, before_column)
        ->setText(editor_.proposal() != nullptr ? residual(before) : QString("–"));
    table->item(row, now_column)->setText(residual(now));
  }
  const auto complete = editor_.complete_landmarks();
  ui_->landmark_hint->setText(
      complete < 3 ? tr("Picked on both: %1 of at least 3.").arg(complete)
                   : tr("Picked on both: %1. A surface fit may lower the distances and yet part "
                        "the landmarks: watch both.")
                         .arg(complete));
}

void RegistrationPanel::show_nudge() {
  for (std::size_t i = 0; i < nudge_boxes_.size(); ++i) {
    const QSignalBlocker silent(nudge_boxes_[i]);
    nudge_boxes_[i]->setValue(editor_.nudge().*members()[i]);
  }
}

void RegistrationPanel::update_enabled() {
  const bool editing = controller_.is_editing();
  const bool any = editor_.has_photograph() && !editing;
  const bool fitting = editor_.is_fitting();
  const bool free = any && !fitting;
  ui_->add_photograph_button->setEnabled(!editing && !fitting);
  ui_->use_skin_button->setEnabled(free);
  ui_->project_photographs_button->setEnabled(!editing && controller_.has_case() &&
                                              !editor_.has_photograph());
  for (QWidget* widget :
       std::initializer_list<QWidget*>{ui_->fit_auto_button, ui_->fit_scale_box,
                                       ui_->fit_region_box, ui_->refine_button, ui_->nudge_group}) {
    widget->setEnabled(free);
  }
  for (QWidget* group :
       std::initializer_list<QWidget*>{ui_->placement_group, ui_->show_group, ui_->fit_group,
                                       ui_->registration_landmark_group, ui_->nudge_group}) {
    group->setVisible(editor_.has_photograph());
  }
  ui_->fit_landmarks_button->setEnabled(free && editor_.complete_landmarks() >= 3);
  const PickedPlace& chosen = editor_.landmarks()[tool_.landmark()].at;
  ui_->clear_landmark_button->setEnabled(chosen.photograph || chosen.lps);
  const bool paints = free && fit_region() == FitRegion::stable;
  for (QWidget* widget : std::initializer_list<QWidget*>{
           ui_->stable_paint_button, ui_->stable_erase_button, ui_->stable_radius_box}) {
    widget->setEnabled(paints);
  }
  ui_->stable_propose_button->setEnabled(paints && stable_.is_painted());
  for (QWidget* button : {ui_->accept_fit_button, ui_->reject_fit_button}) {
    button->setEnabled(free && editor_.proposal() != nullptr);
  }
  for (QWidget* widget : std::initializer_list<QWidget*>{ui_->fit_progress, ui_->cancel_fit_button,
                                                         ui_->fit_stage_label}) {
    widget->setVisible(fitting);
  }
}

void RegistrationPanel::set_bones_drawn(bool drawn) {
  for (const std::string& name : view_.scene().bone_names()) {
    view_.scene().set_bone_drawn(name, drawn);
  }
}

void RegistrationPanel::begin_scene() {
  if (has_scene_) return;
  has_scene_ = true;
  skin_.attach(view_.renderer());
  overlay_.attach(view_.renderer());
  marks_.attach(view_.renderer());
  set_bones_drawn(false);
  if (view_.is_before_visible()) view_.set_before_visible(false);
}

void RegistrationPanel::end_scene() {
  stable_.end_stroke();
  if (view_.tool() == &tool_ || view_.tool() == &brush_) view_.set_tool(nullptr);
  overlay_.detach();
  skin_.detach();
  marks_.detach();
  if (!has_scene_) return;
  has_scene_ = false;
  set_bones_drawn(true);
  view_.scene().set_face_visible(true);
  view_.end_film();
  view_.render_soon();
}

QString RegistrationPanel::caption() const {
  QString place = editor_.proposal() != nullptr
                      ? tr("Photograph where it is proposed, not accepted yet")
                      : tr("Photograph where the plan has it");
  switch (show_) {
    case Show::photograph:
      return place;
    case Show::ct:
      return tr("Skin of the CT");
    case Show::both:
      break;
  }
  return place + "\n" + tr("colours: mm above (red) and below (blue) the CT's skin");
}

void RegistrationPanel::show_scene() {
  if (!editor_.has_photograph()) {
    end_scene();
    return;
  }
  begin_scene();
  const Placement& place = editor_.shown();
  view_.show_film(moved(editor_.photograph().vertices, place.lps_from_photograph), caption());
  // Nothing moves here: whole surfaces, smooth edges.
  view_.scene().set_coarse(false);
  view_.renderer()->SetUseFXAA(true);
  if (editor_.skin() != shown_skin_ && editor_.skin() != nullptr) skin_.set_skin(*editor_.skin());
  shown_skin_ = editor_.skin();
  const bool has_skin = shown_skin_ != nullptr;
  skin_.set_opacity(!has_skin || show_ == Show::photograph ? 0 : show_ == Show::ct ? 1 : veil);
  view_.scene().set_face_visible(show_ != Show::ct);
  if (show_ == Show::both && place.is_measured) {
    view_.scene().show_colour_map(place.distance_mm, colour_range, tr("mm").toStdString());
  } else {
    view_.scene().hide_colour_map();
  }
  show_stable_region();
  show_marks();
  show_tool();
  view_.render_soon();
}

/// What is painted on follows the photograph, and the proposed region its place.
void RegistrationPanel::show_stable_region() {
  const std::shared_ptr<const SurfaceBrush> brush = editor_.brush();
  const Similarity& place = editor_.shown().lps_from_photograph;
  if (brush && (brush != painted_ || place != painted_place_)) {
    const Points points = moved(brush->face().vertices, place);
    if (brush != painted_) overlay_.set_face(brush->face());
    overlay_.set_points(points);
    brush_.set_points(points, editor_.photograph_tree(), place);
    painted_ = brush;
    painted_place_ = place;
  }
  stable_.set_photograph(brush, place.scale, editor_.proposed_region());
  show_stable_outline();
}

void RegistrationPanel::show_stable_outline() {
  if (!has_scene_) return;
  const bool decides = fit_region() == FitRegion::stable && painted_ != nullptr;
  const RegionOutline& outline = stable_.outline();
  // Paint would hide the colours of the distances: there the rim alone is drawn.
  const bool filled = decides && show_ == Show::photograph;
  const bool rimmed = decides && show_ != Show::ct;
  overlay_.set_region(filled ? outline.triangles : Triangles(),
                      rimmed ? outline.rim : std::vector<std::array<int, 2>>());
  const QString area = tr("%1 cm²").arg(QLocale().toString(stable_.area_cm2(), 'f', 0));
  ui_->stable_region_label->setText(
      fit_region() == FitRegion::whole ? tr("The whole photograph decides.")
      : outline.triangles.rows() == 0  ? tr("The stable region is being proposed.")
      : stable_.is_painted()
          ? tr("Painted as stable: %1.").arg(area)
          : tr("Proposed as stable: forehead, brows and bridge of the nose, %1.").arg(area));
  view_.render_soon();
}

void RegistrationPanel::show_marks() {
  std::vector<LandmarkMark> marks;
  std::vector<std::pair<int, int>> lines;
  const Similarity& place = editor_.shown().lps_from_photograph;
  const auto& landmarks = editor_.landmarks();
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const std::string words = words_for(landmarks[i].name).toStdString();
    const bool chosen = show_ != Show::both && i == tool_.landmark();
    const PickedPlace& picked = landmarks[i].at;
    const bool photograph = picked.photograph && show_ != Show::ct;
    const bool ct = picked.lps && show_ != Show::photograph;
    if (photograph && ct) {
      lines.emplace_back(static_cast<int>(marks.size()), static_cast<int>(marks.size()) + 1);
    }
    if (photograph) {
      marks.push_back({place(*picked.photograph), LandmarkMark::Kind::photograph, words, chosen});
    }
    if (ct) {
      marks.push_back({*picked.lps, LandmarkMark::Kind::ct, photograph ? "" : words, chosen});
    }
  }
  marks_.show(marks, lines);
}

void RegistrationPanel::show_tool() {
  tool_.set_surface(show_ == Show::ct ? PickedSurface::ct : PickedSurface::photograph);
  tool_.set_picking(ui_->pick_button->isChecked() && show_ != Show::both);
  // Also when nothing is picked: the grips of a segment go.
  ViewTool* tool = &tool_;
  if (brush_mode_ != BrushMode::off && show_ == Show::photograph) tool = &brush_;
  view_.set_tool(tool);
}

}  // namespace gnathion
