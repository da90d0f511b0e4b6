#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>

#include "base/error.h"
#include "prediction/anatomy.h"
#include "support/expect_error.h"
#include "support/solids.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
using test::TemporaryFolder;
using Stages = std::vector<std::string>;

/// A CT of 64³ voxels of 3 mm: a head of 80 mm radius in air with a ball of bone of 35 mm.
void write_ball_ct(const TemporaryFolder& folder, const std::string& name, double bone_radius) {
  constexpr int kSide = 64;
  constexpr double kStep = 3, kOffset = -0.5 * kStep * (kSide - 1);
  std::string text =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
      "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = " +
      std::to_string(kOffset) + " " + std::to_string(kOffset) + " " + std::to_string(kOffset) +
      "\nElementSpacing = 3 3 3\nDimSize = 64 64 64\nElementType = MET_SHORT\n"
      "ElementDataFile = LOCAL\n";
  // HU falls over 6 mm at each border, so that the surfaces are smooth.
  const auto inside = [](double depth) { return std::clamp(0.5 + depth / 6, 0.0, 1.0); };
  for (int k = 0; k < kSide; ++k) {
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const double r = (kOffset + kStep * Eigen::Array3d(i, j, k)).matrix().norm();
        const int hu =
            static_cast<int>(-1000 + 1040 * inside(80 - r) + 960 * inside(bone_radius - r));
        text += static_cast<char>(hu & 255);
        text += static_cast<char>((hu >> 8) & 255);
      }
    }
  }
  folder.write(name, text);
}

void expect_same(const TriangleMesh& a, const TriangleMesh& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

/// To the bit.
void expect_same(const Anatomy& a, const Anatomy& b) {
  EXPECT_EQ(a.ct->hu(), b.ct->hu());
  EXPECT_EQ(a.ct->lps_from_ijk(), b.ct->lps_from_ijk());
  EXPECT_EQ(a.ct_sha256, b.ct_sha256);
  expect_same(a.bone, b.bone);
  expect_same(a.remainder, b.remainder);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t s = 0; s < a.segments.size(); ++s) {
    EXPECT_EQ(a.segments[s].name, b.segments[s].name);
    expect_same(a.segments[s].mesh, b.segments[s].mesh);
    EXPECT_EQ(a.segments[s].volume_mm3, b.segments[s].volume_mm3);
    EXPECT_EQ(a.segments[s].pivot, b.segments[s].pivot);
  }
  ASSERT_EQ(a.left_by_cut.size(), b.left_by_cut.size());
  for (std::size_t s = 0; s < a.left_by_cut.size(); ++s) {
    expect_same(*a.left_by_cut[s], *b.left_by_cut[s]);
  }
  EXPECT_EQ(a.face.is_photograph, b.face.is_photograph);
  EXPECT_EQ(a.face.lps_from_file, b.face.lps_from_file);
  expect_same(a.face.mesh.surface, b.face.mesh.surface);
  expect_same(a.face.document.mesh().surface, b.face.document.mesh().surface);
  const Points& file = b.face.document.mesh().surface.vertices;
  EXPECT_EQ(a.face.document.text_with(file), b.face.document.text_with(file));
}

class AnatomyReuse : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    write_ball_ct(*folder_, "ct.mha", 35);
    write_ball_ct(*folder_, "other.mha", 33);
    for (const char* name : {"scan", "scan2"}) {
      const TriangleMesh surface =
          test::sphere({0, 0, 1}, name == std::string("scan") ? 80 : 70, 3);
      ObjDocument::of_surface(surface, name)
          .write(folder_->path(), std::string(name) + ".obj", surface.vertices);
    }
    Progress progress;
    known_ = std::make_unique<Anatomy>(build_anatomy(base(), progress));
  }
  static void TearDownTestSuite() {
    known_.reset();
    folder_.reset();
  }

  /// Three segments, the face the CT's skin.
  /// No blade passes through the voxels' middles, where vertices lie: see build_anatomy().
  static SurgicalCase base() {
    SurgicalCase plan;
    plan.ct.path = *folder_ / "ct.mha";
    plan.skin.edge_mm = 6;
    plan.segments = {
        {"front", box_between({-30, -50, -10}, {30, -20, 10}), {}, {}},
        {"low", box_between({-20, -10, -50}, {20, 10, -20}), {}, {}},
        {"top", PlateCut{{0, 0, 21}, {0, 0, 1}, {1, 0, 0}, 60, 60, 1, {0, 0, 34}}, {}, {}}};
    return plan;
  }

  static Stages stages_of(const Progress& progress) {
    Stages names;
    for (const StageTime& time : progress.stage_times()) names.push_back(time.name);
    std::sort(names.begin(), names.end());
    return names;
  }

  /// Builds `plan` from what is known of `from` and from nothing: both must be the same, and the
  /// first run these stages only.
  static Anatomy check(const SurgicalCase& plan, const SurgicalCase& from, const Anatomy& known,
                       Stages expected) {
    Progress reusing, fresh;
    const KnownAnatomy both{from, known};
    Anatomy anatomy = build_anatomy(plan, reusing, &both);
    EXPECT_EQ(stages_of(reusing), expected);
    expect_same(anatomy, build_anatomy(plan, fresh));
    return anatomy;
  }
  static Anatomy check(const SurgicalCase& plan, const Stages& expected) {
    return check(plan, base(), *known_, expected);
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static std::unique_ptr<Anatomy> known_;  ///< of base()
};

