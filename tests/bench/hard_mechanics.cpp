#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "bench/hard_cases.h"
#include "fem/damped_motion.h"
#include "fem/neo_hookean_solver.h"
#include "fem/quadratic_correction.h"
#include "fem/response_basis.h"
#include "geometry/tet_quality.h"
#include "support/fields.h"
#include "support/sliding_patch.h"
#include "support/tet_solids.h"
#include "support/thick_sphere.h"

namespace gnathion::bench {
namespace {

using namespace testing;

constexpr ElementOrder kLinear = ElementOrder::linear, kQuadratic = ElementOrder::quadratic;

StaticSolver solver_of(const ElementMesh& mesh, const TissueMaterials& materials,
                       const Supports& supports) {
  Progress progress;
  return StaticSolver(mesh, materials, supports, progress);
}

StaticSolver solver_of(const HeldPatch& patch) {
  return solver_of(ElementMesh(patch.tissue.mesh), {}, patch.supports);
}

Points none(const StaticSolver& solver) {
  return Points::Zero(solver.elements().nodes.rows(), 3);
}

double largest(const Points& u) {
  return u.rowwise().norm().maxCoeff();
}

RigidMotion shifted(double x, double y, double z) {
  RigidMotion motion;
  motion.translation << x, y, z;
  return motion;
}

/// Turned about the middle of a patch.
RigidMotion turned(const HeldPatch& patch, double degrees, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d middle = patch.tissue.mesh.vertices.colwise().mean();
  RigidMotion motion;
  motion.rotation = Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()).toRotationMatrix();
  motion.translation = middle - motion.rotation * middle;
  return motion;
}

Points linear_answer(const StaticSolver& solver, const std::vector<RigidMotion>& motions) {
  const Points bone = bone_displacements(solver.elements().nodes, solver.supports(), motions);
  return solver.solve(bone, none(solver)).displacements;
}

NeoHookeanSolution large_answer(const StaticSolver& solver, const std::vector<RigidMotion>& motions,
                                const NeoHookeanOptions& options = {}) {
  Progress progress;
  return NeoHookeanSolver(solver).solve(
      bone_path(solver.elements().nodes, solver.supports(), motions), none(solver), progress,
      options);
}

/// What an iterated quadratic correction, stopped as FaceModel does, leaves of the solution that a
/// factor of the quadratic equations gives; mean on the skin, mm, at 5 mm.
double iterated_against_factorised(double poisson) {
  const HeldPatch patch = held_patch();
  const ElasticMaterial material{1, poisson};
  const StaticSolver linear = solver_of(ElementMesh(patch.tissue.mesh), material, patch.supports);
  const ElementMesh mesh(patch.tissue.mesh, kQuadratic);
  const StaticSolver direct = solver_of(mesh, material, supports_of_nodes(mesh, patch.supports));
  const std::vector<RigidMotion> motions{shifted(0, 3, 4)};
  const Points u = linear_answer(linear, motions);
  Progress progress;
  const Eigen::MatrixXd column = u.reshaped<Eigen::RowMajor>();
  const Eigen::VectorXd corrected =
      column + QuadraticCorrection(linear, progress).correct(column, progress, 500, 1e-3);
  const Points difference = Eigen::Map<const Points>(corrected.data(), u.rows(), 3) -
                            linear_answer(direct, motions).topRows(u.rows());
  return difference.topRows(patch.tissue.surface_count).rowwise().norm().mean();
}

/// Two layers in series, one a million times as stiff, without Poisson's ratio: closed form.
double layered_error() {
  const TetMesh box = tet_box({10, 10, 10}, {4, 4, 4});
  TissueMaterials materials({{1, 0}, {1e6, 0}}, {});
  Supports supports(static_cast<std::size_t>(box.vertices.rows()));
  Points exact = Points::Zero(box.vertices.rows(), 3);
  const double soft = 1 / (1 + 1e-6);  // of the stretch of 1 mm
  for (Eigen::Index i = 0; i < box.vertices.rows(); ++i) {
    const double z = box.vertices(i, 2);
    if (z < 1e-9) supports[i] = Support::fixed;
    if (z > 10 - 1e-9) supports[i] = Support::attached;
    exact(i, 2) = z < 5 ? soft * z / 5 : soft + (1 - soft) * (z - 5) / 5;
  }
  for (const auto tet : box.tets.rowwise()) {
    double z = 0;
    for (const int node : tet) z += box.vertices(node, 2) / 4;
    materials.of_tet.push_back(z > 5);
  }
  const StaticSolver solver = solver_of(ElementMesh(box), materials, supports);
  return largest(solver.solve(exact, none(solver)).displacements - exact);
}

/// Soft and stiff tets at random: the direct solve's residual.
double scattered_residual() {
  const HeldPatch patch = held_patch();
  std::mt19937 random(1);
  TissueMaterials materials({{1, 0.46}, {1e6, 0.46}}, {});
  for (Eigen::Index t = 0; t < patch.tissue.mesh.tets.rows(); ++t) {
    materials.of_tet.push_back(random() % 2 == 0);
  }
  const StaticSolver solver = solver_of(ElementMesh(patch.tissue.mesh), materials, patch.supports);
  const std::vector<RigidMotion> motions{shifted(0, 3, 4)};
  return solver
      .solve(bone_displacements(solver.elements().nodes, solver.supports(), motions), none(solver))
      .relative_residual;
}

/// A linear field on a box whose inner nodes are pressed against the next ones above until tets are
/// 1e-6 as thick as they were: it must come back.
double sliver_error() {
  TetMesh box = tet_box({10, 10, 10}, {4, 4, 4});
  for (auto x : box.vertices.rowwise()) {
    const bool inner = (x.array() > 1e-9).all() && (x.array() < 10 - 1e-9).all();
    if (inner && std::abs(x[2] - 5) < 1e-9) x[2] = 7.5 - 2.5e-6;
  }
  Eigen::Matrix3d slope;
  slope << 0.01, 0.02, -0.01, 0.03, -0.02, 0.01, 0.02, 0.01, 0.03;
  const Points exact = box.vertices * slope.transpose();
  Supports supports(static_cast<std::size_t>(box.vertices.rows()));
  for (Eigen::Index i = 0; i < box.vertices.rows(); ++i) {
    const auto x = box.vertices.row(i).array();
    if (!((x > 1e-9).all() && (x < 10 - 1e-9).all())) supports[i] = Support::attached;
  }
  const StaticSolver solver = solver_of(ElementMesh(box), {}, supports);
  return largest(solver.solve(exact, none(solver)).displacements - exact);
}

/// Thin tissue cannot shear: how far the skin over the middle of the bone lags behind it, mm.
double thin_tissue_lag() {
  const IntermediateMesh region = whole_region(hard_patch(1, 0));
  const auto depths = Eigen::VectorXd::Constant(region.mesh.vertices.rows(), 0.5);
  HeldPatch patch = held_patch();
  patch.tissue = st_generator(region, offset_directions(region, 0.5), depths);
  const StaticSolver solver = solver_of(patch);
  const RigidMotion motion = shifted(0, 3, 4);
  const Points u = linear_answer(solver, {motion});
  const Points& x = patch.tissue.mesh.vertices;
  const Eigen::RowVector3d middle = x.topRows(patch.tissue.surface_count).colwise().mean();
  double lag = 0;
  for (int v = 0; v < patch.tissue.surface_count; ++v) {
    if ((x.row(v) - middle).head<2>().norm() > 8) continue;
    lag = std::max(lag, (u.row(v) - motion.translation.transpose()).norm());
  }
  return lag;
}

/// A flat patch 40 mm thick, its whole inside driven and its rim free in one motion: it must follow
/// rigidly whatever the thickness. Largest departure, mm.
double thick_tissue_error() {
  const IntermediateMesh region = whole_region(hard_patch(3, 0));
  const auto depths = Eigen::VectorXd::Constant(region.mesh.vertices.rows(), 40);
  RobustGeneratorOptions layered;
  layered.layers = {};
  const SoftTissueMesh tissue =
      st_generator(region, offset_directions(region, 40), depths, layered);
  Supports supports(static_cast<std::size_t>(tissue.mesh.vertices.rows()));
  for (int v = 0; v < tissue.surface_count; ++v) supports[tissue.inner(v)] = Support::attached;
  const StaticSolver solver = solver_of(ElementMesh(tissue.mesh), {}, supports);
  const RigidMotion motion = shifted(1, -3, 5);
  return largest(linear_answer(solver, {motion}).rowwise() - motion.translation.transpose());
}

/// Inverted tets and mean depth lost, of 12 pairs of lips with tissue 8 mm deep.
HardOutcome deep_lips() {
  long inverted = 0;
  double kept = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    const IntermediateMesh region = whole_region(hard_patch(1, seed));
    const auto depths = Eigen::VectorXd::Constant(region.mesh.vertices.rows(), 8);
    const SoftTissueMesh tissue = st_generator(region, offset_directions(region, 8), depths);
    inverted += tet_quality(tissue.mesh).inverted;
    kept += tissue.depth.mean() / 8 / 12;
  }
  return {std::to_string(inverted) + " inverted, " + std::to_string(std::lround(100 * kept)) +
              " % of the depth",
          inverted == 0 && kept > 0.8};
}

