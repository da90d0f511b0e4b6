#include "prediction/face_model.h"

#include <gtest/gtest.h>
#include <algorithm>

#include <numeric>

#include "base/error.h"
#include "plan/jaw_motion.h"
#include "prediction/landmarks.h"
#include "support/expect_error.h"
#include "support/face_patch.h"
#include "support/head_scene.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
using test::expect_error;

const RegionChoice reach_of_40{40, {}, false, {}};

/// One model for the tests that only ask it.
const FaceModel& head_model() {
  static const FaceModel model = [] {
    Progress progress;
    return FaceModel(test::head_scene(), reach_of_40, {}, progress);
  }();
  return model;
}

const Points& head_skin() {
  static const Points skin = test::head_scene().face.mesh.surface.vertices;
  return skin;
}

/// Of the head's only segment.
std::array<RigidMotion, 1> motions(const JawMotion& motion) {
  return {rigid_motion(motion, test::head_segment_at)};
}

Points predicted(const FaceModel& model, const JawMotion& motion) {
  Points points;
  model.predict(motions(motion), points);
  return points;
}

/// How far the skin over the segment is moved: mean of the vertices within 8 mm of the chin.
Vector3d chin_moves(const Points& points) {
  Vector3d sum = Vector3d::Zero();
  int count = 0;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if ((head_skin().row(v).transpose() - test::head_chin).norm() > 8) continue;
    sum += (points.row(v) - head_skin().row(v)).transpose();
    ++count;
  }
  return sum / count;
}

TEST(FaceModel, ZeroMotionLeavesTheFaceAsItIsToTheBit) {
  EXPECT_EQ(predicted(head_model(), {}), head_skin());
}

TEST(FaceModel, OnlyTheRegionMovesAndItsRimDoesNot) {
  const Points points = predicted(head_model(), {.forward_mm = 6, .yaw_deg = 3});
  const IntermediateMesh& region = head_model().problem().region;
  std::vector<bool> may_move(static_cast<std::size_t>(points.rows()), false);
  for (std::size_t v = 0; v < region.face_vertex.size(); ++v) {
    may_move[region.face_vertex[v]] = !region.rim[v];
  }
  int moved = 0;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if (may_move[v]) {
      moved += points.row(v) != head_skin().row(v);
    } else {
      EXPECT_EQ(points.row(v), head_skin().row(v)) << "vertex " << v;
    }
  }
  EXPECT_GT(moved, 50);
}

TEST(FaceModel, EqualsTheDirectSolve) {
  const std::array motion{
      rigid_motion({6, -2, 3, 5, -4, 7}, test::head_segment_at + Vector3d(1, 2, 3))};
  const StaticSolution direct = head_model().solve(motion);
  EXPECT_LT(direct.relative_residual, 1e-10);
  const double size = direct.displacements.norm();
  EXPECT_LT((head_model().tissue_displacements(motion) - direct.displacements).norm(),
            1e-12 * size);
  Points points;
  head_model().predict(motion, points);
  const IntermediateMesh& region = head_model().problem().region;
  for (std::size_t v = 0; v < region.face_vertex.size(); ++v) {
    const Eigen::RowVector3d u =
        points.row(region.face_vertex[v]) - head_skin().row(region.face_vertex[v]);
    EXPECT_LT((u - direct.displacements.row(static_cast<Eigen::Index>(v))).norm(), 1e-11);
  }
}

TEST(FaceModel, TheFaceFollowsTheBoneToThePatientsSides) {
  const Vector3d left = chin_moves(predicted(head_model(), {.left_mm = 5}));
  EXPECT_GT(left.x(), 1.5);
  EXPECT_LT(left.x(), 5);
  EXPECT_LT(std::abs(left.z()), 0.2);
  const Vector3d forward = chin_moves(predicted(head_model(), {.forward_mm = 5}));
  EXPECT_LT(forward.y(), -3);
  EXPECT_GT(forward.y(), -5.5);
  const Vector3d up = chin_moves(predicted(head_model(), {.up_mm = 5}));
  EXPECT_GT(up.z(), 1.5);
  EXPECT_LT(up.z(), 5);
}

TEST(FaceModel, TwoModelsOfTheSameHeadAgreeToTheBit) {
  Progress progress;
  const FaceModel again(test::head_scene(), reach_of_40, {}, progress);
  const JawMotion motion{5, 1, -2, 3, 2, 1};
  EXPECT_EQ(predicted(again, motion), predicted(head_model(), motion));
}

