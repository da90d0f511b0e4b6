#include "projection/skin_sight.h"

#include <utility>

#include "base/error.h"

namespace gnathion {
namespace {

TriangleMesh checked(TriangleMesh skin) {
  if (skin.triangles.rows() == 0) {
    throw Error(ErrorKind::anatomy, "the CT's skin", "has no triangle",
                "choose another level for the skin, or another series");
  }
  return skin;
}

}  // namespace

SkinSight::SkinSight(TriangleMesh skin)
    : mesh_(checked(std::move(skin))), normals_(vertex_normals(mesh_)), tree_(mesh_) {}

bool SkinSight::hides(const Eigen::Vector3d& point, const Eigen::Vector3d& eye,
                      double clear) const {
  const Eigen::Vector3d away = point - eye;
  const double distance = away.norm();
  if (distance <= clear) return false;
  return tree_.first_hit(eye, away / distance, distance - clear).has_value();
}

}  // namespace gnathion