/// Every node attached: nothing is left to solve for.
double everything_driven_error() {
  const HeldPatch patch = held_patch();
  const Supports supports(patch.supports.size(), Support::attached);
  const StaticSolver solver = solver_of(ElementMesh(patch.tissue.mesh), {}, supports);
  const RigidMotion motion = turned(patch, 30, {1, 2, 3});
  const Points& x = patch.tissue.mesh.vertices;
  return largest(linear_answer(solver, {motion}) - (moved(x, motion) - x));
}

/// Two segments that do not touch: what they do together is the sum of what they do alone.
double superposition_error() {
  const StaticSolver solver = solver_of(sliding_patch());
  const RigidMotion a = shifted(3, 0, 2), b = shifted(-3, 1, 0), still;
  const Points sum = linear_answer(solver, {a, still}) + linear_answer(solver, {still, b});
  return largest(linear_answer(solver, {a, b}) - sum);
}

/// Two bones with 4 mm of tissue between them, each moved 2.5 mm towards the other.
void pressed_between_segments() {
  const TetMesh box = tet_box({8, 8, 4}, {4, 4, 2});
  Supports supports(static_cast<std::size_t>(box.vertices.rows()));
  for (Eigen::Index i = 0; i < box.vertices.rows(); ++i) {
    if (box.vertices(i, 2) < 1e-9) supports[i] = Support(Support::attached, 0);
    if (box.vertices(i, 2) > 4 - 1e-9) supports[i] = Support(Support::attached, 1);
  }
  large_answer(solver_of(ElementMesh(box), {}, supports),
               {shifted(0, 0, 2.5), shifted(0, 0, -2.5)});
}