std::unique_ptr<TemporaryFolder> AnatomyReuse::folder_;
std::unique_ptr<Anatomy> AnatomyReuse::known_;

TEST_F(AnatomyReuse, TheTestsOwnPlanCutsThreeSegments) {
  ASSERT_EQ(known_->segments.size(), 3u);
  for (const BoneSegment& segment : known_->segments) EXPECT_GT(segment.volume_mm3, 1000);
  EXPECT_EQ(known_->left_by_cut.size(), 2u);
  EXPECT_FALSE(known_->ct_sha256.empty());
}

TEST_F(AnatomyReuse, TheSamePlanRunsNothing) {
  const Anatomy same = check(base(), {});
  EXPECT_EQ(same.ct, known_->ct) << "the same object";
  EXPECT_EQ(same.left_by_cut, known_->left_by_cut) << "the same objects";
}

TEST_F(AnatomyReuse, WhatTheAnatomyDoesNotDependOnRunsNothing) {
  SurgicalCase plan = base();
  plan.name = "another";
  plan.region.vertices = {1, 2};
  plan.tissue.depth_mm = 5;
  plan.landmarks["chin"] = {0, -80, 0};
  plan.segments[1].motion.forward_mm = 3;
  check(plan, {});
}

TEST_F(AnatomyReuse, APivotAndANameAreTakenFromThePlan) {
  SurgicalCase plan = base();
  plan.segments[1].pivot = Vector3d(1, 2, 3);
  plan.segments[2].name = "roof";
  const Anatomy anatomy = check(plan, {});
  EXPECT_EQ(anatomy.segments[1].pivot, Vector3d(1, 2, 3));
  EXPECT_EQ(anatomy.segments[2].name, "roof");
  check(base(), plan, anatomy, {});  // and back to the centre of volume
}

TEST_F(AnatomyReuse, CutsRunFromTheFirstOneThatDiffers) {
  const std::vector<BoundedCut> other{
      box_between({-25, -50, -10}, {30, -20, 10}), box_between({-20, -10, -50}, {20, 10, -22}),
      PlateCut{{0, 0, 20}, {0, 0, 1}, {1, 0, 0}, 60, 60, 1, {0, 0, 34}}};
  for (std::size_t s = 0; s < 3; ++s) {
    SCOPED_TRACE(s);
    SurgicalCase plan = base();
    plan.segments[s].cut = other[s];
    check(plan, Stages(3 - s, "osteotomy"));
  }
}

TEST_F(AnatomyReuse, ASegmentMoreIsOneCutAndOneFewerFromTheEndIsNone) {
  SurgicalCase plan = base();
  plan.segments.push_back({"left", box_between({20, -15, -15}, {50, 15, 15}), {}, {}});
  const Anatomy more = check(plan, {"osteotomy"});
  check(base(), plan, more, {});
  plan.segments.resize(1);
  const Anatomy one = check(plan, {});
  plan.segments.clear();
  const Anatomy none = check(plan, {});
  check(base(), plan, none, Stages(3, "osteotomy"));
  plan = base();
  plan.segments.resize(1);
  check(base(), plan, one, Stages(2, "osteotomy"));
}

TEST_F(AnatomyReuse, ASegmentTakenFromTheMiddleCutsThoseAfterIt) {
  SurgicalCase plan = base();
  plan.segments.erase(plan.segments.begin() + 1);
  check(plan, {"osteotomy"});
  plan = base();
  std::swap(plan.segments[0], plan.segments[1]);
  check(plan, Stages(3, "osteotomy"));
}

