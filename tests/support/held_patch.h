#pragma once

#include "fem/static_solver.h"
#include "geometry/rigid_motion.h"
#include "support/face_patch.h"
#include "tissue/st_generator.h"

namespace gnathion::testing {

/// Tissue 5 mm thick below a patch: the rim fixed, the inner points within `radius` mm of the
/// middle attached to a bone.
struct HeldPatch {
  SoftTissueMesh tissue;
  Supports supports;
};

inline HeldPatch held_patch(const TriangleMesh& mesh = hard_patch(1, 0), double radius = 12) {
  const IntermediateMesh region = whole_region(mesh);
  HeldPatch patch{st_generator(region, offset_directions(region, 5),
                               Eigen::VectorXd::Constant(region.mesh.vertices.rows(), 5)),
                  {}};
  const Points& x = patch.tissue.mesh.vertices;
  patch.supports.assign(static_cast<std::size_t>(x.rows()), Support::free);
  const Eigen::RowVector3d middle = x.topRows(patch.tissue.surface_count).colwise().mean();
  for (int v = 0; v < patch.tissue.surface_count; ++v) {
    if (region.rim[v]) {
      patch.supports[v] = patch.supports[patch.tissue.inner(v)] = Support::fixed;
    } else if ((x.row(v) - middle).head<2>().norm() < radius) {
      patch.supports[patch.tissue.inner(v)] = Support::attached;
    }
  }
  return patch;
}

/// Where a motion of the bone brings the attached points; zero for the others. n×3, mm.
inline Points attached_displacements(const HeldPatch& patch, const RigidMotion& motion) {
  Points u = moved(patch.tissue.mesh.vertices, motion) - patch.tissue.mesh.vertices;
  for (Eigen::Index i = 0; i < u.rows(); ++i) {
    if (patch.supports[i] != Support::attached) u.row(i).setZero();
  }
  return u;
}

}  // namespace gnathion::testing