/// How far a neo-Hookean answer is from the one by Newton's method alone, mm.
double against_newton(const HeldPatch& patch, const RigidMotion& motion) {
  const StaticSolver solver = solver_of(patch);
  NeoHookeanOptions newton;
  newton.frozen_factor = false;
  newton.tolerance = 1e-9;
  return largest(large_answer(solver, {motion}).displacements -
                 large_answer(solver, {motion}, newton).displacements);
}

/// A neo-Hookean state of equilibrium without a tet inside out, or a refusal that says how far the
/// tissue could follow.
HardCase answered_or_refused(const std::string& what,
                             const std::function<RigidMotion(const HeldPatch&)>& motion) {
  return {what, "equilibrium (residual ≤ 1e-06, J > 0), or refused (numeric), naming how far", [=] {
            const HeldPatch patch = held_patch();
            const StaticSolver solver = solver_of(patch);
            try {
              const NeoHookeanSolution answer = large_answer(solver, {motion(patch)});
              char text[100];
              std::snprintf(text, sizeof text, "residual %.0e, smallest J %.2f, %d load steps",
                            answer.relative_residual, answer.most_compressed.volume_ratio,
                            answer.load_steps);
              return HardOutcome{text, answer.relative_residual <= 1e-6 &&
                                           answer.most_compressed.volume_ratio > 0};
            } catch (const Error& error) {
              const bool names = error.problem().find('%') != std::string::npos;
              return HardOutcome{"refused: " + error.problem(),
                                 error.kind() == ErrorKind::numeric && names};
            }
          }};
}

