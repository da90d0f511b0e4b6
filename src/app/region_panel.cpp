#include "app/region_panel.h"

#include <QLocale>
#include <QPixmap>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <algorithm>
#include <array>
#include <cmath>

#include <vtkRenderer.h>

#include "app/case_controller.h"
#include "app/face_view.h"
#include "ui_region_panel.h"

namespace gnathion {
namespace {

/// What is wrong with a painted region, and what to do.
QString words_for(const RegionFault& fault) {
  switch (fault.kind) {
    case RegionFault::Kind::empty:
      return RegionPanel::tr(
          "Nothing is painted. Paint the part of the face that may move, or "
          "take the suggested region.");
    case RegionFault::Kind::pieces:
      return RegionPanel::tr(
                 "It is in %1 pieces; the smaller ones are marked. Paint a bridge "
                 "between them, erase what is too much, or press Tidy up.")
          .arg(fault.count);
    case RegionFault::Kind::no_rim:
      return RegionPanel::tr(
          "It covers the whole face, so nothing would hold it. Erase where the "
          "face should stay.");
    case RegionFault::Kind::touches_itself:
      return RegionPanel::tr(
          "Its rim touches itself in %n point(s), which are marked. Press Tidy "
          "up.",
          nullptr, fault.count);
  }
  return {};
}

/// The inner tissue's supports, at the vertices of the face above it.
std::vector<SupportPoint> support_points(const TissueProblem& problem) {
  std::vector<int> above(static_cast<std::size_t>(problem.tissue.surface_count), -1);
  std::vector<double> most(above.size(), 0);
  for (int v = 0; v < problem.surface_map.outerSize(); ++v) {
    for (SurfaceMap::InnerIterator weight(problem.surface_map, v); weight; ++weight) {
      const auto column = static_cast<std::size_t>(weight.col());
      if (weight.value() <= most[column]) continue;
      most[column] = weight.value();
      above[column] = v;
    }
  }
  std::vector<SupportPoint> points;
  for (int i = 0; i < problem.tissue.surface_count; ++i) {
    if (above[i] == -1) continue;
    SupportMark mark = SupportMark::free;
    switch (problem.supports[problem.tissue.inner(i)].kind) {
      case Support::attached:
        mark = SupportMark::attached;
        break;
      case Support::sliding:
        mark = SupportMark::sliding;
        break;
      case Support::fixed:
        mark = SupportMark::fixed;
        break;
      case Support::free:
        break;
    }
    points.push_back({above[i], mark});
  }
  return points;
}

QString swatch(SupportMark mark) {
  const Eigen::Vector3d rgb = colour_of(mark);
  return QString("background-color: rgb(%1, %2, %3); border: 1px solid gray")
      .arg(std::lround(255 * rgb[0]))
      .arg(std::lround(255 * rgb[1]))
      .arg(std::lround(255 * rgb[2]));
}

}  // namespace

RegionPanel::RegionPanel(CaseController& controller, FaceView& view, QWidget* parent)
    : QWidget(parent),
      ui_(std::make_unique<Ui::RegionPanel>()),
      controller_(controller),
      view_(view),
      editor_(controller),
      tool_(view, editor_, overlay_),
      lips_(controller, view, editor_) {
  ui_->setupUi(this);
  ui_->attached_swatch->setStyleSheet(swatch(SupportMark::attached));
  ui_->sliding_swatch->setStyleSheet(swatch(SupportMark::sliding));
  ui_->fixed_swatch->setStyleSheet(swatch(SupportMark::fixed));
  ui_->free_swatch->setStyleSheet(swatch(SupportMark::free));
  connect_brush();
  connect_stroke();
  connect_changes();
  connect_lips();
  connect_model();
}

RegionPanel::~RegionPanel() {
  set_active(false);
}

void RegionPanel::connect_brush() {
  const std::pair<QAbstractButton*, BrushMode> modes[] = {{ui_->paint_button, BrushMode::paint},
                                                          {ui_->erase_button, BrushMode::erase},
                                                          {ui_->turn_button, BrushMode::off}};
  for (const auto& [button, mode] : modes) {
    connect(button, &QAbstractButton::clicked, this, [this, mode = mode] { set_mode(mode); });
  }
  connect(ui_->target_box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this](int row) {
            editor_.set_target(row == 0 ? BrushTarget::region : BrushTarget::sliding);
          });
  connect(ui_->radius_box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), &tool_,
          &RegionBrushTool::set_radius);
  connect(ui_->radius_slider, &QSlider::valueChanged, &tool_,
          [this](int mm) { tool_.set_radius(mm); });
  connect(&tool_, &RegionBrushTool::radius_changed, this, [this](double mm) {
    const QSignalBlocker no_box(ui_->radius_box), no_slider(ui_->radius_slider);
    ui_->radius_box->setValue(mm);
    ui_->radius_slider->setValue(static_cast<int>(std::lround(mm)));
  });
  const std::pair<const char*, double> keys[] = {{"[", -1.0}, {"]", 1.0}};
  for (const auto& [key, by] : keys) {
    auto* shortcut = new QShortcut(QKeySequence(key), this);
    shortcut->setEnabled(false);
    connect(shortcut, &QShortcut::activated, this,
            [this, by = by] { tool_.set_radius(std::round(tool_.radius()) + by); });
    shortcuts_.push_back(shortcut);
  }
}