TEST(TissueProblem, HoldsTheTissueWhereTheBoneIs) {
  const TissueProblem& problem = head_model().problem();
  std::vector<bool> linked(problem.region.rim.size(), false);
  for (const BoneLink& link : problem.links) {
    for (const int v : problem.region.mesh.triangles.row(link.triangle)) linked[v] = true;
  }
  int attached = 0, on_segment = 0, fixed_on_skull = 0;
  const BspTree segment(test::head_scene().segments[0].mesh), skull(test::head_scene().remainder);
  for (int v = 0; v < problem.tissue.surface_count; ++v) {
    const Vector3d inner = problem.tissue.mesh.vertices.row(problem.tissue.inner(v));
    const Support support = problem.supports[problem.tissue.inner(v)];
    if (problem.region.rim[v]) {
      EXPECT_EQ(problem.supports[v], Support::fixed);
      EXPECT_EQ(support, Support::fixed);
      continue;
    }
    EXPECT_EQ(problem.supports[v], Support::free) << "skin is held";
    if (support == Support::attached) {
      ++attached;
      const bool on_bone = segment.nearest(inner, 2).has_value();
      on_segment += on_bone;
      EXPECT_TRUE(on_bone || linked[v]) << "neither on the segment nor met by a link from it";
      EXPECT_FALSE(skull.nearest(inner, 10)) << "next to the cut";
    } else if (support == Support::fixed) {
      ++fixed_on_skull;
      EXPECT_TRUE(skull.nearest(inner, 2))
          << "not on the skull";  // a tenth of 20 mm may be missing
    }
  }
  EXPECT_EQ(attached, problem.attached_count);
  EXPECT_EQ(fixed_on_skull, problem.on_skull_count);
  EXPECT_GT(attached, 10);
  EXPECT_GT(on_segment, 10);
  EXPECT_GT(fixed_on_skull, 3);
  EXPECT_GT(problem.rim_to_segment, 15);
}

TEST(TissueProblem, BoneNextToTheCutReleasesTheTissue) {
  Progress progress;
  TissueModel none;
  none.released_mm = 0;
  const TissueProblem held = build_tissue(test::head_scene(), reach_of_40, none, progress);
  EXPECT_EQ(held.released_count, 0);
  TissueModel wide;
  wide.released_mm = 25;
  const TissueProblem released = build_tissue(test::head_scene(), reach_of_40, wide, progress);
  EXPECT_GT(released.released_count, 3);
  EXPECT_LT(released.attached_count, held.attached_count);
}

TEST(TissueProblem, ASmallSegmentKeepsTheTissueFarthestFromOtherBone) {
  Progress progress;
  TissueModel wide;
  wide.released_mm = 200;  // all of the segment is nearer than that to other bone
  const TissueProblem problem = build_tissue(test::head_scene(), reach_of_40, wide, progress);
  EXPECT_GT(problem.released_count, 3);
  EXPECT_GT(problem.attached_count, 3);
  const std::vector<std::string> notices = progress.notices();
  EXPECT_TRUE(std::ranges::any_of(notices, [](const std::string& notice) {
    return notice.find("it is small") != std::string::npos;
  }));
}

/// The head with the ball under the cheek as a second segment.
Anatomy two_segments() {
  Anatomy head = test::head_scene();
  head.segments.push_back(
      {"cheek", test::sphere(test::head_cheek_bone, 12, 3), 0, test::head_cheek_bone});
  head.remainder = test::sphere({0, 0, 0}, 40, 3);
  return head;
}