/// Linear and neo-Hookean answers to 1e-9 mm, over the linear one.
double tiny_motion_error() {
  const StaticSolver solver = solver_of(held_patch());
  const RigidMotion motion = shifted(0, 6e-10, 8e-10);
  const Points u = linear_answer(solver, {motion});
  return largest(large_answer(solver, {motion}).displacements - u) / largest(u);
}

/// All supports turned together: the tissue must turn with them.
double turned_together_error(double degrees) {
  HeldPatch patch = held_patch();
  for (Support& support : patch.supports) {
    if (support == Support::fixed) support = Support::attached;
  }
  const StaticSolver solver = solver_of(patch);
  const RigidMotion motion = turned(patch, degrees, {1, 2, 3});
  const Points& x = patch.tissue.mesh.vertices;
  return largest(large_answer(solver, {motion}).displacements - (moved(x, motion) - x));
}

/// A step load in time: the largest energy over the first one, and the distance to the static
/// solution over its size after so many steps.
struct Settled {
  double energy = 0, distance = 0;
};
Settled settled(const DynamicsOptions& options, int steps) {
  const StaticSolver solver = solver_of(held_patch());
  const std::vector<RigidMotion> motions{shifted(0, 3, 4)};
  const Points answer = linear_answer(solver, motions);
  DampedMotion motion(solver, options);
  motion.set_prescribed(bone_displacements(solver.elements().nodes, solver.supports(), motions));
  const double first = motion.energy();
  Settled result;
  for (int step = 0; step < steps; ++step) {
    motion.step();
    const double energy = motion.energy() / first;
    result.energy = std::isfinite(energy) ? std::max(result.energy, energy) : energy;
  }
  result.distance = (motion.displacements() - answer).norm() / answer.norm();
  return result;
}

DynamicsOptions timed(double step, TimeScheme scheme, double alpha = 20, double beta = 0.01) {
  DynamicsOptions options;
  options.step = step;
  options.scheme = scheme;
  options.alpha = alpha;
  options.beta = beta;
  return options;
}

void add_materials(std::vector<HardCase>& all) {
  for (const double poisson : {0.49, 0.499, 0.4999}) {
    char name[80];
    std::snprintf(name, sizeof name, "ν = %g: Lamé's sphere, quadratic elements", poisson);
    all.push_back(bounded(name, "largest error over largest displacement", 0.02, "",
                          [poisson] { return lame_error(kQuadratic, poisson, 5); }));
  }
  for (const double poisson : {0.46, 0.499, 0.4999}) {
    char name[80];
    std::snprintf(name, sizeof name, "ν = %g: quadratic elements by iteration, 5 mm", poisson);
    all.push_back(bounded(name, "mean distance to the factorised solution", 0.05, "mm",
                          [poisson] { return iterated_against_factorised(poisson); }));
  }
  all.push_back(bounded("stiffness ratio 1e6 in two layers", "error against the closed form", 1e-8,
                        "mm", layered_error));
  all.push_back(bounded("stiffness ratio 1e6, tets at random", "relative residual", 1e-8, "",
                        scattered_residual));
  all.push_back(refused("ν = 0.5", ErrorKind::case_file, "tissue.poisson", "0.5", [] {
    solver_of(ElementMesh(held_patch().tissue.mesh), ElasticMaterial{1, 0.5},
              held_patch().supports);
  }));
}

void add_meshes(std::vector<HardCase>& all) {
  all.push_back(bounded("slivers of 1e-6 of their height", "error of a linear field", 1e-8, "mm",
                        sliver_error));
  all.push_back(bounded("tissue 0.5 mm thick, bone moved 5 mm",
                        "lag of the skin over the middle of the bone", 0.05, "mm",
                        thin_tissue_lag));
  all.push_back(bounded("tissue 40 mm thick in layers, its inside driven",
                        "departure from the bone's translation", 1e-9, "mm", thick_tissue_error));
  all.push_back({"concave lips, 12 pairs, tissue 8 mm deep",
                 "no tet inverted, 80 % of the depth kept", deep_lips});
  all.push_back(bounded("everything driven: every node attached, turned 30°",
                        "error against the rigid motion", 1e-12, "mm", everything_driven_error));
  all.push_back(refused("nothing held: no node supported", ErrorKind::numeric, "region",
                        "fixed or attached", [] {
                          const HeldPatch patch = held_patch();
                          solver_of(ElementMesh(patch.tissue.mesh), {},
                                    Supports(patch.supports.size(), Support::free));
                        }));
}

