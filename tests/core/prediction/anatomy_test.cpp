#include "prediction/anatomy.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/error.h"
#include "support/expect_error.h"
#include "support/head_scene.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
using test::TemporaryFolder;

/// A face scan in units of 50 mm, turned and shifted.
struct Scan {
  TemporaryFolder folder;
  PhotographSource source;
  Face face;

  Scan() : source{folder / "scan.obj", {}}, face{{}, empty(), {}, true} {
    source.lps_from_photograph = {
        50, Eigen::AngleAxisd(1.2, Vector3d(1, 0.3, -2).normalized()).toRotationMatrix(),
        Vector3d(3, -61, 1. / 3)};
    const TriangleMesh surface = test::sphere({0.06, -0.3, 0.01}, 1.6, 3);
    ObjDocument::of_surface(surface, "scan").write(folder.path(), "scan.obj", surface.vertices);
    Progress progress;
    face = photograph_face(source, progress);
  }
  static ObjDocument empty() { return test::face_of(test::sphere({0, 0, 0}, 1, 0)).document; }
};

TEST(PhotographFace, IsPutIntoLpsByTheTransform) {
  const Scan scan;
  ASSERT_TRUE(scan.face.is_photograph);
  const Points& file = scan.face.document.mesh().surface.vertices;
  for (Eigen::Index v = 0; v < file.rows(); ++v) {
    const Vector3d lps = scan.source.lps_from_photograph(file.row(v).transpose());
    EXPECT_LT((scan.face.mesh.surface.vertices.row(v).transpose() - lps).norm(), 1e-12);
  }
}

TEST(PhotographFace, UnmovedPointsGetTheFilesOwnNumbersBack) {
  const Scan scan;
  const Points& lps = scan.face.mesh.surface.vertices;
  const Points& file = scan.face.document.mesh().surface.vertices;
  EXPECT_EQ(scan.face.file_vertices(lps), file);
  Points moved = lps;
  for (Eigen::Index v = 0; v < moved.rows(); v += 3)
    moved.row(v) += Eigen::RowVector3d(2, -5, 0.25);
  const Points written = scan.face.file_vertices(moved);
  for (Eigen::Index v = 0; v < moved.rows(); ++v) {
    if (v % 3 != 0) {
      EXPECT_EQ(written.row(v), file.row(v));
      continue;
    }
    const Vector3d back = scan.source.lps_from_photograph(written.row(v).transpose());
    EXPECT_LT((back - moved.row(v).transpose()).norm(), 1e-12);
  }
}

TEST(PhotographFace, OfAnotherUnitIsRefusedByItsSize) {
  Scan scan;
  for (const double scale : {0.05, 5000.0}) {
    scan.source.lps_from_photograph.scale = scale;
    test::expect_error(ErrorKind::input, {"scan.obj", "mm across", "transform.scale"}, [&] {
      Progress progress;
      photograph_face(scan.source, progress);
    });
  }
}

TEST(BuildAnatomy, AMissingPhotographIsToldBeforeTheCtIsRead) {
  const TemporaryFolder folder;
  SurgicalCase plan;
  plan.ct.path = folder / "no ct";
  plan.photograph = PhotographSource{folder / "no face.obj", {}};
  Progress progress;
  test::expect_error(ErrorKind::input, {"no face.obj"}, [&] { build_anatomy(plan, progress); });
  plan.photograph.reset();
  test::expect_error(ErrorKind::input, {"no ct"}, [&] { build_anatomy(plan, progress); });
}

}  // namespace
}  // namespace gnathion
