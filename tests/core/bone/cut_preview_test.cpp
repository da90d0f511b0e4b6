#include "bone/cut_preview.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <string>

#include "core/bone/heads.h"
#include "geometry/triangle_mesh.h"
#include "support/expect_error.h"
#include "support/solids.h"

namespace gnathion::test {
namespace {

/// A bar along x, 60 × 10 × 10 mm, finely divided.
TriangleMesh bar() {
  return box({0, 0, 0}, {30, 5, 5}, 24);
}

/// Blade across the bar at x that takes what is beyond it.
PlateCut blade_at(double x) {
  PlateCut blade;
  blade.centre = {x, 0, 0};
  blade.normal = {2, 0, 0};
  blade.in_plane = {1, 1, 0};
  blade.half_width = 8;
  blade.half_height = 9;
  blade.kerf = 0.8;
  blade.seed = {25, 0, 0};
  return blade;
}

SegmentResult cut(const TriangleMesh& bone, const BoundedCut& how) {
  Progress progress;
  return cut_segment(bone, how, {}, progress);
}

std::string problem(const CutPreview& preview) {
  return preview.refusal ? preview.refusal->what() : "";
}

std::ptrdiff_t count(const CutPreview& preview, CutPart part) {
  return std::count(preview.part.begin(), preview.part.end(), part);
}

/// The preview allows the cut and tells the volumes that the saw gives.
void expect_agreement(const CutPreviewer& previewer, const BoundedCut& how, double share = 0.002) {
  const CutPreview preview = previewer.preview(how);
  EXPECT_EQ(problem(preview), "");
  const SegmentResult result = cut(previewer.bone(), how);
  EXPECT_NEAR(preview.segment_mm3, result.volume_mm3, share * result.volume_mm3);
}

TEST(CutPreview, TellsTheVolumeThatABladeTakes) {
  const CutPreviewer previewer(bar());
  expect_agreement(previewer, blade_at(10), 1e-9);
  const CutPreview preview = previewer.preview(blade_at(10));
  EXPECT_NEAR(preview.segment_mm3, 1960, 1e-6);
  EXPECT_NEAR(preview.sawn_mm2, 100, 1e-6);
  EXPECT_TRUE(preview.loose_mm3.empty());
  PlateCut other = blade_at(10);
  other.seed = {-40, 0, 0};  // beside the other piece
  EXPECT_NEAR(previewer.preview(other).segment_mm3, 3960, 1e-6);
  other.seed = {9.5, 0, 0};  // in it, just before the kerf
  EXPECT_NEAR(previewer.preview(other).segment_mm3, 3960, 1e-6);
}

TEST(CutPreview, ColoursWhatComesOff) {
  const CutPreviewer previewer(bar());
  const CutPreview preview = previewer.preview(blade_at(10));
  const TriangleMesh& bone = previewer.bone();
  for (std::size_t t = 0; t < preview.part.size(); ++t) {
    const auto corners = bone.triangles.row(static_cast<Eigen::Index>(t));
    const Eigen::RowVector3d middle = bone.vertices(corners, Eigen::all).colwise().mean();
    if (std::abs(middle.x() - 10) < 2) continue;
    EXPECT_EQ(preview.part[t], middle.x() > 10 ? CutPart::segment : CutPart::kept);
  }
}

TEST(CutPreview, TellsTheVolumeInABoxHoweverItIsTurned) {
  const CutPreviewer previewer(bar());
  expect_agreement(previewer, box_between({11, -20, -20}, {50, 20, 20}), 1e-9);
  for (const double angle : {0.3, 0.8, 1.4}) {
    BoxCut box;
    box.centre = {20, 1, 2};
    box.axes = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    box.half_extents = {5, 20, 7};
    expect_agreement(previewer, box, 0.01);
    box.half_extents = {4, 3, 5};  // the bar's side looks into it
    expect_agreement(previewer, box, 0.01);
  }
}

TEST(CutPreview, SeesThroughCavities) {
  // A tube: the inner wall is joined to the outer one by the sawn rings only.
  TriangleMesh hollow = box({0, 0, 0}, {28, 3, 3}, 24);
  hollow.triangles.col(1).swap(hollow.triangles.col(2));
  const CutPreviewer previewer(joined(bar(), hollow));
  const CutPreview preview = previewer.preview(blade_at(10));
  EXPECT_EQ(problem(preview), "");
  // 20 mm of bar and 18 mm of hollow, without half the kerf.
  EXPECT_NEAR(preview.segment_mm3, 20 * 100 - 18 * 36 - 0.4 * 64, 1);
  EXPECT_NEAR(preview.sawn_mm2, 64, 0.5);
  const BoxCut inside = box_between({-5, -20, -20}, {5, 20, 20});
  EXPECT_NEAR(previewer.preview(inside).segment_mm3, 10 * 64, 1);
}

TEST(CutPreview, RefusesABladeThatStopsWithinTheBone) {
  const CutPreviewer previewer(bar());
  PlateCut small = blade_at(10);
  small.half_height = 3;
  CutPreview preview = previewer.preview(small);
  EXPECT_NE(problem(preview).find("does not pass through the whole bone"), std::string::npos);
  EXPECT_EQ(preview.segment_mm3, 0);
  EXPECT_EQ(count(preview, CutPart::segment), 0);
  EXPECT_GT(count(preview, CutPart::forbidden), 0);
  // It ends at y = 3 of 5: it is to be moved to the back.
  EXPECT_EQ(problem(preview).find("move it"), std::string::npos) << problem(preview);
  small = blade_at(10);
  small.centre.y() = -5;
  preview = previewer.preview(small);
  EXPECT_NE(problem(preview).find("move it back"), std::string::npos) << problem(preview);
  EXPECT_NE(problem(previewer.preview(blade_at(50))).find("does not touch"), std::string::npos);
}

TEST(CutPreview, RefusesToCutAnotherBone) {
  const TriangleMesh spine = box({0, 20, 0}, {30, 5, 5}, 24);
  const CutPreviewer previewer(joined(bar(), spine));
  EXPECT_EQ(problem(previewer.preview(blade_at(10))), "");
  PlateCut deep = blade_at(10);
  deep.in_plane = {0, 1, 0};
  deep.half_width = 40;
  CutPreview preview = previewer.preview(deep);
  EXPECT_NE(problem(preview).find("also cuts bone that does not belong to the segment: 1.0 cm² "
                                  "behind it"),
            std::string::npos)
      << problem(preview);
  EXPECT_GT(count(preview, CutPart::forbidden), 0);
  EXPECT_GT(preview.segment_mm3, 1900);  // it would come off all the same
  const BoundedCut large = box_between({0, -20, -20}, {15, 24, 20});
  preview = previewer.preview(large);
  EXPECT_NE(problem(preview).find("the box also cuts"), std::string::npos);
  EXPECT_NEAR(preview.segment_mm3, 1500, 1e-6);
  // Wholly in the box nothing of it is cut.
  const CutPreviewer beside(joined(bar(), box({8, 20, 0}, {3, 3, 3}, 8)));
  EXPECT_EQ(problem(beside.preview(large)), "");
}

TEST(CutPreview, RefusesToCutTheSameBoneElsewhere) {
  // A U: the legs run along y, and the blade that takes a leg's tip must not reach the other leg.
  const CutPreviewer u(
      cut(box({0, 0, 0}, {30, 30, 5}, 48), box_between({-20, -20, -9}, {20, 40, 9})).remainder);
  PlateCut blade;
  blade.centre = {25, 10, 0};
  blade.normal = {0, 1, 0};
  blade.half_width = 10;
  blade.half_height = 10;
  blade.seed = {25, 25, 0};
  expect_agreement(u, blade, 1e-6);
  blade.centre.x() = 0;
  blade.half_width = 40;
  const CutPreview preview = u.preview(blade);
  EXPECT_NE(problem(preview).find("on the patient's right of it"), std::string::npos)
      << problem(preview);
  ASSERT_EQ(preview.loose_mm3.size(), 1u);
  EXPECT_NEAR(preview.loose_mm3[0], preview.segment_mm3, 1e-6);
}

TEST(CutPreview, RefusesWhatIsTooSmallOrNoCut) {
  const CutPreviewer previewer(bar());
  const BoxCut sliver = box_between({29.5, -20, -20}, {50, 20, 20});
  EXPECT_NE(problem(previewer.preview(sliver)).find("too little bone"), std::string::npos);
  EXPECT_NE(problem(previewer.preview(box_between({50, 0, 0}, {60, 9, 9}))).find("does not touch"),
            std::string::npos);
  PlateCut flat = blade_at(10);
  flat.in_plane = flat.normal;
  expect_error(ErrorKind::anatomy, {"parallel"}, [&] { previewer.preview(flat); });
}

TEST(CutPreview, AgreesWithTheSawOnTheAnalyticHead) {
  const CutPreviewer previewer(analytic_bone());
  const PhantomTruth truth = phantom_truth();
  const BoxCut jaw = box_between(truth.mandible_box_min, truth.mandible_box_max);
  expect_agreement(previewer, jaw);
  BoxCut deep = jaw;  // into the spine
  deep.centre.y() += 35;
  deep.half_extents.y() += 35;
  EXPECT_NE(problem(previewer.preview(deep)).find("behind it"), std::string::npos);
}

TEST(CutPreview, AgreesWithTheSawOnTheRealCtInTimeForADrag) {
  const TriangleMesh& bone = real_bone();
  if (bone.triangles.rows() == 0) GTEST_SKIP() << "no real CT at " << GNATHION_SHARED_DATA;
  const CutPreviewer previewer(bone);
  const BoxCut jaw = box_between({-60, -305, 322}, {65, -215, 369});
  expect_agreement(previewer, jaw);
  PlateCut chin;  // all of the jaw's lower border, and the spine
  chin.centre = {2.5, -255, 349};
  chin.half_width = 60;
  chin.half_height = 100;
  chin.seed = {2.5, -296, 340};
  const auto start = std::chrono::steady_clock::now();
  const CutPreview preview = previewer.preview(chin);
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  std::cout << "real CT, " << bone.triangles.rows() << " triangles: preview in " << elapsed.count()
            << " ms\n";
  EXPECT_NE(problem(preview).find("behind it"), std::string::npos) << problem(preview);
  const double exact = cut(bone, chin).volume_mm3;
  EXPECT_NEAR(preview.segment_mm3, exact, 0.002 * exact);
}

}  // namespace
}  // namespace gnathion::test
