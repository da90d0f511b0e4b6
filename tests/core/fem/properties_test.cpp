// Properties that hold whatever the patch, the bones' motion and the material. The same cases every
// time; set RC_PARAMS to seed=… or max_success=… for others.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <random>

#include "fem/response_basis.h"
#include "support/sliding_patch.h"

namespace gnathion {
namespace {

using namespace testing;

[[maybe_unused]] const int kSeeded = setenv("RC_PARAMS", "seed=20161 max_success=40", 0);

/// A number between two, in steps of a thousandth of their distance.
rc::Gen<double> between(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1001),
                      [=](int step) { return low + (high - low) * step / 1000; });
}

Eigen::Vector3d vector(double size) {
  return {*between(-size, size), *between(-size, size), *between(-size, size)};
}

RigidMotion motion(double shift, double turn) {
  RigidMotion m;
  const Eigen::Vector3d axis = vector(1) + Eigen::Vector3d(0, 0, 1e-3);
  m.rotation = Eigen::AngleAxisd(*between(-turn, turn), axis.normalized()).toRotationMatrix();
  m.translation = vector(shift);
  return m;
}

/// Tissue below a bumpy patch of 80 to 140 vertices, held by its rim and two bones, of one or two
/// materials, in elements of either order.
struct Tissue {
  ElementMesh mesh;
  Supports supports;
  TissueMaterials materials;
  Progress progress;
  StaticSolver solver;

  static HeldPatch patch() {
    const int vertices = *rc::gen::inRange(80, 141);
    TriangleMesh mesh = flat_disk(vertices, 32 + 2 * (vertices % 3), 4);
    const double high = *between(-5, 5), wide = *between(6, 15), at = *between(-6, 6);
    raise(mesh, [&](double x, double y) {
      return high * bump(x, y, at, -at / 2, wide, wide) - (x * x + y * y) / 200;
    });
    return sliding_patch(mesh);
  }
  static TissueMaterials some_materials(Eigen::Index tets) {
    const ElasticMaterial one{*between(0.01, 3), *between(0, 0.499)};
    const ElasticMaterial other{*between(0.01, 3), *between(0, 0.499)};
    std::vector<unsigned char> kinds(static_cast<std::size_t>(tets));
    const int stride = *rc::gen::inRange(2, 9);
    for (std::size_t t = 0; t < kinds.size(); ++t) kinds[t] = t % stride == 0;
    return {{one, other}, kinds};
  }
  static ElementOrder some_order() {
    return *rc::gen::element(ElementOrder::linear, ElementOrder::quadratic);
  }

  Tissue() : Tissue(patch(), some_order()) {}
  Tissue(const HeldPatch& patch, ElementOrder order)
      : Tissue(ElementMesh(patch.tissue.mesh, order), patch.supports,
               some_materials(patch.tissue.mesh.tets.rows())) {}
  Tissue(const ElementMesh& elements, const Supports& of_vertices, const TissueMaterials& of)
      : mesh(elements),
        supports(supports_of_nodes(elements, of_vertices)),
        materials(of),
        solver(mesh, materials, supports, progress) {}

  Points zero() const { return Points::Zero(mesh.nodes.rows(), 3); }
  Points moved_by(const std::array<RigidMotion, 2>& motions) const {
    return solver.solve(bone_displacements(mesh.nodes, supports, motions), zero()).displacements;
  }
  Points loaded_by(const Points& forces) const {
    return solver.solve(zero(), forces).displacements;
  }
  /// A force on some nodes, N.
  Points some_forces() const {
    Points f = zero();
    for (int k = 0; k < 5; ++k) {
      f.row(*rc::gen::inRange<Eigen::Index>(0, f.rows())) += vector(0.1).transpose();
    }
    return f;
  }
  double energy(const Points& u) const {
    return (u.array() * (solver.stiffness() * u).array()).sum() / 2;
  }
};

double dot(const Points& a, const Points& b) {
  return (a.array() * b.array()).sum();
}

RC_GTEST_PROP(Property, DisplacementsAreLinearInWhatIsPrescribedAndInForces, ()) {
  const Tissue tissue;
  const Points f = tissue.some_forces(), g = tissue.some_forces();
  const double a = *between(-3, 3), b = *between(-3, 3);
  const Points sum = a * tissue.loaded_by(f) + b * tissue.loaded_by(g);
  const double size = tissue.loaded_by(f).norm() + tissue.loaded_by(g).norm();
  RC_ASSERT((tissue.loaded_by(a * f + b * g) - sum).norm() <= 1e-10 * size);

  const Points bone = bone_displacements(tissue.mesh.nodes, tissue.supports,
                                         std::array{motion(8, 0.5), motion(8, 0.5)});
  const Points both = tissue.solver.solve(a * bone, f).displacements;
  const Points apart =
      a * tissue.solver.solve(bone, tissue.zero()).displacements + tissue.loaded_by(f);
  RC_ASSERT((both - apart).norm() <= 1e-10 * (both.norm() + apart.norm() + size));
}

