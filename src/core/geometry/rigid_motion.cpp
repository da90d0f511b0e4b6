#include "geometry/rigid_motion.h"

namespace gnathion {

Points moved(const Points& points, const RigidMotion& motion) {
  return (points * motion.rotation.transpose()).rowwise() + motion.translation.transpose();
}

Points moved(const Points& points, const Similarity& similarity) {
  return (similarity.scale * points * similarity.rotation.transpose()).rowwise() +
         similarity.translation.transpose();
}

}  // namespace gnathion
