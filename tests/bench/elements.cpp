#include "bench/elements.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "bench/chin_problem.h"
#include "bench/timing.h"
#include "fem/quadratic_correction.h"
#include "support/element_variants.h"
#include "support/tet_solids.h"

namespace gnathion::bench {
namespace {

using namespace testing;

struct Element {
  std::string name;
  ElementOrder order;
  std::function<StiffnessMatrix(const ElementMesh&, const ElasticMaterial&)> stiffness;
};

const std::vector<Element>& elements() {
  const auto ours = [](const ElementMesh& mesh, const ElasticMaterial& material) {
    return stiffness_matrix(mesh, material);
  };
  static const std::vector<Element> all{
      {"linear", ElementOrder::linear, ours},
      {"linear, volume averaged at nodes", ElementOrder::linear, nodal_averaged_stiffness},
      {"quadratic, full integration", ElementOrder::quadratic,
       [](const ElementMesh& mesh, const ElasticMaterial& material) {
         return full_quadratic_stiffness(mesh, material);
       }},
      {"quadratic, mean dilatation (ours)", ElementOrder::quadratic, ours}};
  return all;
}

struct Answer {
  Points u;
  double assembly = 0, factor = 0, solve = 0;  ///< s
};

Answer solved(const Element& element, const ElementMesh& mesh, const ElasticMaterial& material,
              const Supports& supports, const Points& prescribed, const Points& forces) {
  Answer answer;
  StiffnessMatrix K;
  answer.assembly = seconds([&] { K = element.stiffness(mesh, material); });
  const FreePart free(supports);
  std::optional<SpdFactor> factor;
  answer.factor =
      seconds([&] { factor.emplace(free_stiffness(K, free), elimination_order(K, free)); });
  answer.solve = seconds([&] {
    answer.u = prescribed_part(supports, prescribed);
    const Eigen::VectorXd q = factor->solve(free.gather(Points(forces - K * answer.u)));
    free.add(q, 1, answer.u);
  });
  return answer;
}

/// The chin's surface with quadratic elements on tets cut into eight, iterated on.
Points chin_reference(const ChinProblem& p, const ElasticMaterial& material) {
  const RigidMotion motion = chin_motion(p);
  const Supports supports =
      supports_of_nodes(ElementMesh(p.tissue.mesh, ElementOrder::quadratic), p.supports);
  Progress progress;
  const StaticSolver linear(refined(p.tissue.mesh), material, supports, progress);
  const Points bone = bone_displacements(linear.elements().nodes, supports, {&motion, 1});
  const Points u = linear.solve(bone, Points::Zero(bone.rows(), 3)).displacements;
  const Eigen::MatrixXd column = u.reshaped<Eigen::RowMajor>();
  const Eigen::VectorXd fine =
      column + QuadraticCorrection(linear, progress).correct(column, progress, 800, 1e-5);
  return Eigen::Map<const Points>(fine.data(), u.rows(), 3).topRows(p.tissue.surface_count);
}

void report_chin(const Report& report) {
  const ChinProblem p = chin_problem(patch_p1());
  const RigidMotion motion = chin_motion(p);
  Table table({"ν", "element", "mean, mm", "95 %, mm", "max, mm", "assembly, s",
               "order + factor, s", "solve, s"});
  for (const double poisson : {0.46, 0.49, 0.499}) {
    const ElasticMaterial material{1, poisson};
    const Points reference = chin_reference(p, material);
    for (const Element& element : elements()) {
      const ElementMesh mesh(p.tissue.mesh, element.order);
      const Supports supports = supports_of_nodes(mesh, p.supports);
      const Points bone = bone_displacements(mesh.nodes, supports, {&motion, 1});
      const Answer answer =
          solved(element, mesh, material, supports, bone, Points::Zero(bone.rows(), 3));
      Eigen::VectorXd error = (answer.u.topRows(reference.rows()) - reference).rowwise().norm();
      std::sort(error.begin(), error.end());
      table.add({poisson, element.name, error.mean(), error[error.size() * 95 / 100],
                 error[error.size() - 1], answer.assembly, answer.factor, answer.solve});
    }
  }
  report.say(
      "p1, one layer, the chin driven 5 mm: surface error against quadratic elements on "
      "tets cut into eight.");
  report.table("elements_p1", table);
}

/// Cook's membrane in plane strain: displacement of its upper right corner.
Answer cook(const Element& element, double poisson, const std::array<int, 3>& n, double& tip) {
  const double tiny = 1e-9, thickness = 4;
  const ElementMesh mesh(tet_cook(thickness, n), element.order);
  Supports supports(static_cast<std::size_t>(mesh.nodes.rows()));
  for (Eigen::Index i = 0; i < mesh.nodes.rows(); ++i) {
    const auto x = mesh.nodes.row(i);
    if (x[2] < tiny || x[2] > thickness - tiny) {
      supports[i] = Support::slides(Eigen::Vector3d::UnitZ(), Support::kUnmoved);
    }
    if (x[0] < tiny) supports[i] = Support::fixed;
  }
  const Points forces = traction_forces(
      mesh, [=](const Eigen::Vector3d& x) { return x[0] > 48 - tiny; },
      [](const Eigen::Vector3d&, const Eigen::Vector3d&) {
        return Eigen::Vector3d(0, 1.0 / 16, 0);
      });
  Answer answer =
      solved(element, mesh, {1, poisson}, supports, Points::Zero(mesh.nodes.rows(), 3), forces);
  Eigen::Index corner = 0;
  (mesh.nodes.rowwise() - Eigen::RowVector3d(48, 60, 0)).rowwise().norm().minCoeff(&corner);
  tip = answer.u(corner, 1);
  return answer;
}

void report_cook(const Report& report) {
  Table table({"ν", "element", "tip over reference", "time to the answer, s"});
  for (const double poisson : {0.46, 0.49, 0.499}) {
    double reference = 0;
    cook(elements().back(), poisson, {64, 64, 1}, reference);
    for (const Element& element : elements()) {
      double tip = 0;
      const Answer answer = cook(element, poisson, {16, 16, 4}, tip);
      table.add(
          {poisson, element.name, tip / reference, answer.assembly + answer.factor + answer.solve});
    }
  }
  report.say("Cook's membrane, plane strain, 6144 tets, against 64 by 64 cells.");
  report.table("elements_cook", table);
}

}  // namespace

void report_elements(const Report& report) {
  report.heading("Elements on the same mesh");
  report_chin(report);
  report_cook(report);
}

}  // namespace gnathion::bench
