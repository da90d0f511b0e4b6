#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "geometry/tet_quality.h"
#include "imaging/ct_import.h"
#include "imaging/surfaces.h"
#include "phantom/head_phantom.h"
#include "prediction/face_model.h"
#include "prediction/landmarks.h"
#include "support/head_ct.h"
#include "support/temporary_folder.h"
#include "tissue/lip_line.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
using Landmarks = std::map<std::string, Vector3d>;

/// The analytic head with its photograph, made once.
struct EmbeddedHead {
  SurgicalCase plan;
  Anatomy anatomy;
};

const EmbeddedHead& embedded_head() {
  static const EmbeddedHead head = [] {
    const test::TemporaryFolder folder;
    Progress progress;
    PhantomOptions coarse;
    coarse.pixel_mm = 1.4;
    coarse.slice_step_mm = 1.6;
    coarse.texture_pixels = 64;
    const PhantomTruth truth = write_phantom_case(folder.path(), coarse, progress);
    EmbeddedHead made;
    made.plan.ct.path = folder.path() / "ct";
    made.plan.segments.resize(1);
    made.plan.segments[0].cut = box_between(truth.mandible_box_min, truth.mandible_box_max);
    made.plan.photograph =
        PhotographSource{folder.path() / "photograph" / "face.obj", truth.lps_from_photograph};
    made.plan.landmarks = truth.landmarks;
    made.anatomy = build_anatomy(made.plan, progress);
    return made;
  }();
  return head;
}

Landmarks of_the_mouth(const Landmarks& all) {
  Landmarks some;
  for (const char* name : {"stomion", "mouth_corner_left", "mouth_corner_right"}) {
    some[name] = all.at(name);
  }
  return some;
}

double distance_to(const std::vector<Vector3d>& line, const Vector3d& x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    for (double part = 0; part <= 1; part += 0.05) {
      least = std::min(least, ((1 - part) * line[k] + part * line[k + 1] - x).norm());
    }
  }
  return least;
}

TEST(LipLine, IsProposedFromTheShapeOfTheEmbeddedHeadsPhotograph) {
  const TriangleMesh& face = embedded_head().anatomy.face.mesh.surface;
  const Landmarks& truth = embedded_head().plan.landmarks;
  const LipLineProposal tied = propose_lip_line(face, of_the_mouth(truth));
  EXPECT_TRUE(tied.doubts.empty());
  ASSERT_GE(tied.line.size(), 10U);
  EXPECT_LT((tied.line.front() - truth.at("mouth_corner_right")).norm(), 1.5);
  EXPECT_LT((tied.line.back() - truth.at("mouth_corner_left")).norm(), 1.5);
  EXPECT_LT(distance_to(tied.line, truth.at("stomion")), 1);

  const LipLineProposal alone = propose_lip_line(face, {});
  ASSERT_GE(alone.line.size(), 10U);
  EXPECT_FALSE(alone.doubts.empty());  // the corners were not given
  EXPECT_LT(distance_to(alone.line, truth.at("stomion")), 1);
  for (const Vector3d& point : tied.line) {
    if (std::abs(point[0]) < 17) {
      EXPECT_LT(distance_to(alone.line, point), 1.5);
    }
  }
  EXPECT_LT((alone.line.front() - truth.at("mouth_corner_right")).norm(), 8);
  EXPECT_LT((alone.line.back() - truth.at("mouth_corner_left")).norm(), 8);
}

TEST(LipLine, IsProposedOnTheSkinOfTheRealCt) {
  const auto folder = test::head_ct_folder();
  if (folder.empty()) GTEST_SKIP() << "no shared data";
  Progress progress;
  const TriangleMesh skin = skin_surface(read_ct(folder, std::nullopt, progress), {}, progress);
  const Landmarks picked{{"stomion", {2.5, -309.8, 367}},
                         {"mouth_corner_right", {-27.5, -297.1, 369}},
                         {"mouth_corner_left", {29.0, -300.8, 369}}};
  const LipLineProposal tied = propose_lip_line(skin, picked);
  ASSERT_GE(tied.line.size(), 10U);
  EXPECT_LT(distance_to(tied.line, picked.at("stomion")), 2);
  const LipLineProposal alone = propose_lip_line(skin, {});
  ASSERT_GE(alone.line.size(), 10U);
  EXPECT_LT(distance_to(alone.line, picked.at("stomion")), 3);
}

TEST(LipLine, WhatIsNoFaceIsDoubtedOrHasNoLine) {
  TriangleMesh plate{Points(4, 3), Triangles(2, 3)};
  plate.vertices << -100, 0, -100, 100, 0, -100, 100, 0, 100, -100, 0, 100;
  plate.triangles << 0, 1, 2, 0, 2, 3;
  EXPECT_FALSE(propose_lip_line(plate, {}).doubts.empty());
  const LipLineProposal flat = propose_lip_line(
      plate, {{"mouth_corner_right", {-25, 0, 0}}, {"mouth_corner_left", {25, 0, 0}}});
  EXPECT_FALSE(flat.doubts.empty());
  EXPECT_FALSE(propose_lip_line({Points(0, 3), Triangles(0, 3)}, {}).doubts.empty());
}

/// How far landmarks follow the bone, which goes 6 mm forward: the linear model.
std::map<std::string, LandmarkResponse> responses(const std::vector<Vector3d>& lip_line,
                                                  std::size_t& doubled) {
  const EmbeddedHead& head = embedded_head();
  RegionChoice region;
  region.lip_line = lip_line;
  TissueModel linear;
  linear.elements = Elements::linear;
  Progress progress;
  const FaceModel model(head.anatomy, region, linear, progress);
  doubled = model.problem().slit.size();
  EXPECT_EQ(tet_quality(model.problem().tissue.mesh).inverted, 0);
  const std::vector<RigidMotion> motions{rigid_motion({.forward_mm = 6}, Vector3d::Zero())};
  Points points;
  model.predict(motions, points);
  const FaceLandmarks landmarks(head.plan.landmarks, head.anatomy.face.mesh.surface,
                                head.anatomy.segments);
  return landmarks.responses(points, motions);
}

TEST(Lips, PartedTheUpperLipStaysAndTheChinDoesNotNotice) {
  const EmbeddedHead& head = embedded_head();
  const LipLineProposal proposal =
      propose_lip_line(head.anatomy.face.mesh.surface, of_the_mouth(head.plan.landmarks));
  std::size_t doubled = 0;
  auto joined = responses({}, doubled);
  EXPECT_EQ(doubled, 0U);
  auto parted = responses(proposal.line, doubled);
  EXPECT_GT(doubled, 10U);
  EXPECT_GT(joined["upper_lip"].ratio, 0.12);
  EXPECT_LT(parted["upper_lip"].ratio, 0.4 * joined["upper_lip"].ratio);
  EXPECT_GT(parted["lower_lip"].ratio, joined["lower_lip"].ratio - 0.02);
  EXPECT_NEAR(parted["pogonion_soft"].ratio, joined["pogonion_soft"].ratio, 0.02);
  EXPECT_NEAR(parted["mouth_corner_left"].ratio, joined["mouth_corner_left"].ratio, 0.1);
}

}  // namespace
}  // namespace gnathion
