#include "app/cut_editor.h"

#include <algorithm>
#include <utility>

#include "app/camera_mouse.h"
#include "app/core_words.h"
#include "app/face_view.h"
#include "bone/cut_box.h"
#include "render/coarse_surface.h"
#include "render/segment_colours.h"

namespace gnathion {
namespace {

const Eigen::Vector3d allowed_colour{0.18, 0.42, 0.78};
const Eigen::Vector3d forbidden_colour{0.80, 0.12, 0.10};
const Eigen::Vector3d loose_colour{0.62, 0.60, 0.55};

/// The bone that a segment of the plan is cut from: what the segments before it have left.
TriangleMesh bone_before(const LoadedCase& loaded, std::size_t segment, Progress& progress) {
  const Anatomy& anatomy = *loaded.anatomy;
  if (segment == anatomy.segments.size()) return anatomy.remainder;
  TriangleMesh bone = anatomy.bone;
  for (std::size_t s = 0; s < segment; ++s) {
    bone = cut_segment(bone, loaded.plan.segments[s].cut, {}, progress).remainder;
  }
  return bone;
}

/// In the middle of the chin, or of the front of whatever bone there is.
Eigen::Vector3d chin_place(const LoadedCase& loaded) {
  const Points& bone = loaded.anatomy->bone.vertices;
  try {
    const JawAnatomy jaw = find_jaw(loaded.anatomy->bone, loaded.plan.landmarks);
    return {jaw.midline_x, jaw.pogonion.y() + 12, 0.65 * jaw.menton_z + 0.35 * jaw.bite.z()};
  } catch (const Error&) {
    Eigen::Vector3d centre = 0.5 * (bone.colwise().minCoeff() + bone.colwise().maxCoeff());
    centre.y() = bone.col(1).minCoeff() + 12;
    return centre;
  }
}

RigidMotion inverse(const RigidMotion& motion) {
  const Eigen::Matrix3d back = motion.rotation.transpose();
  return {back, -(back * motion.translation)};
}

}  // namespace

/// A cut to begin with, and the bone it is placed on.
struct CutEditor::Begun {
  std::size_t segment;
  std::shared_ptr<const CutPreviewer> previewer;
  Triangles coarse;
  PresetCut first;
};

CutEditor::CutEditor(CaseController& controller, FaceView& view, QObject* parent)
    : QObject(parent), controller_(controller), view_(view) {
  handle_.on_changed([this](const BoundedCut& cut) {
    layer_.set_quick(true);
    cut_ = cut;
    show_preview();
  });
  handle_.on_released([this](const BoundedCut&) {
    layer_.set_quick(false);
    view_.render_soon();
  });
  connect(&view_.camera_mouse(), &CameraMouse::moving, this,
          [this](bool moves) { layer_.set_quick(moves); });
  connect(&view_, &FaceView::case_shown, this, &CutEditor::close);
  connect(&starting_, &BackgroundTask::failed, this, &CutEditor::failed);
}

CutEditor::~CutEditor() = default;

void CutEditor::start(CutPreset preset) {
  begin(controller_.loaded().anatomy->segments.size(),
        [preset, loaded = controller_.shared_case()](const CutPreviewer& previewer,
                                                     Progress& progress) {
          const JawAnatomy jaw = find_jaw(loaded->anatomy->bone, loaded->plan.landmarks);
          return preset_cut(preset, jaw, previewer, progress);
        });
}

void CutEditor::start_box() {
  begin(controller_.loaded().anatomy->segments.size(),
        [loaded = controller_.shared_case()](const CutPreviewer&, Progress&) {
          BoxCut box;
          box.centre = chin_place(*loaded);
          box.half_extents = {25, 20, 15};
          return PresetCut{"segment", box};
        });
}

void CutEditor::start_blade() {
  begin(controller_.loaded().anatomy->segments.size(),
        [loaded = controller_.shared_case()](const CutPreviewer&, Progress&) {
          PlateCut blade;
          blade.centre = chin_place(*loaded);
          blade.half_width = 40;
          blade.half_height = 25;
          blade.seed = blade.centre + Eigen::Vector3d(0, 0, -8);
          return PresetCut{"segment", blade};
        });
}

void CutEditor::start_change(std::size_t segment) {
  const PlannedSegment& planned = controller_.loaded().plan.segments[segment];
  begin(segment, [first = PresetCut{planned.name, planned.cut}](const CutPreviewer&, Progress&) {
    return first;
  });
}

void CutEditor::begin(std::size_t segment, MakeCut make) {
  close();
  starting_.start([this, segment, make = std::move(make),
                   loaded = controller_.shared_case()](Progress& progress) {
    Begun begun;
    begun.segment = segment;
    TriangleMesh bone = bone_before(*loaded, segment, progress);
    begun.coarse = coarse_triangles(bone, 40000);
    progress.check();
    begun.previewer = std::make_shared<const CutPreviewer>(std::move(bone));
    begun.first = make(*begun.previewer, progress);
    return [this, begun] { open(begun); };
  });
  emit changed();
}

void CutEditor::open(const Begun& begun) {
  previewer_ = begun.previewer;
  segment_ = begun.segment;
  begun_ = begun.first.cut;
  const std::vector<PlannedSegment>& segments = controller_.loaded().plan.segments;
  name_ = segment_ < segments.size() ? QString::fromStdString(begun.first.name)
                                     : free_name(begun.first.name);
  layer_.set_bone(previewer_->bone(), begun.coarse);
  layer_.attach(view_.renderer());
  view_.scene().set_bone_drawn("skull", false);
  for (std::size_t s = segment_; s < segments.size(); ++s) {
    view_.scene().set_bone_drawn("segment " + segments[s].name, false);
  }
  view_.set_tool(&camera_only_);
  handle_.attach(view_.interactor(), view_.renderer());
  show_cut(begun_);
  emit opened();
}

void CutEditor::close() {
  starting_.cancel();
  if (!is_open()) return;
  previewer_.reset();
  handle_.detach();
  layer_.detach();
  if (view_.tool() == &camera_only_) view_.set_tool(nullptr);
  view_.scene().set_bone_drawn("skull", true);
  for (const PlannedSegment& segment : controller_.loaded().plan.segments) {
    view_.scene().set_bone_drawn("segment " + segment.name, true);
  }
  view_.render_soon();
  emit closed();
}

QString CutEditor::free_name(const std::string& wanted) const {
  const QString base = core_words(wanted);
  QString name = base;
  for (int number = 2;; ++number) {
    const auto& segments = controller_.loaded().plan.segments;
    const bool taken = std::any_of(segments.begin(), segments.end(), [&](const auto& segment) {
      return QString::fromStdString(segment.name) == name;
    });
    if (!taken) return name;
    name = QString("%1 %2").arg(base).arg(number);
  }
}

bool CutEditor::is_name_taken() const {
  if (name_.trimmed().isEmpty()) return true;
  const auto& segments = controller_.loaded().plan.segments;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (s != segment_ && QString::fromStdString(segments[s].name) == name_.trimmed()) return true;
  }
  return false;
}