/// What is left out of the frames while a stroke goes on.
void RegionPanel::connect_stroke() {
  // Bones of many triangles and smooth edges cost a software renderer most of a frame.
  connect(&tool_, &RegionBrushTool::stroke_began, this, [this] {
    overlay_.set_supports({});
    overlay_.set_faults({});
    view_.renderer()->SetUseFXAA(false);
    view_.scene().set_coarse_bones(true);
  });
  connect(&tool_, &RegionBrushTool::stroke_ended, this, [this] {
    view_.renderer()->SetUseFXAA(true);
    view_.scene().set_coarse_bones(false);
    take_plan();
    view_.render_soon();
  });
}

void RegionPanel::connect_changes() {
  connect(ui_->grow_button, &QAbstractButton::clicked, this,
          [this] { editor_.grow(ui_->amount_box->value()); });
  connect(ui_->shrink_button, &QAbstractButton::clicked, this,
          [this] { editor_.shrink(ui_->amount_box->value()); });
  connect(ui_->smooth_button, &QAbstractButton::clicked, this,
          [this] { editor_.smooth(ui_->amount_box->value()); });
  connect(ui_->mirror_button, &QAbstractButton::clicked, &editor_, &RegionEditor::mirror);
  connect(ui_->tidy_button, &QAbstractButton::clicked, &editor_, &RegionEditor::tidy);
  connect(ui_->region_clear_button, &QAbstractButton::clicked, &editor_, &RegionEditor::clear);
  connect(ui_->suggest_button, &QAbstractButton::clicked, this,
          [this] { editor_.suggest(ui_->reach_box->value()); });
  connect(&editor_, &RegionEditor::mirroring_changed, this, &RegionPanel::update_enabled);
  connect(&editor_, &RegionEditor::failed, &controller_, &CaseController::failed);
  connect(&editor_, &RegionEditor::mirrored, this, [this](double error_mm) {
    emit controller_.noticed(
        RegionPanel::tr("The region was mirrored across the face's own midline. The two sides of "
                        "the face differ by %1 mm on average.")
            .arg(error_mm, 0, 'f', 1));
  });
}

void RegionPanel::connect_lips() {
  connect(ui_->trace_lips_button, &QAbstractButton::clicked, this, [this](bool traces) {
    if (!traces) {
      lips_.finish();
      return;
    }
    lips_.begin();
    show_lips();
    if (!lips_.is_tracing()) return;
    view_.set_tool(&lips_);
    view_.canvas()->setFocus();
  });
  connect(ui_->propose_lips_button, &QAbstractButton::clicked, &lips_, &LipLineTool::propose);
  connect(ui_->remove_lips_button, &QAbstractButton::clicked, &lips_, &LipLineTool::remove);
  connect(&lips_, &LipLineTool::tracing_changed, this, [this] {
    // The brush was put aside for the line.
    if (!lips_.is_tracing() && active_) set_mode(mode_);
    show_lips();
  });
}

