#pragma once

#include <cmath>

#include "fem/static_solver.h"
#include "geometry/rigid_motion.h"
#include "support/face_patch.h"
#include "tissue/st_generator.h"

namespace gnathion::bench {

/// Tissue 5 mm thick below a lower face: its rim fixed, the inner points below the chin attached to
/// a bone.
struct ChinProblem {
  IntermediateMesh region;
  Points directions;
  Eigen::VectorXd depth;
  SoftTissueMesh tissue;
  Supports supports;
  Eigen::Vector3d centre;
};

/// `size`: the patch's, as a multiple of the lower face's own.
inline ChinProblem chin_problem(const TriangleMesh& mesh, double size = 1) {
  ChinProblem p{testing::whole_region(mesh), {}, {}, {}, {}, {}};
  p.directions = offset_directions(p.region, 5);
  p.depth = Eigen::VectorXd::Constant(mesh.vertices.rows(), 5);
  p.tissue = st_generator(p.region, p.directions, p.depth);
  p.supports.assign(static_cast<std::size_t>(p.tissue.mesh.vertices.rows()), Support::free);
  const Eigen::RowVector3d middle = mesh.vertices.colwise().mean();
  p.centre = middle.transpose();
  for (int v = 0; v < p.tissue.surface_count; ++v) {
    const Eigen::RowVector3d x = (mesh.vertices.row(v) - middle) / size;
    if (p.region.rim[v]) {
      p.supports[v] = p.supports[p.tissue.inner(v)] = Support::fixed;
    } else if (std::hypot(x[0] / 25, (x[1] + 18) / 15) < 1) {
      p.supports[p.tissue.inner(v)] = Support::attached;
    }
  }
  return p;
}

/// The motion that the chin is measured with: 5 mm along z and 0.05 rad about x.
inline RigidMotion chin_motion(const ChinProblem& p) {
  RigidMotion motion;
  motion.rotation = Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitX()).toRotationMatrix();
  motion.translation = p.centre - motion.rotation * p.centre + Eigen::Vector3d(0, 0, 5);
  return motion;
}

}  // namespace gnathion::bench
