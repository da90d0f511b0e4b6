#include "app/collision_watch.h"

#include <utility>

namespace gnathion {
namespace {

bool same_bones(const SurgicalCase& a, const SurgicalCase& b) {
  if (a.ct != b.ct || a.bone != b.bone || a.segments.size() != b.segments.size()) return false;
  for (std::size_t s = 0; s < a.segments.size(); ++s) {
    if (a.segments[s].cut != b.segments[s].cut) return false;
  }
  return true;
}

}  // namespace

CollisionWatch::CollisionWatch(QObject* parent) : QObject(parent) {
  connect(&looking_, &BackgroundTask::finished, this, [this] {
    emit found();
    go_on();
  });
}

void CollisionWatch::watch(std::shared_ptr<const LoadedCase> loaded) {
  const bool known = loaded_ && same_bones(loaded_->plan, loaded->plan);
  loaded_ = std::move(loaded);
  if (known) return;
  looking_.cancel();
  preparing_.cancel();
  model_.reset();
  wanted_.reset();
  collisions_.clear();
  if (loaded_->anatomy->segments.empty()) return;
  preparing_.start([this, anatomy = loaded_->anatomy](Progress&) {
    std::vector<const TriangleMesh*> segments;
    for (const BoneSegment& segment : anatomy->segments) segments.push_back(&segment.mesh);
    auto model = std::make_shared<const CollisionModel>(segments, anatomy->remainder);
    return [this, model] {
      model_ = model;
      emit found();
      go_on();
    };
  });
}

void CollisionWatch::look(const std::vector<RigidMotion>& poses) {
  wanted_ = poses;
  go_on();
}

void CollisionWatch::go_on() {
  const bool fits = wanted_ && loaded_ && wanted_->size() == loaded_->anatomy->segments.size();
  if (!fits || !model_ || looking_.is_running()) return;
  looking_.start([this, model = model_, poses = *std::exchange(wanted_, {})](Progress&) {
    auto collisions = std::make_shared<std::vector<Collision>>(model->collisions(poses));
    return [this, collisions] { collisions_ = std::move(*collisions); };
  });
}

int CollisionWatch::segment_at(const ViewPoint& sight,
                               const std::vector<RigidMotion>& poses) const {
  if (!model_ || !loaded_ || poses.size() != loaded_->anatomy->segments.size()) return -1;
  return model_->segment_at(sight.eye, sight.direction, poses);
}

}  // namespace gnathion