void RegionPanel::show_lips() {
  const bool tracing = lips_.is_tracing();
  const bool any = controller_.has_case() && !controller_.plan().region.lip_line.empty();
  ui_->trace_lips_button->setChecked(tracing);
  ui_->remove_lips_button->setEnabled(any);
  // An exclusive button cannot be let go by itself; while a line is traced none is in the hand.
  const std::pair<QAbstractButton*, BrushMode> brushes[] = {{ui_->paint_button, BrushMode::paint},
                                                            {ui_->erase_button, BrushMode::erase},
                                                            {ui_->turn_button, BrushMode::off}};
  for (const auto& [button, mode] : brushes) {
    button->setAutoExclusive(false);
    button->setChecked(!tracing && mode == mode_);
    button->setAutoExclusive(true);
  }
  if (tracing) {
    ui_->lips_label->setText(
        tr("Click from corner to corner, then press Enter. %n point(s) so far.", nullptr,
           lips_.traced_count()));
  } else {
    ui_->lips_label->setText(any ? tr("Cut open along the line; contact is not computed.")
                                 : tr("Not cut: closed lips hang together."));
  }
}

void RegionPanel::connect_model() {
  connect(&editor_, &RegionEditor::changed, this, &RegionPanel::show_outline);
  connect(&editor_, &RegionEditor::faults_changed, this, &RegionPanel::show_state);
  connect(&controller_, &CaseController::history_changed, this, &RegionPanel::take_plan);
  connect(&controller_, &CaseController::work_began, this, &RegionPanel::show_state);
  connect(&controller_, &CaseController::work_ended, this, &RegionPanel::take_plan);
  connect(&view_, &FaceView::case_shown, this, &RegionPanel::take_plan);
  connect(&view_, &FaceView::face_points_changed, this, &RegionPanel::show_points);
  connect(ui_->supports_group, &QGroupBox::toggled, this, &RegionPanel::show_supports);
}

void RegionPanel::set_active(bool active) {
  if (!active && !active_) return;
  const bool begins = active && !active_;
  active_ = active;
  for (QShortcut* shortcut : shortcuts_) shortcut->setEnabled(active);
  if (active) {
    if (begins) overlay_.attach(view_.renderer());
    lips_.set_active(true);
    take_plan();
    show_points();
    set_mode(mode_);
  } else {
    editor_.end_stroke();
    lips_.set_active(false);
    if (view_.tool() == &tool_ || view_.tool() == &lips_) view_.set_tool(nullptr);
    overlay_.detach();
  }
  view_.render_soon();
}

void RegionPanel::set_mode(BrushMode mode) {
  mode_ = mode;
  tool_.set_mode(mode);
  ui_->paint_button->setChecked(mode == BrushMode::paint);
  ui_->erase_button->setChecked(mode == BrushMode::erase);
  ui_->turn_button->setChecked(mode == BrushMode::off);
  lips_.drop();
  if (active_) view_.set_tool(mode == BrushMode::off ? nullptr : &tool_);
}

void RegionPanel::take_plan() {
  if (!active_ || !controller_.has_case()) return;
  editor_.take_plan();
  lips_.take_plan();
  show_lips();
  const QSignalBlocker silent(ui_->reach_box);
  if (!ui_->reach_box->hasFocus()) ui_->reach_box->setValue(controller_.plan().region.reach_mm);
}

void RegionPanel::show_outline() {
  if (!active_) return;
  if (shown_face_ != &editor_.brush()) {
    shown_face_ = &editor_.brush();
    overlay_.set_face(shown_face_->face());
    show_points();
  }
  const RegionOutline& outline = editor_.outline();
  overlay_.set_region(outline.triangles, outline.rim);
  overlay_.set_sliding_area(editor_.sliding_outline().triangles);
  ui_->area_value->setText(
      tr("%1 cm², %2 triangles")
          .arg(QLocale().toString(outline.area_mm2 / 100, 'f', 1),
               QLocale().toString(static_cast<int>(outline.triangles.rows()))));
  view_.render_soon();
}

