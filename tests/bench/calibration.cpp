#include "bench/calibration.h"

#include <Eigen/Geometry>
#include <array>
#include <utility>

#include "bench/chin_problem.h"
#include "fem/linearisation_error.h"
#include "fem/neo_hookean_solver.h"
#include "fem/quadratic_correction.h"
#include "geometry/surface_distance.h"
#include "support/tet_solids.h"

namespace gnathion::bench {
namespace {

using Motions = std::vector<std::pair<std::string, RigidMotion>>;

Motions motions_of(const ChinProblem& p) {
  Motions all;
  for (const double mm : {3.0, 5.0, 8.0, 10.0}) {
    RigidMotion motion;
    motion.translation << 0, 0, mm;
    all.emplace_back(number(mm) + " mm", motion);
  }
  for (const double degrees : {5.0, 10.0}) {
    RigidMotion motion;
    motion.rotation =
        Eigen::AngleAxisd(degrees * M_PI / 180, Eigen::Vector3d::UnitX()).toRotationMatrix();
    motion.translation = p.centre - motion.rotation * p.centre;
    all.emplace_back(number(degrees) + "°", motion);
  }
  return all;
}

/// Columns 3n of the bone's displacements, one a motion.
Eigen::MatrixXd prescribed(const StaticSolver& solver, const Motions& motions) {
  const Points& x = solver.elements().nodes;
  Eigen::MatrixXd columns(3 * x.rows(), static_cast<Eigen::Index>(motions.size()));
  for (std::size_t m = 0; m < motions.size(); ++m) {
    columns.col(static_cast<Eigen::Index>(m)) =
        bone_displacements(x, solver.supports(), {&motions[m].second, 1})
            .reshaped<Eigen::RowMajor>();
  }
  return columns;
}

Eigen::MatrixXd linear_columns(const StaticSolver& solver, const Motions& motions) {
  const Eigen::MatrixXd bone = prescribed(solver, motions);
  return solver.solve_columns(bone, Eigen::MatrixXd::Zero(bone.rows(), bone.cols()));
}

/// Of the first `count` points of a column: the length at each.
Eigen::VectorXd lengths(const Eigen::MatrixXd& columns, Eigen::Index column, int count) {
  const Eigen::VectorXd field = columns.col(column);
  return Eigen::Map<const Points>(field.data(), field.size() / 3, 3)
      .topRows(count)
      .rowwise()
      .norm();
}

void add_row(const std::string& estimate, const std::string& motion,
             const Eigen::VectorXd& estimated, const Eigen::VectorXd& truth, Table& table) {
  const DistanceStatistics e = distance_statistics(estimated), t = distance_statistics(truth);
  table.add({estimate, motion, t.mean, e.mean, e.mean / t.mean, t.p95, e.p95, e.p95 / t.p95});
}

/// Small strain's estimate against the neo-Hookean solution on the same elements; what is left when
/// the second-order correction is added to the linear answer, too.
void add_small_strain(const StaticSolver& solver, const Motions& motions, int skin,
                      const std::string& elements, Table& table) {
  Progress progress;
  const Points rest = Points::Zero(solver.elements().nodes.rows(), 3);
  const Eigen::MatrixXd u = linear_columns(solver, motions);
  const NeoHookeanSolver large(solver);
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const Eigen::VectorXd entries = u.col(static_cast<Eigen::Index>(m));
    const Points linear = Eigen::Map<const Points>(entries.data(), rest.rows(), 3);
    const Points correction = second_order_correction(solver, linear);
    const Points answer =
        large
            .solve(bone_path(solver.elements().nodes, solver.supports(), {motions[m].second}), rest,
                   progress)
            .displacements;
    const Points missed = answer - linear;
    add_row("small strain on " + elements + " elements, second order", motions[m].first,
            correction.topRows(skin).rowwise().norm(), missed.topRows(skin).rowwise().norm(),
            table);
    add_row("the same, correction added", motions[m].first,
            (missed - correction).topRows(skin).rowwise().norm(),
            missed.topRows(skin).rowwise().norm(), table);
  }
}

}  // namespace

void report_calibration(const Report& report) {
  report.heading("Error estimates against true errors (effectivity)");
  report.say(
      "p1, 5 mm thick, one layer, the chin driven, errors of the skin. Truth of the elements: "
      "quadratic elements on tets cut into eight, iterated on. Truth of small strain: the "
      "neo-Hookean solution on the same mesh.");
  const ChinProblem p = chin_problem(testing::patch_p1());
  const Motions motions = motions_of(p);
  Progress progress;
  const StaticSolver solver(p.tissue.mesh, {}, p.supports, progress);
  const StaticSolver fine(
      testing::refined(p.tissue.mesh), {},
      supports_of_nodes(ElementMesh(p.tissue.mesh, ElementOrder::quadratic), p.supports), progress);
  const Eigen::MatrixXd u = linear_columns(solver, motions), v = linear_columns(fine, motions);
  const Eigen::MatrixXd estimate = QuadraticCorrection(solver, progress).correct(u, progress);
  const Eigen::MatrixXd reference =
      (v + QuadraticCorrection(fine, progress).correct(v, progress, 300, 1e-3)).topRows(u.rows());
  Table table({"estimate", "motion", "true mean, mm", "estimated mean, mm", "ratio",
               "true 95 %, mm", "estimated 95 %, mm", "ratio of 95 %"});
  const int skin = p.tissue.surface_count;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const auto column = static_cast<Eigen::Index>(m);
    add_row("elements, " + std::to_string(QuadraticCorrection::kEstimate) + " iterations",
            motions[m].first, lengths(estimate, column, skin), lengths(reference - u, column, skin),
            table);
  }
  add_small_strain(solver, motions, skin, "linear", table);
  const ElementMesh elements(p.tissue.mesh, ElementOrder::quadratic);
  const StaticSolver quadratic(elements, {}, supports_of_nodes(elements, p.supports), progress);
  add_small_strain(quadratic, motions, skin, "quadratic", table);
  report.table("calibration", table);
}

}  // namespace gnathion::bench
