#include "geometry/plane_section.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <cmath>

namespace gnathion::test {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A closed ball around `centre`, two triangles a cell of latitude and longitude.
TriangleMesh ball(double radius, const Eigen::Vector3d& centre, int rings) {
  TriangleMesh mesh;
  const int around = 2 * rings;
  mesh.vertices.resize((rings + 1) * around, 3);
  mesh.triangles.resize(2 * rings * around, 3);
  for (int r = 0; r <= rings; ++r) {
    for (int a = 0; a < around; ++a) {
      const double polar = pi * r / rings, turn = pi * a / rings;
      mesh.vertices.row(r * around + a) =
          centre.transpose() + radius * Eigen::RowVector3d(std::sin(polar) * std::cos(turn),
                                                           std::sin(polar) * std::sin(turn),
                                                           std::cos(polar));
    }
  }
  int t = 0;
  for (int r = 0; r < rings; ++r) {
    for (int a = 0; a < around; ++a) {
      const int p = r * around + a, q = r * around + (a + 1) % around;
      mesh.triangles.row(t++) << p, p + around, q;
      mesh.triangles.row(t++) << q, p + around, q + around;
    }
  }
  return mesh;
}

double length(const std::vector<SectionLine>& lines) {
  double sum = 0;
  for (const auto& [a, b] : lines) sum += (b - a).norm();
  return sum;
}

TEST(PlaneSection, OfABallIsACircle) {
  const Eigen::Vector3d centre(5, -7, 11);
  const PlaneSection section(std::make_shared<TriangleMesh>(ball(10, centre, 100)));
  for (const Eigen::Vector3d& direction :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(1, 2, 3)}) {
    const Eigen::Vector3d normal = direction.normalized();
    for (const double height : {-6.0, 0.1, 8.0}) {
      const double offset = normal.dot(centre) + height;
      const std::vector<SectionLine> lines = section.cut(normal, offset);
      const double radius = std::sqrt(100 - height * height);
      EXPECT_NEAR(length(lines), 2 * pi * radius, 0.01 * 2 * pi * radius);
      for (const auto& [a, b] : lines) {
        EXPECT_NEAR(normal.dot(a), offset, 1e-9);
        EXPECT_NEAR((a - centre - height * normal).norm(), radius, 0.02);
      }
    }
    EXPECT_TRUE(section.cut(normal, normal.dot(centre) + 10.01).empty());
    EXPECT_TRUE(section.cut(normal, normal.dot(centre) - 10.01).empty());
  }
}

TEST(PlaneSection, ThroughVerticesStillCloses) {
  // Every end meets one other.
  const PlaneSection section(std::make_shared<TriangleMesh>(ball(10, {0, 0, 0}, 20)));
  const std::vector<SectionLine> lines = section.cut({0, 0, 1}, 0);
  EXPECT_FALSE(lines.empty());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& [a, b] : lines) {
    for (const Eigen::Vector3d& end : {a, b}) {
      int meetings = 0;
      for (const auto& [c, d] : lines)
        meetings += ((c - end).norm() < 1e-9) + ((d - end).norm() < 1e-9);
      EXPECT_GE(meetings, 2);
    }
    sum += a + b;
  }
  EXPECT_LT(sum.norm(), 1e-6);
}

TEST(PlaneSection, FollowsMovedPoints) {
  const TriangleMesh mesh = ball(10, {0, 0, 0}, 30);
  PlaneSection section(std::make_shared<TriangleMesh>(mesh));
  EXPECT_TRUE(section.cut({1, 0, 0}, 25).empty());
  Points moved = mesh.vertices;
  moved.col(0).array() += 25;
  section.set_points(moved);
  EXPECT_NEAR(length(section.cut({1, 0, 0}, 25.01)), 20 * pi, 1);
  EXPECT_TRUE(section.cut({1, 0, 0}, 0).empty());
}

}  // namespace
}  // namespace gnathion::test