TEST_F(AnatomyReuse, ACutThroughOtherBoneIsRefusedAsInItsPreview) {
  SurgicalCase plan = base();
  PlannedSegment slab, half;
  slab.name = "slab";
  slab.cut = box_between({-50, -50, -10}, {50, 50, 10});
  half.name = "half of the upper cap";
  PlateCut blade{.centre = {0, 0, 23},
                 .normal = {1, 0, 0},
                 .in_plane = {0, 1, 0},
                 .half_width = 50,
                 .half_height = 15,
                 .kerf = 0.5,
                 .seed = {15, 0, 20}};
  half.cut = blade;
  plan.segments = {slab, half};
  Progress progress;
  EXPECT_EQ(build_anatomy(plan, progress, nullptr).segments.size(), 2u);
  blade.centre = {0, 0, 0};
  blade.half_height = 60;  // through the lower cap too
  plan.segments[1].cut = blade;
  test::expect_error(ErrorKind::anatomy, {"half of the upper cap", "also cuts bone"},
                     [&] { build_anatomy(plan, progress, nullptr); });
}

TEST_F(AnatomyReuse, WithoutSegmentsTheBoneRemains) {
  SurgicalCase plan = base();
  plan.segments.clear();
  Progress progress;
  const Anatomy anatomy = build_anatomy(plan, progress);
  EXPECT_TRUE(anatomy.segments.empty());
  expect_same(anatomy.remainder, anatomy.bone);
  EXPECT_TRUE(planned_motions(plan, anatomy).empty());
}

TEST_F(AnatomyReuse, AnotherLevelOfTheBoneLeavesTheCtAndTheSkin) {
  SurgicalCase plan = base();
  plan.bone.hu = 400;
  check(plan, {"bone surface", "osteotomy", "osteotomy", "osteotomy"});
}

TEST_F(AnatomyReuse, OtherOptionsOfTheSkinLeaveTheBoneAndItsCuts) {
  SurgicalCase plan = base();
  plan.skin.edge_mm = 8;
  check(plan, {"skin surface"});
}

TEST_F(AnatomyReuse, AnotherCtRunsEverything) {
  SurgicalCase plan = base();
  plan.ct.path = *folder_ / "other.mha";
  const Anatomy other = check(plan, {"bone surface", "osteotomy", "osteotomy", "osteotomy",
                                     "read volume file", "skin surface"});
  EXPECT_NE(other.ct_sha256, known_->ct_sha256);
}

TEST_F(AnatomyReuse, APhotographIsReadOnceAndPlacedAnew) {
  SurgicalCase plan = base();
  plan.photograph = PhotographSource{*folder_ / "scan.obj", {}};
  const Anatomy pictured = check(plan, {"read photograph"});
  check(plan, plan, pictured, {});
  SurgicalCase edit = plan;
  edit.photograph->lps_from_photograph = {
      1.05, Eigen::AngleAxisd(0.2, Vector3d::UnitZ()).toRotationMatrix(), {1, 2, 3}};
  check(edit, plan, pictured, {});
  edit.photograph->obj = *folder_ / "scan2.obj";
  check(edit, plan, pictured, {"read photograph"});
  check(base(), plan, pictured, {"skin surface"});
  edit = plan;
  edit.ct.path = *folder_ / "other.mha";
  check(edit, plan, pictured,
        {"bone surface", "osteotomy", "osteotomy", "osteotomy", "read volume file"});
}

TEST_F(AnatomyReuse, AMistakeInThePlacingOfAKnownPhotographIsToldAsOfANewOne) {
  SurgicalCase plan = base();
  plan.photograph = PhotographSource{*folder_ / "scan.obj", {}};
  Progress progress;
  const Anatomy pictured = build_anatomy(plan, progress);
  SurgicalCase edit = plan;
  edit.photograph->lps_from_photograph.scale = 0.01;
  const KnownAnatomy known{plan, pictured};
  test::expect_error(ErrorKind::input, {"scan.obj", "transform.scale"},
                     [&] { build_anatomy(edit, progress, &known); });
}

TEST_F(AnatomyReuse, AnAnatomyThatKeptNoRemaindersIsCutFromTheStart) {
  Anatomy bare = *known_;
  bare.left_by_cut.clear();
  check(base(), base(), bare, Stages(3, "osteotomy"));
}

TEST_F(AnatomyReuse, CanBeCancelledAtEveryStageAndWithNothingToDo) {
  SurgicalCase plan = base();
  plan.bone.hu = 400;
  plan.skin.edge_mm = 8;
  const SurgicalCase first = base();
  const KnownAnatomy same{first, *known_};
  {
    Progress progress;
    progress.cancel();
    test::expect_error(ErrorKind::cancelled, {}, [&] { build_anatomy(first, progress, &same); });
  }
  for (const char* at : {"bone surface", "skin surface", "osteotomy"}) {
    SCOPED_TRACE(at);
    Progress* running = nullptr;
    Progress progress([&](const std::string& stage) {
      if (stage == at) running->cancel();
    });
    running = &progress;
    test::expect_error(ErrorKind::cancelled, {}, [&] { build_anatomy(plan, progress, &same); });
  }
}

}  // namespace
}  // namespace gnathion
