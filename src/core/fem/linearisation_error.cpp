#include "fem/linearisation_error.h"

#include "base/error.h"

namespace gnathion {

Points linearisation_error(const StaticSolver& linear, const Points& u) {
  if (!u.allFinite()) {
    throw Error(ErrorKind::numeric, "error estimate", "the displacements are not finite",
                "report this case: it is a fault of the program");
  }
  const NeoHookeanTissue tissue(linear.elements(), linear.materials());
  // Close to where tissue turns inside out its force is far from any straight line; up to this part
  // of the way the second order still tells.
  constexpr double kSafe = 0.5;
  Points force;
  double part = 1;
  while (!tissue.internal_force(part * u, force)) part *= kSafe;
  if (part < 1) {
    part *= kSafe;
    (void)tissue.internal_force(part * u, force);
  }
  const FreePart& free = linear.free_part();
  const Eigen::VectorXd q = linear.factor().solve(-free.gather(force));
  Points error = Points::Zero(u.rows(), 3);
  free.add(q, 1 / (part * part), error);
  return error;
}

}  // namespace gnathion
