#include "bone/condyles.h"

#include <Eigen/Geometry>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geometry/bsp_tree.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

// Of adults, with room on either side (Gray's Anatomy, 41st ed., ch. 32: bicondylar breadth about
// 120 mm, condylar head 15–20 mm across and 8–10 mm from front to back, ramus about 60 mm high).
constexpr double kTallestJaw = 135;    // mm; a piece that is taller holds the skull
constexpr double kLeastBreadth = 60;   // mm between the condyles
constexpr double kMostBreadth = 140;   // mm
constexpr double kLeastHeight = 30;    // mm from the lower border to the condyles
constexpr double kLeastDepth = 40;     // mm from the chin back to the condyles
constexpr double kMostAsymmetry = 18;  // mm, in height and in depth
constexpr double kAside = 20;          // mm from the middle: nothing medial of that is a ramus
constexpr double kSlice = 2.5;         // mm
constexpr double kHeadHeight = 10;     // mm from the condyle's top to its neck
constexpr double kHeadReach = 14;      // mm from the top to the head's ends

[[noreturn]] void refuse(const std::string& problem) {
  throw Error(ErrorKind::anatomy, "condyles", problem,
              "type two points of the hinge axis, or choose a bone level (HU) at which the lower "
              "jaw stands alone and a CT that holds both joints");
}

/// The vertices of the connected piece nearest to a point.
Points piece_at(const TriangleMesh& bone, const Eigen::Vector3d& point) {
  const auto nearest = BspTree(bone).nearest(point, std::numeric_limits<double>::infinity());
  if (!nearest) refuse("there is no bone");
  const std::vector<int> piece = triangle_components(bone);
  std::vector<bool> keep(piece.size());
  const int wanted = piece[static_cast<std::size_t>(nearest->triangle)];
  for (std::size_t f = 0; f < piece.size(); ++f) keep[f] = piece[f] == wanted;
  return sub_mesh(bone, keep).mesh.vertices;
}

/// The centre of the head on one side; side: +1 left, −1 right.
Eigen::Vector3d head_centre(const Points& jaw, double middle, int side) {
  // Upwards and backwards alike: the coronoid process may be as high but lies before the condyle,
  // the angle of the jaw as far back but lies below it.
  const Eigen::Vector3d direction(0, 1, 1);
  Eigen::Vector3d top = Eigen::Vector3d::Zero();
  double most = -std::numeric_limits<double>::infinity();
  for (Eigen::Index v = 0; v < jaw.rows(); ++v) {
    const Eigen::Vector3d p = jaw.row(v);
    if (side * (p.x() - middle) < kAside || p.dot(direction) <= most) continue;
    most = p.dot(direction);
    top = p;
  }
  if (most == -std::numeric_limits<double>::infinity()) refuse("the lower jaw has one side only");
  Eigen::AlignedBox3d head;
  for (Eigen::Index v = 0; v < jaw.rows(); ++v) {
    const Eigen::Vector3d p = jaw.row(v);
    if ((p - top).norm() < kHeadReach && p.z() > top.z() - kHeadHeight) head.extend(p);
  }
  return {head.center().x(), head.center().y(), head.max().z() - kHeadHeight / 2};
}

void check(const Condyles& condyles, const Eigen::AlignedBox3d& jaw) {
  const Eigen::Vector3d across = condyles.left - condyles.right;
  const Eigen::Vector3d centre = (condyles.left + condyles.right) / 2;
  const bool placed =
      across.norm() > kLeastBreadth && across.norm() < kMostBreadth &&
      std::abs(across.y()) < kMostAsymmetry && std::abs(across.z()) < kMostAsymmetry &&
      centre.z() - jaw.min().z() > kLeastHeight && centre.y() - jaw.min().y() > kLeastDepth;
  if (!placed) refuse("the ends of this piece of bone do not lie as two condyles do");
}

}  // namespace

Condyles find_condyles(const TriangleMesh& bone, const Eigen::Vector3d& on_mandible) {
  const Points jaw = piece_at(bone, on_mandible);
  Eigen::AlignedBox3d box;
  for (Eigen::Index v = 0; v < jaw.rows(); ++v) box.extend(jaw.row(v).transpose());
  if (box.sizes().z() > kTallestJaw) {
    refuse("the lower jaw and the skull are one piece at this bone level");
  }
  // A jaw that ends where all bone ends, to a slice, is cut off by the CT's upper end.
  if (box.max().z() > bone.vertices.col(2).maxCoeff() - kSlice) {
    refuse("the CT ends below the condyles");
  }
  const double middle = box.center().x();
  Condyles condyles{head_centre(jaw, middle, -1), head_centre(jaw, middle, 1)};
  check(condyles, box);
  return condyles;
}

}  // namespace gnathion