TEST(FaceModel, TwoSegmentsMoveTheFaceTogetherExactlyAsADirectSolve) {
  Progress progress;
  const FaceModel model(two_segments(), reach_of_40, {}, progress);
  const JawMotion forward{.forward_mm = 4, .pitch_deg = 3}, outward{.left_mm = 3, .yaw_deg = -2};
  const std::array both{rigid_motion(forward, test::head_segment_at),
                        rigid_motion(outward, test::head_cheek_bone)};
  const StaticSolution direct = model.solve(both);
  EXPECT_LT((model.tissue_displacements(both) - direct.displacements).norm(),
            1e-12 * direct.displacements.norm());
  Points together, chin_alone, cheek_alone;
  model.predict(both, together);
  model.predict(std::array{both[0], RigidMotion{}}, chin_alone);
  model.predict(std::array{RigidMotion{}, both[1]}, cheek_alone);
  EXPECT_LT((together + head_skin() - chin_alone - cheek_alone).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_GT((chin_alone - head_skin()).cwiseAbs().maxCoeff(), 3);
  EXPECT_GT((cheek_alone - head_skin()).cwiseAbs().maxCoeff(), 2);
}

TEST(FaceModel, LandmarksFollowTheNearestSegment) {
  Progress progress;
  const Anatomy head = two_segments();
  const FaceModel model(head, reach_of_40, {}, progress);
  const std::array motions{rigid_motion({.forward_mm = 4}, test::head_segment_at),
                           rigid_motion({.up_mm = 2}, test::head_cheek_bone)};
  Points points;
  model.predict(motions, points);
  const FaceLandmarks landmarks(
      {{"chin", test::head_chin}, {"cheek", 80 * test::head_cheek_bone.normalized()}},
      head.face.mesh.surface, head.segments);
  const auto found = landmarks.responses(points, motions);
  EXPECT_NEAR(found.at("chin").bone_mm, 4, 1e-12);
  EXPECT_NEAR(found.at("cheek").bone_mm, 2, 1e-12);
}

/// All vertices within 15 mm of the chin are marked to slide.
TissueModel sliding_chin() {
  TissueModel model;
  for (int v = 0; v < head_skin().rows(); ++v) {
    if ((head_skin().row(v).transpose() - test::head_chin).norm() < 15) {
      model.sliding_vertices.push_back(v);
    }
  }
  return model;
}

TEST(TissueProblem, MarkedTissueSlidesAlongTheBoneAndFollowsItsNormal) {
  Progress progress;
  Anatomy head = test::head_scene();
  const FaceModel model(head, reach_of_40, sliding_chin(), progress);
  const TissueProblem& problem = model.problem();
  EXPECT_GT(problem.sliding_count, 10);
  EXPECT_LT(problem.attached_count, head_model().problem().attached_count);
  for (const Support& support : problem.supports) {
    if (support == Support::sliding) {
      EXPECT_NEAR(support.normal.norm(), 1, 1e-12);
    }
  }
  const Vector3d attached = chin_moves(predicted(head_model(), {.left_mm = 5}));
  const Vector3d slides = chin_moves(predicted(model, {.left_mm = 5}));
  EXPECT_LT(slides.x(), 0.8 * attached.x()) << "sideways motion of the bone is not passed on";
  EXPECT_LT(chin_moves(predicted(model, {.forward_mm = 5})).y(), -2.5) << "forward motion is";
}

TEST(TissueProblem, RefusesToSlideBelowVerticesThatAreNotOfTheFace) {
  TissueModel model;
  model.sliding_vertices = {3, 1000000};
  Progress progress;
  expect_error(ErrorKind::case_file, {"tissue.sliding_vertices", "1000000"},
               [&] { build_tissue(test::head_scene(), reach_of_40, model, progress); });
}

TEST(TissueProblem, ADenseFaceIsRemeshedAndItsPredictionIsTheCoarseOnes) {
  Progress progress;
  Anatomy dense = test::head_scene();
  dense.face = test::face_of(test::sphere({0, 0, 0}, 80, 7));  // edges of 1 mm
  const FaceModel fine(dense, reach_of_40, {}, progress);
  const TissueProblem& problem = fine.problem();
  EXPECT_GT(problem.face_vertices.size(),
            4 * static_cast<std::size_t>(problem.region.mesh.vertices.rows()));
  EXPECT_GT(problem.remeshed_mm, 0);
  EXPECT_LT(problem.remeshed_mm, 0.1);
  Points points;
  fine.predict(motions({.forward_mm = 5}), points);
  const Vector3d coarse = chin_moves(predicted(head_model(), {.forward_mm = 5}));
  const auto chin = [&] {
    Eigen::Index at = 0;
    (dense.face.mesh.surface.vertices.rowwise() - test::head_chin.transpose())
        .rowwise()
        .norm()
        .minCoeff(&at);
    return Eigen::Vector3d(points.row(at) - dense.face.mesh.surface.vertices.row(at));
  }();
  EXPECT_NEAR(chin.y(), coarse.y(), 0.4);
}

TEST(FaceModel, RefusesARegionWithNoBoneOfTheSegmentBelow) {
  const Anatomy head = test::head_scene();
  RegionChoice back;
  for (int v = 0; v < head_skin().rows(); ++v) {
    if (head_skin()(v, 1) > 60) back.vertices.push_back(v);
  }
  for (const LoadModel load : {LoadModel::displacement, LoadModel::force}) {
    TissueModel model;
    model.load = load;
    Progress progress;
    expect_error(ErrorKind::anatomy, {"region", "no bone"},
                 [&] { FaceModel(head, back, model, progress); });
  }
}

TEST(FaceModel, RefusesARegionWithoutARim) {
  Progress progress;
  expect_error(ErrorKind::anatomy, {"no rim"}, [&] {
    FaceModel(test::head_scene(), RegionChoice{500, {}, false, {}}, {}, progress);
  });
}

TEST(FaceModel, RefusesAMaterialOutOfRange) {
  TissueModel model;
  model.material.poisson = 0.5;
  Progress progress;
  expect_error(ErrorKind::case_file, {"tissue.poisson"},
               [&] { FaceModel(test::head_scene(), reach_of_40, model, progress); });
}

TEST(FaceModel, CanBeCancelled) {
  Progress progress;
  progress.cancel();
  expect_error(ErrorKind::cancelled, {},
               [&] { FaceModel(test::head_scene(), reach_of_40, {}, progress); });
}

TEST(FaceModel, SaysWhenTheRimComesNearTheMovingBone) {
  Progress progress;
  build_tissue(test::head_scene(), RegionChoice{13, {}, false, {}}, {}, progress);
  ASSERT_EQ(progress.notices().size(), 1U);
  EXPECT_NE(progress.notices()[0].find("rim"), std::string::npos);
}

class ForceTransfer : public ::testing::Test {
 protected:
  ForceTransfer() : model_(test::head_scene(), reach_of_40, force(), progress_) {}
  static TissueModel force() {
    TissueModel model;
    model.load = LoadModel::force;
    return model;
  }
  Progress progress_;
  const FaceModel model_;
};

TEST_F(ForceTransfer, PushesTheFaceAlongTheMotion) {
  EXPECT_EQ(predicted(model_, {}), head_skin());
  EXPECT_LT(chin_moves(predicted(model_, {.forward_mm = 5})).y(), -2);
  EXPECT_FALSE(model_.problem().forced.empty());
  EXPECT_EQ(model_.problem().attached_count, 0);
}

TEST_F(ForceTransfer, EqualsTheDirectSolve) {
  const auto motion = motions({4, 1, 2, 0, 0, 0});
  const Points direct = model_.solve(motion).displacements;
  EXPECT_LT((model_.tissue_displacements(motion) - direct).norm(), 1e-12 * direct.norm());
}

TEST_F(ForceTransfer, RefusesRotations) {
  expect_error(ErrorKind::case_file, {"tissue.load", "displacement"},
               [&] { predicted(model_, {.pitch_deg = 1}); });
  expect_error(ErrorKind::case_file, {"tissue.load"},
               [&] { model_.solve(motions({.pitch_deg = 1})); });
}

/// A patch of skin over a block of bone, all of it the region.
Anatomy patch_scene(const TriangleMesh& skin, double depth) {
  const Eigen::RowVector3d middle = skin.vertices.colwise().mean();
  Anatomy patch;
  patch.face = test::face_of(skin);
  patch.segments = {
      {"block", test::box(middle.transpose() - Vector3d(0, 0, depth + 5), Vector3d(12, 12, 5), 8),
       0, middle.transpose()}};
  patch.remainder = test::sphere(middle.transpose() - Vector3d(0, 0, 200), 5, 2);
  return patch;
}

RegionChoice all_of(const TriangleMesh& skin) {
  RegionChoice all;
  all.vertices.resize(static_cast<std::size_t>(skin.vertices.rows()));
  std::iota(all.vertices.begin(), all.vertices.end(), 0);
  return all;
}

TEST(PaperGenerator, PredictsOnAFlatPatchAndRefusesAHardOneWithTheCount) {
  TissueModel model;
  model.generator = Generator::paper;
  model.depth_mm = 5;
  Progress progress;
  const TriangleMesh flat = testing::flat_disk(676, 100, 2.2);
  const FaceModel good(patch_scene(flat, 5), all_of(flat), model, progress);
  Points points;
  good.predict(std::array{RigidMotion{Eigen::Matrix3d::Identity(), Vector3d(0, 0, 3)}}, points);
  EXPECT_GT((points - flat.vertices).col(2).maxCoeff(), 2);

  const TriangleMesh hard = testing::hard_patch(1, 0);
  const Anatomy lips = patch_scene(hard, 12);
  expect_error(ErrorKind::anatomy, {"tissue.generator", "inverts", "robust"},
               [&] { FaceModel(lips, all_of(hard), model, progress); });
  model.generator = Generator::robust;
  EXPECT_NO_THROW(FaceModel(lips, all_of(hard), model, progress));
}

}  // namespace
}  // namespace gnathion
