#include "prediction/face_change.h"

#include <gtest/gtest.h>

#include "geometry/triangle_mesh.h"

namespace gnathion::test {
namespace {

/// A flat square of 2 mm with its middle vertex raised to a pyramid of `height`.
TriangleMesh pyramid(double height) {
  TriangleMesh mesh;
  mesh.vertices.resize(5, 3);
  mesh.vertices << 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 1, height;
  mesh.triangles.resize(4, 3);
  mesh.triangles << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
  return mesh;
}

TEST(FaceChange, MeasuresWhatAPyramidGains) {
  const TriangleMesh flat = pyramid(0);
  const FaceChange change = face_change(flat, {4}, pyramid(1.5).vertices, nullptr);
  EXPECT_NEAR(change.volume_mm3, 4 * 1.5 / 3, 1e-12);
  EXPECT_NEAR(change.area_mm2, 4, 1e-12);
  EXPECT_NEAR(change.displacement_size.max, 1.5, 1e-12);
  EXPECT_EQ(change.signed_mm.size(), 0);
  EXPECT_FALSE(change.error);
  EXPECT_NEAR(face_change(pyramid(1.5), {4}, flat.vertices, nullptr).volume_mm3, -2, 1e-12);
}

TEST(FaceChange, TakesMeasuresAndErrorOfAPrediction) {
  const TriangleMesh flat = pyramid(0);
  Prediction prediction;
  prediction.signed_distance = Eigen::VectorXd::Zero(5);
  prediction.signed_distance[4] = -0.7;
  prediction.answer.error.total.mean = 0.25;
  const FaceChange change = face_change(flat, {1, 4}, pyramid(-0.7).vertices, &prediction);
  EXPECT_EQ(change.signed_mm.size(), 2);
  EXPECT_EQ(change.signed_size.max, 0.7);
  ASSERT_TRUE(change.error);
  EXPECT_NEAR(change.volume_error_mm3(), 4 * 0.25, 1e-12);
}

TEST(FaceChange, WithoutARegionIsNothing) {
  const TriangleMesh flat = pyramid(0);
  const FaceChange change = face_change(flat, {}, flat.vertices, nullptr);
  EXPECT_EQ(change.volume_mm3, 0);
  EXPECT_EQ(change.displacement_size.count, 0);
}

}  // namespace
}  // namespace gnathion::test