void CutEditor::show_cut(const BoundedCut& cut) {
  handle_.set_cut(cut);
  cut_ = cut;
  show_preview();
}

void CutEditor::show_preview() {
  preview_ = previewer_->preview(cut_);
  Points colours(4, 3);
  colours << skull_look.colour.transpose(), look_of_segment(segment_).colour.transpose(),
      loose_colour.transpose(), forbidden_colour.transpose();
  std::vector<std::uint8_t> parts(preview_.part.size());
  std::transform(preview_.part.begin(), preview_.part.end(), parts.begin(),
                 [](CutPart part) { return static_cast<std::uint8_t>(part); });
  layer_.set_parts(parts, colours);
  handle_.set_colour(preview_.refusal ? forbidden_colour : allowed_colour);
  view_.render_soon();
  emit changed();
}

JawMotion CutEditor::placement() const {
  return jaw_motion(motion_between(begun_, cut_), box_of(begun_).centre);
}

void CutEditor::set_placement(const JawMotion& placement) {
  const BoundedCut sized = with_half_extents(begun_, half_extents());
  show_cut(moved(sized, rigid_motion(placement, box_of(begun_).centre)));
}

Eigen::Vector3d CutEditor::half_extents() const {
  return box_of(cut_).half_extents;
}

void CutEditor::set_half_extents(const Eigen::Vector3d& half_extents) {
  show_cut(with_half_extents(cut_, half_extents));
}

void CutEditor::take_other_side() {
  PlateCut blade = std::get<PlateCut>(cut_);
  const Eigen::Vector3d normal = blade.normal.normalized();
  blade.seed -= 2 * (blade.seed - blade.centre).dot(normal) * normal;
  // What the cut began with goes along, so that numbers typed later keep the side.
  begun_ = moved(BoundedCut(blade), inverse(motion_between(begun_, cut_)));
  show_cut(blade);
}

bool CutEditor::can_apply() const {
  return is_open() && !preview_.refusal && !is_name_taken() && !controller_.is_editing();
}

void CutEditor::apply() {
  SurgicalCase plan = controller_.plan();
  const bool is_new = segment_ >= plan.segments.size();
  if (is_new) plan.segments.emplace_back();
  PlannedSegment& segment = plan.segments[segment_];
  segment.name = name_.trimmed().toStdString();
  segment.cut = cut_;
  controller_.edit(is_new ? tr("Cut the %1").arg(name_.trimmed())
                          : tr("Change the cut of the %1").arg(name_.trimmed()),
                   std::move(plan));
}

}  // namespace gnathion