RC_GTEST_PROP(Property, ResponsesAreReciprocal, ()) {  // Betti 1872
  const Tissue tissue;
  const Points f = tissue.some_forces(), g = tissue.some_forces();
  const double there = dot(f, tissue.loaded_by(g)), back = dot(g, tissue.loaded_by(f));
  const double size = f.norm() * tissue.loaded_by(g).norm();
  RC_ASSERT(std::abs(there - back) <= 1e-10 * size);
}

RC_GTEST_PROP(Property, StifferTissueMovesLessInProportionAndBonesAsBefore, ()) {
  const Tissue tissue;
  const double factor = *between(0.1, 50);
  TissueMaterials stiff = tissue.materials;
  for (ElasticMaterial& kind : stiff.kinds) kind.young_MPa *= factor;
  const Tissue stiffer(
      tissue.mesh,
      Supports(tissue.supports.begin(), tissue.supports.begin() + tissue.mesh.vertex_count), stiff);
  const Points f = tissue.some_forces();
  const Points u = tissue.loaded_by(f);
  RC_ASSERT((factor * stiffer.loaded_by(f) - u).norm() <= 1e-9 * u.norm());
  const std::array motions{motion(8, 0.5), motion(8, 0.5)};
  const Points v = tissue.moved_by(motions);
  RC_ASSERT((stiffer.moved_by(motions) - v).norm() <= 1e-9 * v.norm());
}

RC_GTEST_PROP(Property, TheFrameDoesNotMatter, ()) {
  const HeldPatch patch = Tissue::patch();
  const ElementOrder order = Tissue::some_order();
  const TissueMaterials materials = Tissue::some_materials(patch.tissue.mesh.tets.rows());
  const RigidMotion frame = motion(500, 3);
  TetMesh seen = patch.tissue.mesh;
  seen.vertices = moved(seen.vertices, frame);
  Supports seen_supports = patch.supports;
  for (Support& s : seen_supports) s.normal = (frame.rotation * s.normal).eval();
  const Tissue here(ElementMesh(patch.tissue.mesh, order), patch.supports, materials);
  const Tissue there(ElementMesh(seen, order), seen_supports, materials);
  const std::array shifts{vector(8), vector(8)};
  std::array<RigidMotion, 2> motions, seen_motions;
  for (std::size_t b = 0; b < 2; ++b) {
    motions[b].translation = shifts[b];
    seen_motions[b].translation = frame.rotation * shifts[b];
  }
  const Points u = here.moved_by(motions) * frame.rotation.transpose();
  RC_ASSERT((there.moved_by(seen_motions) - u).norm() <= 1e-9 * (u.norm() + 1e-9));
}

RC_GTEST_PROP(Property, NoOtherFieldWithTheSameSupportsStoresLessEnergy, ()) {
  const Tissue tissue;
  const Points u = tissue.moved_by({motion(8, 0.5), motion(8, 0.5)});
  Eigen::VectorXd other(tissue.solver.free_part().size());
  std::mt19937 random(*rc::gen::inRange(0u, 1000000u));
  for (double& q : other) q = static_cast<double>(random()) / 4294967296.0 - 0.5;
  Points v = u;
  tissue.solver.free_part().add(other, *between(-1, 1), v);
  RC_ASSERT(tissue.energy(v) >= tissue.energy(u) * (1 - 1e-12));
  RC_ASSERT(tissue.energy(u) >= 0);
}

RC_GTEST_PROP(Property, QuadraticElementsStoreNoMoreEnergyThanLinearOnes, ()) {
  // A linear field is also a quadratic one, of the same energy. Bones attached, none sliding: the
  // middle of an edge between normals that differ follows neither.
  HeldPatch patch = Tissue::patch();
  for (Support& s : patch.supports) {
    if (s == Support::sliding) s = Support(Support::attached, s.body);
  }
  const TissueMaterials materials = Tissue::some_materials(patch.tissue.mesh.tets.rows());
  const Tissue linear(ElementMesh(patch.tissue.mesh), patch.supports, materials);
  const Tissue quadratic(ElementMesh(patch.tissue.mesh, ElementOrder::quadratic), patch.supports,
                         materials);
  const std::array motions{motion(8, 0.5), motion(8, 0.5)};
  const Points u = linear.moved_by(motions), v = quadratic.moved_by(motions);
  const double embedded = quadratic.energy(quadratic.mesh.from_vertices(u));
  RC_ASSERT(std::abs(embedded - linear.energy(u)) <= 1e-10 * embedded);
  RC_ASSERT(quadratic.energy(v) <= embedded * (1 + 1e-12));
}

RC_GTEST_PROP(Property, TheResponseBasisEqualsTheDirectSolve, ()) {
  const Tissue tissue;
  const Eigen::Vector3d middle = tissue.mesh.nodes.colwise().mean();
  const ResponseBasis basis =
      response_basis(tissue.solver, {middle + vector(20), middle + vector(20)});
  const std::array motions{motion(20, 1.5), motion(20, 1.5)};
  const Points direct = tissue.moved_by(motions);
  Points fast;
  basis.displacements(motions, fast);
  RC_ASSERT((fast - direct).norm() <= 1e-10 * (direct.norm() + 1));
}

}  // namespace
}  // namespace gnathion
