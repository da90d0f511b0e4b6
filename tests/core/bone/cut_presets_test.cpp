#include "bone/cut_presets.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "core/bone/heads.h"
#include "geometry/triangle_mesh.h"
#include "support/expect_error.h"
#include "support/solids.h"

namespace gnathion::test {
namespace {

struct Range {
  double low, high;
};

/// The preset's segment as the saw gives it.
TriangleMesh segment_of(CutPreset preset, const CutPreviewer& bone, const JawAnatomy& jaw,
                        const std::string& name) {
  Progress progress;
  const PresetCut made = preset_cut(preset, jaw, bone, progress);
  EXPECT_EQ(made.name, name);
  EXPECT_FALSE(bone.preview(made.cut).refusal);
  return cut_segment(bone.bone(), made.cut, {}, progress).segment;
}

void expect_volume(const TriangleMesh& segment, Range cm3) {
  EXPECT_GT(signed_volume(segment), 1000 * cm3.low);
  EXPECT_LT(signed_volume(segment), 1000 * cm3.high);
}

TEST(JawAnatomy, AgreesWithTheTruthOfTheAnalyticHead) {
  const auto truth = phantom_truth().landmarks;
  for (const bool with_landmarks : {true, false}) {
    const JawAnatomy jaw = find_jaw(analytic_bone(), with_landmarks ? truth : decltype(truth)());
    EXPECT_NEAR(jaw.midline_x, 0, 0.5);
    EXPECT_LT((jaw.pogonion - truth.at("pogonion")).norm(), 3);
    EXPECT_NEAR(jaw.menton_z, truth.at("menton").z(), 2);
    // The gap between the edges of the front teeth.
    EXPECT_GT(jaw.bite.z(), truth.at("lower_incisor_edge").z() - 1);
    EXPECT_LT(jaw.bite.z(), truth.at("upper_incisor_edge").z() + 1);
    EXPECT_LT(std::abs(jaw.bite_rise), 0.1);
    EXPECT_GT(jaw.nasal_floor_z, truth.at("a_point").z());
    EXPECT_LT(jaw.nasal_floor_z, truth.at("a_point").z() + 15);
  }
}

TEST(JawAnatomy, SaysWhatWasNotFound) {
  const TriangleMesh ball = sphere({0, 0, 0}, 80, 4);
  expect_error(ErrorKind::anatomy, {"bite", "was not found"}, [&] { find_jaw(ball, {}); });
  expect_error(ErrorKind::anatomy, {"a jaw"}, [&] {
    find_jaw({Points(0, 3), Triangles(0, 3)}, {});
  });
}

TEST(CutPresets, FitTheAnalyticHead) {
  const CutPreviewer bone(analytic_bone());
  const auto truth = phantom_truth().landmarks;
  const JawAnatomy jaw = find_jaw(bone.bone(), {});
  const TriangleMesh chin = segment_of(CutPreset::chin, bone, jaw, "chin");
  expect_volume(chin, {5, 14});
  EXPECT_LT(chin.vertices.col(2).maxCoeff(), truth.at("b_point").z());
  const TriangleMesh body = segment_of(CutPreset::mandible_body, bone, jaw, "mandible body");
  expect_volume(body, {45, 75});
  EXPECT_GT(body.vertices.col(2).maxCoeff(), truth.at("lower_incisor_edge").z() - 1.5);
  EXPECT_LT(body.vertices.col(1).maxCoeff(), truth.at("gonion_left").y() - 10);
  const TriangleMesh maxilla = segment_of(CutPreset::maxilla, bone, jaw, "maxilla");
  expect_volume(maxilla, {20, 50});
  EXPECT_GT(maxilla.vertices.col(2).minCoeff(), truth.at("lower_incisor_edge").z());
}

TEST(CutPresets, FitTheRealCtWithAndWithoutLandmarks) {
  if (real_bone().triangles.rows() == 0) GTEST_SKIP() << "no real CT";
  const CutPreviewer bone(real_bone());
  for (const bool with_landmarks : {true, false}) {
    std::map<std::string, Eigen::Vector3d> landmarks;
    if (with_landmarks) landmarks["stomion"] = {2.5, -309.8, 367};
    const JawAnatomy jaw = find_jaw(bone.bone(), landmarks);
    EXPECT_NEAR(jaw.bite.z(), 369, 4);
    EXPECT_NEAR(jaw.midline_x, 2.5, 4);
    expect_volume(segment_of(CutPreset::chin, bone, jaw, "chin"), {4, 14});
    expect_volume(segment_of(CutPreset::mandible_body, bone, jaw, "mandible body"), {35, 60});
    expect_volume(segment_of(CutPreset::maxilla, bone, jaw, "maxilla"), {25, 50});
  }
}

TEST(CutPresets, SayWhyThereIsNone) {
  const CutPreviewer ball(sphere({0, 0, 0}, 15, 4));
  JawAnatomy jaw;
  jaw.pogonion = {200, 0, 0};
  jaw.midline_x = 200;
  jaw.bite = {200, 0, 40};
  Progress progress;
  expect_error(ErrorKind::anatomy, {"chin", "does not touch", "by hand"},
               [&] { preset_cut(CutPreset::chin, jaw, ball, progress); });
  progress.cancel();
  expect_error(ErrorKind::cancelled, {}, [&] { preset_cut(CutPreset::chin, jaw, ball, progress); });
}

}  // namespace
}  // namespace gnathion::test
