#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/background_task.h"
#include "app/loaded_case.h"
#include "app/view_tool.h"
#include "bone/collision.h"

namespace gnathion {

/// Watches beside the window where the segments run into bone. A drag asks for more poses than can
/// be looked at: of those that come while one is being looked at, the last is looked at next.
class CollisionWatch : public QObject {
  Q_OBJECT
 public:
  explicit CollisionWatch(QObject* parent = nullptr);

  /// The case whose bones are watched; what is known of its bones is kept when they are the same.
  void watch(std::shared_ptr<const LoadedCase> loaded);
  /// poses: of the case's segments, LPS mm. found() follows, unless others come first.
  void look(const std::vector<RigidMotion>& poses);

  bool is_ready() const { return model_ != nullptr; }
  /// Of the poses that were looked at last, the deepest first.
  const std::vector<Collision>& collisions() const { return collisions_; }
  /// Whether they are those of the poses that were given last.
  bool is_up_to_date() const { return is_ready() && !wanted_ && !looking_.is_running(); }
  /// The segment that is seen first along a line of sight through the skin; −1: none.
  int segment_at(const ViewPoint& sight, const std::vector<RigidMotion>& poses) const;

 signals:
  void found();

 private:
  void go_on();

  std::shared_ptr<const LoadedCase> loaded_;
  std::shared_ptr<const CollisionModel> model_;  ///< null: not ready yet
  std::optional<std::vector<RigidMotion>> wanted_;
  std::vector<Collision> collisions_;
  BackgroundTask preparing_;
  BackgroundTask looking_;
};

}  // namespace gnathion
