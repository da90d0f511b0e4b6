#include "prediction/settling.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "plan/jaw_motion.h"
#include "support/expect_error.h"
#include "support/head_scene.h"

namespace gnathion {
namespace {

using test::expect_error;

const FaceModel& head_model() {
  static const FaceModel model = [] {
    Progress progress;
    return FaceModel(test::head_scene(), RegionChoice{40, {}, false, {}}, {}, progress);
  }();
  return model;
}

const std::array<RigidMotion, 1> advance{
    rigid_motion({.forward_mm = 5, .pitch_deg = 3}, test::head_segment_at)};

struct Heard {
  Settling end;
  std::vector<double> time, distance, energy;
  Points last;
};

Heard heard(std::span<const RigidMotion> motions, const SettlingOptions& options) {
  Heard heard;
  Progress progress;
  heard.end = settle(
      head_model(), motions, options,
      [&](const SettlingFrame& frame) {
        EXPECT_EQ(frame.step, static_cast<int>(heard.time.size()));
        heard.time.push_back(frame.time_s);
        heard.distance.push_back(frame.distance.max);
        heard.energy.push_back(frame.energy_Nmm);
        heard.last = frame.displacements;
      },
      progress);
  return heard;
}

TEST(Settling, TheLastFrameIsTheStaticAnswerOfTheLinearModel) {
  const Points answer = head_model().solve(advance).displacements;
  Points face;
  head_model().predict(advance, face);
  for (const TimeScheme scheme : {TimeScheme::implicit_euler, TimeScheme::newmark}) {
    SettlingOptions options;
    options.dynamics.scheme = scheme;
    options.tolerance_mm = 1e-7;
    const Heard motion = heard(advance, options);
    ASSERT_TRUE(motion.end.settled);
    EXPECT_LT((motion.last - answer).norm(), 1e-6 * answer.norm());
    EXPECT_LT((head_model().face_with(motion.last) - face).rowwise().norm().maxCoeff(), 1e-6);
  }
}

TEST(Settling, FramesGoFromRestThroughTime) {
  SettlingOptions options;
  options.dynamics.step = 0.002;
  const Heard motion = heard(advance, options);
  ASSERT_TRUE(motion.end.settled);
  ASSERT_GT(motion.time.size(), 10U);
  EXPECT_EQ(motion.end.steps + 1, static_cast<int>(motion.time.size()));
  EXPECT_EQ(motion.time.front(), 0);
  EXPECT_NEAR(motion.end.time_s, 0.002 * motion.end.steps, 1e-12);
  Points face;
  head_model().predict(advance, face);
  const Points rest = test::head_scene().face.mesh.surface.vertices;
  EXPECT_NEAR(motion.distance.front(), (face - rest).rowwise().norm().maxCoeff(), 1e-9);
  EXPECT_LE(motion.distance.back(), options.tolerance_mm);
  // Implicit Euler gives no energy to the tissue.
  for (std::size_t i = 1; i < motion.energy.size(); ++i) {
    EXPECT_LE(motion.energy[i], motion.energy[i - 1] * (1 + 1e-9));
  }
}

TEST(Settling, ATimeAtWhichASwingPassesByIsNotItsEnd) {
  SettlingOptions options;
  options.dynamics = {
      .alpha = 60, .beta = 0, .step = 0.0005, .scheme = TimeScheme::newmark, .gamma = 0.55};
  options.tolerance_mm = 0.2;
  options.most_steps = 3000;
  SettlingOptions longer = options;
  const Heard motion = heard(advance, options);
  ASSERT_TRUE(motion.end.settled);
  // What follows stays within the tolerance.
  longer.tolerance_mm = 1e-12;
  longer.most_steps = motion.end.steps + 200;
  const Heard onwards = heard(advance, longer);
  EXPECT_FALSE(onwards.end.settled);
  EXPECT_EQ(onwards.end.steps, longer.most_steps);
  for (std::size_t i = motion.time.size(); i < onwards.time.size(); ++i) {
    EXPECT_LT(onwards.distance[i], options.tolerance_mm) << "at " << onwards.time[i] << " s";
  }
}

TEST(Settling, WithoutMotionTheFirstFrameIsTheLast) {
  const std::array<RigidMotion, 1> still{};
  const Heard motion = heard(still, {});
  EXPECT_TRUE(motion.end.settled);
  EXPECT_EQ(motion.end.steps, 0);
  EXPECT_EQ(motion.distance, std::vector<double>{0});
}

TEST(Settling, CanBeCancelledAtAnyFrame) {
  Progress progress;
  int frames = 0;
  expect_error(ErrorKind::cancelled, {}, [&] {
    settle(
        head_model(), advance, {},
        [&](const SettlingFrame&) {
          if (++frames == 3) progress.cancel();
        },
        progress);
  });
  EXPECT_EQ(frames, 3);
}

TEST(Settling, RefusesWhatMakesNoMotion) {
  const auto refused = [](const std::string& key, const SettlingOptions& options) {
    expect_error(ErrorKind::case_file, {key}, [&] {
      Progress progress;
      settle(
          head_model(), advance, options, [](const SettlingFrame&) {}, progress);
    });
  };
  refused("dynamics.step", {.dynamics = {.step = 0}});
  refused("dynamics.tolerance_mm", {.dynamics = {}, .tolerance_mm = 0});
  refused("dynamics.most_steps", {.dynamics = {}, .most_steps = 0});
  expect_error(ErrorKind::case_file, {"tissue.load"}, [] {
    Progress progress;
    TissueModel force;
    force.load = LoadModel::force;
    const FaceModel model(test::head_scene(), RegionChoice{40, {}, false, {}}, force, progress);
    settle(
        model, advance, {}, [](const SettlingFrame&) {}, progress);
  });
}

}  // namespace
}  // namespace gnathion
