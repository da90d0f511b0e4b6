#pragma once

#include <cmath>

#include "fem/static_solver.h"
#include "support/fields.h"
#include "support/tet_solids.h"

namespace gnathion::testing {

/// The error of a thick sphere, radii 10 and 20 mm, under pressure from within (Lamé 1852):
///   u_r = p a³/(E (b³ − a³)) ((1 − 2ν) r + (1 + ν) b³/(2 r²)).
/// An eighth of it, n cells along each side: its planes of symmetry slide. Where two planes meet a
/// node would need two normals; the exact displacement is given there. Returns the relative L2
/// error at the vertices.
inline double lame_error(ElementOrder order, double poisson, int n) {
  const double a = 10, b = 20, pressure = 0.01, nowhere = 1e-9;
  const ElementMesh mesh(tet_shell_eighth(a, b, n, n), order);
  const auto field = [&](const Eigen::Vector3d& x) {
    const double r = x.norm(), scale = pressure * a * a * a / (b * b * b - a * a * a);
    return Eigen::Vector3d(
        scale * ((1 - 2 * poisson) * r + (1 + poisson) * b * b * b / (2 * r * r)) * x / r);
  };
  Supports supports(static_cast<std::size_t>(mesh.nodes.rows()));
  for (Eigen::Index i = 0; i < mesh.nodes.rows(); ++i) {
    int planes = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (mesh.nodes(i, axis) > nowhere) continue;
      ++planes;
      supports[i] = Support::slides(Eigen::Vector3d::Unit(axis), Support::kUnmoved);
    }
    if (planes == 2) supports[i] = Support::attached;
  }
  const Points exact = sampled(mesh.nodes, field);
  const Points forces = traction_forces(
      mesh, [&](const Eigen::Vector3d& x) { return x.norm() < a + 1e-6; },
      [&](const Eigen::Vector3d&, const Eigen::Vector3d& normal) {
        return Eigen::Vector3d(-pressure * normal);
      });
  Progress progress;
  const StaticSolver solver(mesh, ElasticMaterial{1, poisson}, supports, progress);
  const Points u = solver.solve(exact, forces).displacements;
  const Eigen::VectorXd mass =
      lumped_mass({{mesh.nodes.topRows(mesh.vertex_count), mesh.elements.leftCols<4>()}}, 1);
  const auto norm = [&](const Points& f) {
    return std::sqrt(f.topRows(mesh.vertex_count).rowwise().squaredNorm().dot(mass));
  };
  return norm(u - exact) / norm(exact);
}

}  // namespace gnathion::testing
