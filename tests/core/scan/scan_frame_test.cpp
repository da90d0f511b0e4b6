#include "scan/scan_frame.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/scan/scan_files.h"
#include "support/expect_error.h"
#include "support/solids.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

TEST(ScanAxes, OfTheRealHeadAreFoundFromAnyRightAngle) {
  const fs::path file = fs::path(GNATHION_SHARED_DATA) / "face-scan/LeePerrySmith.obj";
  if (!fs::exists(file)) GTEST_SKIP() << "the real scan is not at hand";
  const TriangleMesh head = test::read(file).mesh().surface;
  // SOURCE.md: x the subject's left, y up, z forward.
  const Eigen::Matrix3d lps_from_file =
      (Eigen::Matrix3d() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
  const double right = M_PI / 2;
  for (int x = 0; x < 4; ++x) {
    for (int z = 0; z < 4; ++z) {
      Eigen::Matrix3d turn = (Eigen::AngleAxisd(x * right, Eigen::Vector3d::UnitX()) *
                              Eigen::AngleAxisd(z * right, Eigen::Vector3d::UnitZ()))
                                 .toRotationMatrix();
      turn = turn.array().round();
      const TriangleMesh turned{head.vertices * turn.transpose(), head.triangles};
      const ProposedAxes axes = scan_axes(turned);
      EXPECT_EQ(axes.lps_from_scan * turn, lps_from_file) << axes.reason;
      EXPECT_EQ(axes.confidence, Confidence::fair);
    }
  }
}

/// A mask, open behind, bulging towards +x, with a ridge along z that ends below like a nose.
TriangleMesh mask_towards_x() {
  TriangleMesh mesh;
  constexpr int n = 81;
  mesh.vertices.resize(n * n, 3);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double y = (i - 40) * 2.0, z = (j - 40) * 2.5;
      const double along = z > -10 ? std::exp(-(z + 10) / 40) : std::exp(-(z + 10) * (z + 10) / 16);
      const double nose = 30 * std::exp(-y * y / 150) * along;
      mesh.vertices.row(i * n + j) << -y * y / 80 - z * z / 250 + nose, y, z;
    }
  }
  std::vector<int> corners;
  for (int i = 0; i + 1 < n; ++i) {
    for (int j = 0; j + 1 < n; ++j) {
      const int a = i * n + j, b = a + n, c = b + 1, d = a + 1;
      corners.insert(corners.end(), {a, b, c, a, c, d});
    }
  }
  mesh.triangles = Eigen::Map<const Triangles>(corners.data(), Eigen::Index(corners.size() / 3), 3);
  return mesh;
}

TEST(ScanAxes, OfAMaskThatIsOpenBehindAreFoundByItsNose) {
  const ProposedAxes axes = scan_axes(mask_towards_x());
  // Forward is +x and up is +z, so that the left is +y.
  EXPECT_EQ(axes.lps_from_scan, (Eigen::Matrix3d() << 0, 1, 0, -1, 0, 0, 0, 0, 1).finished())
      << axes.reason;
}

TEST(ScanAxes, OfABallAreNotBelieved) {
  const ProposedAxes axes = scan_axes(test::sphere({0, 0, 0}, 100, 3));
  EXPECT_EQ(axes.confidence, Confidence::low);
  EXPECT_NEAR(axes.lps_from_scan.determinant(), 1, 1e-12);
}

TEST(CheckedSimilarity, TakesRotationAndScaleAndRefusesMirrors) {
  Eigen::Matrix4d good = Eigen::Matrix4d::Identity();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  good.topLeftCorner<3, 3>() = 25.4 * turn;
  good.topRightCorner<3, 1>() << 1, 2, 3;
  const Similarity s = checked_similarity(good, "transform");
  EXPECT_NEAR(s.scale, 25.4, 1e-12);
  EXPECT_TRUE(s.rotation.isApprox(turn));
  const auto refused = [](const Eigen::Matrix4d& m, const char* word) {
    test::expect_error(ErrorKind::input, {"transform", word},
                       [&] { checked_similarity(m, "transform"); });
  };
  Eigen::Matrix4d bad = good;
  bad.col(0) *= -1;
  refused(bad, "mirrors");
  bad = good;
  bad.col(0) *= 1.1;
  refused(bad, "shears");
  bad = good;
  bad(0, 0) = std::nan("");
  refused(bad, "finite");
  bad = good;
  bad(3, 0) = 1;
  refused(bad, "last row");
  refused(Eigen::Matrix4d::Zero() + Eigen::Matrix4d::Identity().row(3).asDiagonal().toDenseMatrix(),
          "shears");
}

}  // namespace
}  // namespace gnathion
