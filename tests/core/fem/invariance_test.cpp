// What must not change the answer, and what must.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <random>

#include "fem/static_solver.h"
#include "support/sliding_patch.h"

namespace gnathion {
namespace {

using namespace testing;

/// A patch and where two bones bring it.
struct Scene {
  TetMesh mesh;
  Supports supports;  ///< of the vertices
  std::array<RigidMotion, 2> motions;
  TissueMaterials materials;
};

Scene scene() {
  const HeldPatch patch = sliding_patch();
  Scene s{patch.tissue.mesh, patch.supports, {}, {}};
  s.motions[0].translation << 1, -3, 2;
  s.motions[1].rotation =
      Eigen::AngleAxisd(0.1, Eigen::Vector3d(0.2, 1, 0).normalized()).toRotationMatrix();
  s.motions[1].translation << -1, 2, 3;
  return s;
}

/// Displacements of the vertices.
Points answer(const Scene& s, ElementOrder order) {
  const ElementMesh mesh(s.mesh, order);
  const Supports supports = supports_of_nodes(mesh, s.supports);
  Progress progress;
  return StaticSolver(mesh, s.materials, supports, progress)
      .solve(bone_displacements(mesh.nodes, supports, s.motions),
             Points::Zero(mesh.nodes.rows(), 3))
      .displacements.topRows(mesh.vertex_count);
}

/// The same scene seen from elsewhere: x' = frame(x).
Scene seen_from(Scene s, const RigidMotion& frame) {
  const Eigen::Matrix3d R = frame.rotation;
  s.mesh.vertices = moved(s.mesh.vertices, frame);
  for (Support& support : s.supports) support.normal = (R * support.normal).eval();
  for (RigidMotion& motion : s.motions) {
    // frame ∘ motion ∘ frame⁻¹
    motion.rotation = (R * motion.rotation * R.transpose()).eval();
    motion.translation =
        (R * motion.translation + frame.translation - motion.rotation * frame.translation).eval();
  }
  return s;
}

class Invariance : public ::testing::TestWithParam<ElementOrder> {};
INSTANTIATE_TEST_SUITE_P(Both, Invariance,
                         ::testing::Values(ElementOrder::linear, ElementOrder::quadratic),
                         [](const auto& order) {
                           return order.param == ElementOrder::linear ? "linear" : "quadratic";
                         });

TEST_P(Invariance, TheOrderOfNodesAndTetsDoesNotMatter) {
  const Scene original = scene();
  Scene shuffled = original;
  std::mt19937 random(5);
  std::vector<int> place(original.supports.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  for (std::size_t i = 0; i < place.size(); ++i) {
    shuffled.mesh.vertices.row(place[i]) = original.mesh.vertices.row(static_cast<Eigen::Index>(i));
    shuffled.supports[place[i]] = original.supports[i];
  }
  std::vector<int> tets(static_cast<std::size_t>(original.mesh.tets.rows()));
  std::iota(tets.begin(), tets.end(), 0);
  std::shuffle(tets.begin(), tets.end(), random);
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto old = original.mesh.tets.row(static_cast<Eigen::Index>(t));
    // An even permutation of the corners, which keeps the volume's sign.
    shuffled.mesh.tets.row(tets[t]) << place[old[2]], place[old[0]], place[old[1]], place[old[3]];
  }
  const Points u = answer(original, GetParam()), v = answer(shuffled, GetParam());
  double largest = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    largest = std::max(largest, (u.row(static_cast<Eigen::Index>(i)) - v.row(place[i])).norm());
  }
  EXPECT_LT(largest, 1e-11);
}

TEST_P(Invariance, ARigidFrameDoesNotMatter) {
  RigidMotion frame;
  frame.rotation =
      Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -0.4, 0.7).normalized()).toRotationMatrix();
  frame.translation << 120, -340, 900;
  const Scene original = scene();
  const Points u = answer(original, GetParam()) * frame.rotation.transpose();
  const Points v = answer(seen_from(original, frame), GetParam());
  EXPECT_LT((u - v).rowwise().norm().maxCoeff(), 1e-10);
}

TEST_P(Invariance, AMillionMillimetresFromTheOriginCostsNoMoreThanTheDigitsOfTheCoordinates) {
  // Coordinates of 1e6 mm are known to 1e-10 mm; measured: displacements to 3e-10 mm.
  RigidMotion frame;
  frame.translation << 1e6, -1e6, 1e6;
  const Scene original = scene();
  const Points u = answer(original, GetParam());
  const Points v = answer(seen_from(original, frame), GetParam());
  EXPECT_LT((u - v).rowwise().norm().maxCoeff(), 1e-8);
}

TEST_P(Invariance, YoungsModulusDropsOutWithOneMaterialAndNotWithTwo) {
  Scene s = scene();
  s.materials = ElasticMaterial{0.01, 0.46};
  const Points soft = answer(s, GetParam());
  s.materials = ElasticMaterial{300, 0.46};
  EXPECT_LT((answer(s, GetParam()) - soft).norm(), 1e-11 * soft.norm());

  std::vector<unsigned char> kinds(static_cast<std::size_t>(s.mesh.tets.rows()));
  for (std::size_t t = 0; t < kinds.size(); ++t) kinds[t] = t % 2 == 0;
  s.materials = {{{1, 0.46}, {10, 0.46}}, kinds};
  const Points two = answer(s, GetParam());
  EXPECT_GT((two - soft).norm(), 0.01 * soft.norm());
  s.materials = {{{7, 0.46}, {70, 0.46}}, kinds};
  EXPECT_LT((answer(s, GetParam()) - two).norm(), 1e-11 * two.norm())
      << "only the ratio of the two matters";
}

}  // namespace
}  // namespace gnathion