void add_motions(std::vector<HardCase>& all) {
  all.push_back(bounded("motion of 1e-9 mm", "neo-Hookean against linear, relative", 1e-6, "",
                        tiny_motion_error));
  all.push_back(bounded("motion of 20 mm, neo-Hookean", "distance to Newton's answer", 1e-3, "mm",
                        [] { return against_newton(held_patch(), shifted(0, 12, 16)); }));
  all.push_back(bounded("turn of 30°, rim fixed", "distance to Newton's answer", 1e-3, "mm", [] {
    const HeldPatch patch = held_patch();
    return against_newton(patch, turned(patch, 30, {0, 0, 1}));
  }));
  all.push_back(answered_or_refused("motion of 60 mm, rim fixed",
                                    [](const HeldPatch&) { return shifted(0, 36, 48); }));
  for (const double degrees : {90.0, 180.0}) {
    all.push_back(
        answered_or_refused("turn of " + std::to_string(std::lround(degrees)) + "°, rim fixed",
                            [degrees](const HeldPatch& patch) {
                              return turned(patch, degrees, {0, 0, 1});
                            }));
  }
  for (const double degrees : {30.0, 90.0, 180.0}) {
    all.push_back(
        bounded("turn of " + std::to_string(std::lround(degrees)) + "° of bone and rim together",
                "error against the rigid motion", 1e-5, "mm",
                [degrees] { return turned_together_error(degrees); }));
  }
  all.push_back(bounded("two segments pushed 3 mm into each other, linear",
                        "distance to the sum of the two alone", 1e-10, "mm", superposition_error));
  all.push_back(
      refused("two segments pushed 5 mm into each other, neo-Hookean, 4 mm of tissue "
              "between them",
              ErrorKind::numeric, "large motion", "% of the motion", pressed_between_segments));
  all.push_back(refused("NaN in a motion, linear", ErrorKind::numeric, "solver", "not finite", [] {
    linear_answer(solver_of(held_patch()), {shifted(0, std::nan(""), 1)});
  }));
  all.push_back(
      refused("NaN in a motion, neo-Hookean", ErrorKind::numeric, "large motion", "not finite",
              [] { large_answer(solver_of(held_patch()), {shifted(0, std::nan(""), 1)}); }));
}

void add_time(std::vector<HardCase>& all) {
  for (const auto& [scheme, name] : {std::pair{TimeScheme::implicit_euler, "implicit Euler"},
                                     std::pair{TimeScheme::newmark, "Newmark, γ 0.6"}}) {
    const TimeScheme by = scheme;
    const std::string with = std::string(", ") + name;
    all.push_back(bounded("dt = 1e-6 s" + with, "energy over that of the start, 50 steps", 1.001,
                          "", [by] { return settled(timed(1e-6, by), 50).energy; }));
    all.push_back(bounded("dt = 1e3 s" + with, "distance to the static solution after 100 steps",
                          1e-6, "of it", [by] { return settled(timed(1e3, by), 100).distance; }));
    all.push_back(bounded("no damping, dt = 0.01 s" + with,
                          "energy over that of the start, 200 steps", 1.05, "",
                          [by] { return settled(timed(0.01, by, 0, 0), 200).energy; }));
    all.push_back(bounded("huge damping, α = 1e9 /s, β = 1e6 s, dt = 1e3 s" + with,
                          "energy over that of the start, 100 steps", 1.001, "",
                          [by] { return settled(timed(1e3, by, 1e9, 1e6), 100).energy; }));
  }
  all.push_back(refused("dt = 0", ErrorKind::case_file, "dynamics.step", "",
                        [] { settled(timed(0, TimeScheme::newmark), 1); }));
}

}  // namespace

std::vector<HardCase> hard_mechanics() {
  std::vector<HardCase> all;
  add_materials(all);
  add_meshes(all);
  add_motions(all);
  add_time(all);
  return all;
}

}  // namespace gnathion::bench
