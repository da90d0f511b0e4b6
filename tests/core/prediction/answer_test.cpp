#include "prediction/answer.h"

#include <gtest/gtest.h>

#include "plan/jaw_motion.h"
#include "support/head_scene.h"

namespace gnathion {
namespace {

const RegionChoice reach_of_40{40, {}, false, {}};

TissueModel tissue(Elements elements, Strain strain, double tolerance_mm = 0.5) {
  TissueModel model;
  model.elements = elements;
  model.strain = strain;
  model.tolerance_mm = tolerance_mm;
  return model;
}

TissueModel automatic(double tolerance_mm) {
  return tissue(Elements::automatic, Strain::automatic, tolerance_mm);
}

const Anatomy& head() {
  static const Anatomy scene = test::head_scene();
  return scene;
}

std::vector<RigidMotion> chin_moved(const JawMotion& motion) {
  return {rigid_motion(motion, test::head_segment_at)};
}

Answer answer_to(const JawMotion& motion, const TissueModel& wanted) {
  Progress progress;
  const FaceModel quick(head(), reach_of_40, wanted, progress);
  return choose_answer(head(), reach_of_40, wanted, quick, chin_moved(motion), progress);
}

Eigen::VectorXd difference(const Answer& a, const Answer& b) {
  return (a.face_points - b.face_points).rowwise().norm();
}

TEST(Answer, IsTheQuickOneWhereThatKeepsTheTolerance) {
  Progress progress;
  const FaceModel quick(head(), reach_of_40, {}, progress);
  const auto motions = chin_moved({.forward_mm = 0.5});
  const Answer answer = choose_answer(head(), reach_of_40, {}, quick, motions, progress);
  EXPECT_FALSE(answer.large_strain);
  EXPECT_EQ(answer.order, ElementOrder::linear);
  EXPECT_TRUE(answer.error.within(0.5));
  Points shown;
  quick.predict(motions, shown);
  EXPECT_LT((answer.face_points - shown).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_NE(answer.why.find("linear model"), std::string::npos) << answer.why;
}

TEST(Answer, EscalatesAsTheMotionGrowsAndSaysWhy) {
  const Answer answer = answer_to({.forward_mm = 8, .pitch_deg = 10}, automatic(0.3));
  EXPECT_TRUE(answer.large_strain);
  EXPECT_FALSE(answer.quick_error.within(0.3));
  EXPECT_LT(answer.error.total.p95, answer.quick_error.total.p95);
  EXPECT_LT(answer.neo_hookean.relative_residual, 1e-4);
  EXPECT_NE(answer.why.find("neo-Hookean"), std::string::npos) << answer.why;
  EXPECT_NE(answer.why.find("would be off"), std::string::npos) << answer.why;
}

TEST(Answer, TheEstimateIsOfTheSizeOfWhatABetterModelChanges) {
  const TissueModel quick = tissue(Elements::linear, Strain::small);
  const TissueModel best = tissue(Elements::quadratic, Strain::large);
  const Answer cheap = answer_to({.forward_mm = 5}, quick);
  const Eigen::VectorXd changed = difference(cheap, answer_to({.forward_mm = 5}, best));
  const double true_mean = changed.sum() / static_cast<double>(cheap.error.discretisation.size());
  const double estimated = cheap.error.total.mean;
  EXPECT_GT(estimated, 0.8 * true_mean);
  EXPECT_LT(estimated, 5 * true_mean);
}

TEST(Answer, IsAsTheCaseAsks) {
  const JawMotion motion{.forward_mm = 3};
  for (const Elements elements : {Elements::linear, Elements::quadratic}) {
    for (const Strain strain : {Strain::small, Strain::large}) {
      const Answer answer = answer_to(motion, tissue(elements, strain));
      EXPECT_EQ(answer.order == ElementOrder::quadratic, elements == Elements::quadratic);
      EXPECT_EQ(answer.large_strain, strain == Strain::large);
    }
  }
}

TEST(Answer, TakesAFinerMeshWhereNoModelOnTheFirstKeepsTheTolerance) {
  const Answer coarse = answer_to({.forward_mm = 6}, automatic(0.5));
  const Answer fine = answer_to({.forward_mm = 6}, automatic(0.02));
  EXPECT_GT(fine.tissue->tissue.mesh.tets.rows(), coarse.tissue->tissue.mesh.tets.rows());
  EXPECT_LT(fine.error.total.p95, coarse.error.total.p95);
}

TEST(Answer, QuadraticDragFramesAgreeWithTheQuadraticAnswer) {
  Progress progress;
  const TissueModel wanted = tissue(Elements::quadratic, Strain::small);
  const FaceModel model(head(), reach_of_40, wanted, progress);
  EXPECT_EQ(model.order(), ElementOrder::quadratic);
  const auto motions = chin_moved({.forward_mm = 4, .yaw_deg = 5});
  const Answer answer = choose_answer(head(), reach_of_40, wanted, model, motions, progress);
  Points shown;
  model.predict(motions, shown);
  EXPECT_LT((answer.face_points - shown).cwiseAbs().maxCoeff(), 1e-9);
  const Points linear =
      answer_to({.forward_mm = 4, .yaw_deg = 5}, tissue(Elements::linear, Strain::small))
          .face_points;
  EXPECT_GT((linear - shown).cwiseAbs().maxCoeff(), 0.05) << "quadratic elements changed nothing";
}

TEST(Answer, WithoutMotionNothingIsEscalated) {
  const Answer answer = answer_to({}, {});
  EXPECT_FALSE(answer.large_strain);
  EXPECT_EQ(answer.error.total.max, 0);
  EXPECT_EQ(answer.face_points, head().face.mesh.surface.vertices);
}

TEST(Answer, MotionsThatTissueCannotFollowAreAnsweredByTheLinearModelAndSaidSo) {
  const JawMotion impossible{.forward_mm = 40, .roll_deg = 175};
  const Answer answer = answer_to(impossible, tissue(Elements::linear, Strain::automatic));
  EXPECT_FALSE(answer.large_strain);
  EXPECT_NE(answer.why.find("could not follow"), std::string::npos) << answer.why;
  EXPECT_FALSE(answer.error.within(0.5));
}

}  // namespace
}  // namespace gnathion
