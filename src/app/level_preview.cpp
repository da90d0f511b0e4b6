#include "app/level_preview.h"

#include "app/face_view.h"
#include "imaging/reduced_volume.h"

namespace gnathion {
namespace {

constexpr double coarse_step = 1.7;  // mm
constexpr const char* bone_name = "bone at another level";

}  // namespace

LevelPreview::LevelPreview(CaseController& controller, FaceView& view, QObject* parent)
    : QObject(parent), controller_(controller), view_(view) {
  connect(&contouring_, &BackgroundTask::failed, this, &LevelPreview::failed);
  connect(&view_, &FaceView::case_shown, this, &LevelPreview::hide);
}

void LevelPreview::show(double hu) {
  const std::shared_ptr<const CtVolume> full = controller_.loaded().anatomy->ct;
  BoneSurfaceOptions options = controller_.plan().bone;
  options.hu = hu;
  // What lies outside the head is seen and does no harm here; looking for it takes seconds.
  options.remove_support = false;
  contouring_.start([this, full, options, hu,
                     coarse = full == full_ ? coarse_ : nullptr](Progress& progress) mutable {
    if (!coarse) coarse = std::make_shared<const CtVolume>(reduced(*full, coarse_step));
    progress.check();
    const auto bone =
        std::make_shared<const TriangleMesh>(bone_surface(*coarse, options, progress));
    return [this, full, coarse, bone, hu] {
      full_ = full;
      coarse_ = coarse;
      show(*bone, hu);
    };
  });
}

void LevelPreview::show(const TriangleMesh& bone, double hu) {
  view_.scene().set_bone(bone_name, bone, skull_look);
  set_bones_drawn(false);
  shown_ = true;
  view_.render_soon();
  emit shown(hu);
}

void LevelPreview::hide() {
  contouring_.cancel();
  if (!shown_) return;
  shown_ = false;
  view_.scene().remove_bone(bone_name);
  set_bones_drawn(true);
  view_.render_soon();
}

void LevelPreview::set_bones_drawn(bool drawn) {
  for (const std::string& name : view_.scene().bone_names()) {
    if (name != bone_name) view_.scene().set_bone_drawn(name, drawn);
  }
}

}  // namespace gnathion
