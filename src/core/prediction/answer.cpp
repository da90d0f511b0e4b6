#include "prediction/answer.h"

#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "fem/linearisation_error.h"

namespace gnathion {
namespace {

/// Sizes at the tissue's vertices on the face's moving vertices, mm.
Eigen::VectorXd on_face(const FaceModel& model, const Eigen::VectorXd& sizes) {
  const Eigen::VectorXd all =
      model.problem().surface_map * sizes.head(model.problem().tissue.surface_count);
  return all(model.moving_vertices());
}

FaceError face_error(Eigen::VectorXd discretisation, Eigen::VectorXd linearisation) {
  FaceError error{std::move(discretisation), std::move(linearisation), {}};
  error.total = distance_statistics(error.discretisation + error.linearisation);
  return error;
}

struct Choice {
  bool quadratic = false, large_strain = false;
};

/// What a model leaves of the errors estimated for linear elements and small strain.
FaceError remaining(const FaceError& linear, Choice choice) {
  const double small_strain = choice.large_strain ? 0
                              : choice.quadratic  ? kSmallStrainOnQuadratic
                                                  : 1;
  return face_error(linear.discretisation * (choice.quadratic ? kQuadraticRest : 1),
                    linear.linearisation * small_strain);
}

/// The choices that are allowed, the cheapest first.
std::vector<Choice> ladder(const TissueModel& wanted, const FaceModel& model) {
  std::vector<Choice> choices;
  const Eigen::Index tets = model.problem().tissue.mesh.tets.rows();
  for (const bool large : {false, true}) {
    for (const bool quadratic : {false, true}) {
      const bool force = wanted.load == LoadModel::force;
      if (force && (large || quadratic)) continue;
      if (wanted.elements == Elements::linear && quadratic) continue;
      if (wanted.elements == Elements::quadratic && !quadratic) continue;
      if (wanted.strain == Strain::small && large) continue;
      if (wanted.strain == Strain::large && !large) continue;
      const bool chosen = wanted.elements == Elements::quadratic;
      if (quadratic && tets > kMostQuadraticTets && !chosen) continue;
      choices.push_back({quadratic, large});
    }
  }
  return choices;
}

/// Errors of linear elements and small strain, estimated for these displacements.
FaceError estimated_error(const FaceModel& model, const Points& linear, Progress& progress) {
  const auto stage = progress.stage("estimate the error");
  Points correction = Points::Zero(linear.rows(), 3);
  if (model.load() == LoadModel::displacement) {
    correction = model.estimated_correction(linear, progress);
  }
  return face_error(on_face(model, correction.rowwise().norm()),
                    on_face(model, linearisation_error(model.solver(), linear)));
}

std::string millimetres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f mm", value);
  return text;
}

std::string words(const Answer& answer, Choice choice, const FaceError& linear,
                  const TissueModel& wanted) {
  std::string sentence = std::string(choice.large_strain ? "neo-Hookean" : "linear") +
                         " model on " + std::to_string(answer.tissue->tissue.mesh.tets.rows()) +
                         (choice.quadratic ? " quadratic" : " linear") +
                         " tetrahedra, estimated error " + millimetres(answer.error.total.p95) +
                         " on 95 % of the face (tolerance " + millimetres(wanted.tolerance_mm) +
                         ")";
  if (wanted.load == LoadModel::force) {
    sentence += "; the error of elements is not estimated for force transfer";
  }
  const bool chosen = wanted.elements == Elements::automatic || wanted.strain == Strain::automatic;
  if (chosen && (choice.large_strain || choice.quadratic)) {
    sentence += "; the linear model on linear ones would be off by " +
                millimetres(distance_statistics(linear.discretisation).p95) + " (elements) and " +
                millimetres(distance_statistics(linear.linearisation).p95) + " (small strain)";
  }
  return sentence;
}

/// The neo-Hookean displacements of the first `vertex_count` nodes of the solver's mesh.
void set_neo_hookean(const StaticSolver& solver, std::span<const RigidMotion> motions,
                     Eigen::Index vertex_count, Answer& answer, Progress& progress) {
  const Points& nodes = solver.elements().nodes;
  const MotionPath path = bone_path(nodes, solver.supports(), {motions.begin(), motions.end()});
  NeoHookeanOptions options;
  options.tolerance = 1e-4;  // leaves less than 1e-3 mm, far below what elements leave
  answer.neo_hookean =
      NeoHookeanSolver(solver).solve(path, Points::Zero(nodes.rows(), 3), progress, options);
  answer.displacements = answer.neo_hookean.displacements.topRows(vertex_count);
  answer.neo_hookean.displacements.resize(0, 3);
}

/// The answer of one choice.
Answer answer_by(Choice choice, const FaceModel& model, const FaceError& linear_error,
                 const Points& linear, const TissueModel& wanted,
                 std::span<const RigidMotion> motions, Progress& progress) {
  Answer answer;
  answer.tissue = model.problem_ptr();
  answer.order = choice.quadratic ? ElementOrder::quadratic : ElementOrder::linear;
  answer.large_strain = choice.large_strain;
  answer.error = remaining(linear_error, choice);
  if (choice.large_strain) {
    const auto stage = progress.stage("large strain");
    set_neo_hookean(choice.quadratic ? model.quadratic_solver(progress) : model.solver(), motions,
                    linear.rows(), answer, progress);
  } else {
    answer.displacements = choice.quadratic ? model.solve_quadratic(motions, progress) : linear;
  }
  answer.face_points = model.face_with(answer.displacements);
  answer.why = words(answer, choice, linear_error, wanted);
  return answer;
}

/// The first of the choices that is estimated to keep the tolerance, else the one with the least
/// estimated error. \pre choices is not empty.
Choice best_of(const std::vector<Choice>& choices, const FaceError& linear, double tolerance_mm) {
  Choice best = choices.front();
  double least = std::numeric_limits<double>::infinity();
  for (const Choice& choice : choices) {
    const double left = remaining(linear, choice).total.p95;
    if (left <= tolerance_mm) return choice;
    if (left >= least) continue;
    best = choice;
    least = left;
  }
  return best;
}

/// The best choice on one mesh.
Answer answer_on(const FaceModel& model, const TissueModel& wanted,
                 std::span<const RigidMotion> motions, Progress& progress) {
  const Points linear = model.solve(motions).displacements;
  const FaceError error = estimated_error(model, linear, progress);
  std::vector<Choice> choices = ladder(wanted, model);
  const Choice choice = best_of(choices, error, wanted.tolerance_mm);
  Answer answer;
  try {
    answer = answer_by(choice, model, error, linear, wanted, motions, progress);
  } catch (const Error& refusal) {
    std::erase_if(choices, [](const Choice& c) { return c.large_strain; });
    if (refusal.kind() != ErrorKind::numeric || !choice.large_strain || choices.empty()) throw;
    answer = answer_by(best_of(choices, error, wanted.tolerance_mm), model, error, linear, wanted,
                       motions, progress);
    answer.why += "; large strain could not follow the motion: " + refusal.problem();
  }
  answer.quick_error = remaining(error, {model.order() == ElementOrder::quadratic, false});
  return answer;
}

/// Finer meshes to try in turn, where the mesh is the program's choice.
std::vector<TissueModel> finer_tissues(const TissueModel& wanted) {
  const bool chosen = wanted.elements == Elements::automatic && wanted.edge_mm == 0 &&
                      wanted.layer_edges == 0 && wanted.generator == Generator::robust &&
                      wanted.load == LoadModel::displacement;
  if (!chosen) return {};
  TissueModel layered = wanted;
  layered.layer_edges = 1;
  TissueModel finer = layered;
  finer.edge_mm = 2;
  return {layered, finer};
}

}  // namespace

Answer choose_answer(const Anatomy& anatomy, const RegionChoice& region, const TissueModel& wanted,
                     const FaceModel& quick, std::span<const RigidMotion> motions,
                     Progress& progress) {
  Answer answer = answer_on(quick, wanted, motions, progress);
  const FaceError quick_error = answer.quick_error;
  for (const TissueModel& tissue : finer_tissues(wanted)) {
    if (answer.error.within(wanted.tolerance_mm)) break;
    try {
      const FaceModel finer(anatomy, region, tissue, progress);
      Answer better = answer_on(finer, wanted, motions, progress);
      if (better.error.total.p95 < answer.error.total.p95) answer = std::move(better);
    } catch (const Error& failure) {
      // An answer is at hand; that a finer mesh has none is no reason to withhold it.
      if (failure.kind() != ErrorKind::anatomy && failure.kind() != ErrorKind::numeric) throw;
      answer.why += "; on a finer mesh: " + failure.problem();
      break;
    }
  }
  answer.quick_error = quick_error;
  if (!answer.error.within(wanted.tolerance_mm)) {
    answer.why += "; the case or the program allows no better model";
  }
  return answer;
}

}  // namespace gnathion
