#include "fem/linearisation_error.h"

#include <algorithm>

#include "base/error.h"
#include "fem/neo_hookean.h"

namespace gnathion {
namespace {

/// The largest change of u along an edge, over the edge's length: a bound of ∂u/∂X, but for the
/// shape of the tets.
double steepest(const ElementMesh& mesh, const Points& u) {
  double steepest = 0;
  for (const auto& element : mesh.elements.rowwise()) {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < a; ++b) {
        const double change = (u.row(element[a]) - u.row(element[b])).norm();
        const double length = (mesh.nodes.row(element[a]) - mesh.nodes.row(element[b])).norm();
        steepest = std::max(steepest, change / length);
      }
    }
  }
  return steepest;
}

}  // namespace

Points second_order_correction(const StaticSolver& linear, const Points& u) {
  if (!u.allFinite()) {
    throw Error(ErrorKind::numeric, "linearisation error", "a displacement is not finite",
                "report this case: it is a fault of the program");
  }
  const double slope = steepest(linear.elements(), u);
  if (slope == 0) return Points::Zero(u.rows(), 3);
  const NeoHookeanTissue tissue(linear.elements(), linear.materials());
  double s = 1e-3 / slope;
  Points force;
  while (!tissue.internal_force(s * u, force)) s /= 10;  // a sliver can bend much at a small slope
  const Points second = (force - linear.stiffness() * (s * u)) / (s * s);
  const FreePart& free = linear.free_part();
  Points correction = Points::Zero(u.rows(), 3);
  free.add(Eigen::VectorXd(linear.factor().solve(free.gather(second))), -1, correction);
  return correction;
}

Eigen::VectorXd linearisation_error(const StaticSolver& linear, const Points& u) {
  return second_order_correction(linear, u).rowwise().norm();
}

}  // namespace gnathion
