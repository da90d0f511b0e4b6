#include "prediction/answer.h"

#include <cstdio>
#include <vector>

#include "base/error.h"
#include "fem/linearisation_error.h"

namespace gnathion {
namespace {

/// Lengths of a field of the tissue on the face's moving vertices, mm.
Eigen::VectorXd lengths_on_face(const FaceModel& model, const Points& field) {
  const Points on_face =
      model.problem().surface_map * field.topRows(model.problem().tissue.surface_count);
  return on_face(model.moving_vertices(), Eigen::all).rowwise().norm();
}

FaceError face_error(Eigen::VectorXd discretisation, Eigen::VectorXd linearisation) {
  FaceError error{std::move(discretisation), std::move(linearisation), {}};
  error.total = distance_statistics(error.discretisation + error.linearisation);
  return error;
}

/// What a model leaves of the quick answer's errors.
FaceError remaining(const FaceError& quick, bool quadratic, bool large_strain) {
  return face_error(quick.discretisation * (quadratic ? kQuadraticRest : 1),
                    quick.linearisation * (large_strain ? 0 : 1));
}

struct Choice {
  bool quadratic, large_strain;
};

/// The choices that are allowed, the cheapest first: a correction takes less than a large strain.
std::vector<Choice> ladder(const TissueModel& wanted, ElementOrder given) {
  std::vector<Choice> choices;
  for (const bool large : {false, true}) {
    for (const bool quadratic : {false, true}) {
      const bool force = wanted.load == LoadModel::force;
      if (force && (large || quadratic)) continue;
      if (wanted.elements == Elements::linear && quadratic) continue;
      if (wanted.elements == Elements::quadratic && !quadratic) continue;
      if (given == ElementOrder::quadratic && !quadratic) continue;
      if (wanted.strain == Strain::small && large) continue;
      if (wanted.strain == Strain::large && !large) continue;
      choices.push_back({quadratic, large});
    }
  }
  return choices;
}

std::string words(const Choice& choice, const FaceError& quick, const FaceError& left,
                  const TissueModel& wanted) {
  const std::string name = std::string(choice.large_strain ? "neo-Hookean" : "linear") +
                           " model on " + (choice.quadratic ? "quadratic" : "linear") + " elements";
  const bool chosen = wanted.elements == Elements::automatic || wanted.strain == Strain::automatic;
  char text[200];
  std::snprintf(text, sizeof text,
                ", estimated error %.2f mm on 95 %% of the face (tolerance %.2f mm)",
                left.total.p95, wanted.tolerance_mm);
  std::string sentence = name + text;
  const bool escalated = chosen && (choice.large_strain || choice.quadratic);
  if (escalated) {
    std::snprintf(text, sizeof text,
                  "; the linear model on linear elements would be off by %.2f mm (elements) and "
                  "%.2f mm (small strain)",
                  distance_statistics(quick.discretisation).p95,
                  distance_statistics(quick.linearisation).p95);
    sentence += text;
  }
  if (!left.within(wanted.tolerance_mm)) sentence += "; no better model is offered on this mesh";
  return sentence;
}

}  // namespace

Answer choose_answer(const FaceModel& model, const TissueModel& wanted,
                     std::span<const RigidMotion> motions, Progress& progress) {
  Answer answer;
  const Points linear = model.solve(motions).displacements;
  Points correction = Points::Zero(linear.rows(), 3);
  {
    const auto stage = progress.stage("estimate the error");
    if (wanted.load == LoadModel::displacement) {
      correction = model.quadratic_correction(linear, progress);
    }
    answer.quick_error =
        face_error(lengths_on_face(model, correction),
                   lengths_on_face(model, linearisation_error(model.solver(), linear)));
    if (model.order() == ElementOrder::quadratic) {
      answer.quick_error = remaining(answer.quick_error, true, false);
    }
  }
  Choice choice{};
  for (const Choice& next : ladder(wanted, model.order())) {
    choice = next;
    answer.error = remaining(answer.quick_error, next.quadratic, next.large_strain);
    if (answer.error.within(wanted.tolerance_mm)) break;
  }
  answer.order = choice.quadratic ? ElementOrder::quadratic : ElementOrder::linear;
  answer.large_strain = choice.large_strain;
  answer.displacements = linear;
  if (choice.large_strain) {
    const auto stage = progress.stage("neo-Hookean solution");
    const MotionPath path = bone_path(model.solver().elements().nodes, model.solver().supports(),
                                      {motions.begin(), motions.end()});
    const NeoHookeanSolution large =
        NeoHookeanSolver(model.solver()).solve(path, Points::Zero(linear.rows(), 3), progress);
    answer.displacements = large.displacements;
    answer.neo_hookean_residual = large.relative_residual;
    answer.load_steps = large.load_steps;
  }
  if (choice.quadratic) {
    const auto stage = progress.stage("correct to quadratic elements");
    constexpr int kMost = 60;
    answer.displacements += model.quadratic_correction(linear, progress, kMost);
  }
  answer.why = words(choice, answer.quick_error, answer.error, wanted);
  return answer;
}

}  // namespace gnathion
