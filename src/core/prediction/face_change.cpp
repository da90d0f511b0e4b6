#include "prediction/face_change.h"

#include <Eigen/Geometry>

namespace gnathion {
namespace {

/// The volume between a triangle and the point, times six.
double six_volumes(const Points& vertices, const Eigen::RowVector3d& point,
                   const Eigen::RowVector3i& triangle) {
  const Eigen::Vector3d a = vertices.row(triangle[0]) - point;
  const Eigen::Vector3d b = vertices.row(triangle[1]) - point;
  const Eigen::Vector3d c = vertices.row(triangle[2]) - point;
  return a.dot(b.cross(c));
}

}  // namespace

FaceChange face_change(const TriangleMesh& before, const std::vector<int>& moving,
                       const Points& after, const Prediction* refined) {
  FaceChange change;
  const Points moved_by = after(moving, Eigen::all) - before.vertices(moving, Eigen::all);
  change.displacement = moved_by.rowwise().norm();
  change.displacement_size = distance_statistics(change.displacement);
  if (moving.empty()) return change;
  // The faces share their rim: together they are closed, and by the divergence theorem the volume
  // between them is the difference of the two cones over any point.
  std::vector<bool> moves(static_cast<std::size_t>(before.vertices.rows()), false);
  for (const int v : moving) moves[static_cast<std::size_t>(v)] = true;
  const Eigen::RowVector3d point = before.vertices.row(moving.front());
  for (const auto triangle : before.triangles.rowwise()) {
    bool any = false;
    for (const int v : triangle) any = any || moves[static_cast<std::size_t>(v)];
    if (!any) continue;
    change.volume_mm3 +=
        (six_volumes(after, point, triangle) - six_volumes(before.vertices, point, triangle)) / 6;
    const Eigen::Vector3d a = before.vertices.row(triangle[0]);
    const Eigen::Vector3d b = before.vertices.row(triangle[1]);
    const Eigen::Vector3d c = before.vertices.row(triangle[2]);
    change.area_mm2 += (b - a).cross(c - a).norm() / 2;
  }
  if (refined != nullptr) {
    change.signed_mm = refined->signed_distance(moving);
    change.signed_size = distance_statistics(change.signed_mm);
    change.error = refined->answer.error.total;
  }
  return change;
}

}  // namespace gnathion