void RegionPanel::show_points() {
  if (!active_ || !editor_.has_face()) return;
  const Points& points = view_.face_points();
  if (points.rows() != editor_.brush().face().vertices.rows()) return;
  tool_.set_points(points);
  lips_.set_points(points);
  overlay_.set_points(points);
}

bool RegionPanel::is_model_current() const {
  return controller_.has_model() && !controller_.is_editing();
}

/// What is wrong with the region, or else how far its model is. is_wrong: the face cannot follow.
QString RegionPanel::state_words(bool& is_wrong) const {
  const RegionChoice& choice = controller_.plan().region;
  const bool suggested = choice.vertices.empty() && !choice.erased;
  is_wrong = false;
  if (!editor_.is_known()) return tr("The suggested region is being computed.");
  if (!suggested && !editor_.faults().empty()) {
    is_wrong = true;
    QStringList words;
    for (const RegionFault& fault : editor_.faults()) words << words_for(fault);
    return tr("The face cannot follow yet. %1").arg(words.join(' '));
  }
  if (!controller_.has_segments()) {
    return tr(
        "No segment is cut yet. Cut one in the step Bone: the region is then suggested from it; "
        "or paint it now.");
  }
  if (controller_.is_editing()) return tr("The tissue below is being computed.");
  if (!controller_.loaded().no_model) return tr("One piece with a rim: the face follows.");
  is_wrong = true;
  const Failure failure = failure_of(*controller_.loaded().no_model);
  return tr("The face cannot follow yet: %1. What to do: %2.").arg(failure.problem, failure.remedy);
}

void RegionPanel::show_state() {
  if (!active_ || !editor_.has_face()) return;
  std::vector<int> marked;
  for (const RegionFault& fault : editor_.faults()) {
    const bool everywhere =
        fault.kind == RegionFault::Kind::empty || fault.kind == RegionFault::Kind::no_rim;
    if (!everywhere) marked.insert(marked.end(), fault.vertices.begin(), fault.vertices.end());
  }
  overlay_.set_faults(marked);
  bool is_wrong = false;
  ui_->state_label->setText(state_words(is_wrong));
  ui_->state_label->setStyleSheet(is_wrong ? "color: #b35900; font-weight: bold" : "");
  show_supports();
  update_enabled();
}

void RegionPanel::show_supports() {
  std::vector<SupportPoint> points;
  if (is_model_current()) points = support_points(controller_.loaded().model->problem());
  const std::array<QLabel*, 4> values{ui_->attached_value, ui_->sliding_value, ui_->fixed_value,
                                      ui_->free_value};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto count = std::count_if(points.begin(), points.end(), [&](const SupportPoint& point) {
      return point.mark == support_marks[i];
    });
    values[i]->setText(is_model_current() ? QLocale().toString(static_cast<int>(count)) : "–");
  }
  ui_->rim_value->setText(is_model_current()
                              ? tr("%1 mm").arg(QLocale().toString(
                                    controller_.loaded().model->problem().rim_to_segment, 'f', 0))
                              : "–");
  const bool shown = active_ && ui_->supports_group->isChecked() && !editor_.is_stroke();
  overlay_.set_supports(shown ? points : std::vector<SupportPoint>());
  view_.render_soon();
}

void RegionPanel::update_enabled() {
  const bool any = editor_.has_face() && editor_.is_known() && editor_.outline().area_mm2 > 0;
  for (QWidget* widget : std::initializer_list<QWidget*>{ui_->grow_button, ui_->shrink_button,
                                                         ui_->smooth_button, ui_->tidy_button}) {
    widget->setEnabled(any);
  }
  ui_->mirror_button->setEnabled(any && !editor_.is_mirroring());
  ui_->region_clear_button->setEnabled(any);
  ui_->suggest_button->setEnabled(controller_.has_segments());
}

}  // namespace gnathion
