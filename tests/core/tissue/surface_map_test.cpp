#include "tissue/surface_map.h"

#include <gtest/gtest.h>

#include "support/face_patch.h"

namespace gnathion {
namespace {

IntermediateMesh three_of_six() {
  IntermediateMesh region;
  region.mesh.vertices = Points::Zero(3, 3);
  region.face_vertex = {1, 4, 3};
  return region;
}

TEST(SurfaceMap, PutsDisplacementsOnTheFacesOwnVertices) {
  const SurfaceMap W = index_map(three_of_six(), Points::Zero(6, 3));
  ASSERT_EQ(W.rows(), 6);
  ASSERT_EQ(W.cols(), 3);
  EXPECT_EQ(W.nonZeros(), 3);
  const Points u = Points::Random(3, 3);
  const Points face = W * u;
  EXPECT_EQ(face.row(1), u.row(0));
  EXPECT_EQ(face.row(4), u.row(1));
  EXPECT_EQ(face.row(3), u.row(2));
  for (const int still : {0, 2, 5}) EXPECT_EQ(face.row(still), Eigen::RowVector3d::Zero());
}

TEST(SurfaceMap, ComposedWithABasisEqualsTheMapOfItsDisplacements) {
  const SurfaceMap W = index_map(three_of_six(), Points::Zero(6, 3));
  const Eigen::MatrixXd basis =
      Eigen::MatrixXd::Random(3 * 5, 4);  // five nodes, three of them skin
  std::vector<int> rows;
  const Eigen::MatrixXd composed = compose(W, basis, rows);
  EXPECT_EQ(rows, (std::vector<int>{1, 3, 4}));
  ASSERT_EQ(composed.rows(), 9);
  const Eigen::Vector4d q(1, -2, 0.5, 3);
  const Eigen::VectorXd nodes = basis * q;
  const Points u = Eigen::Map<const Points>(nodes.data(), 5, 3).topRows(3);
  const Points face = W * u;
  const Eigen::VectorXd direct = composed * q;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto at = 3 * static_cast<Eigen::Index>(k);
    EXPECT_LT((direct.segment<3>(at).transpose() - face.row(rows[k])).norm(), 1e-14);
  }
}

TEST(SurfaceMap, EnclosedVerticesGoAlongWithTheNearest) {
  IntermediateMesh region = testing::whole_region(testing::flat_disk(100, 36, 2));
  Points face(101, 3);
  face.topRows(100) = region.mesh.vertices;
  face.row(100) = region.mesh.vertices.row(44) + Eigen::RowVector3d(0.1, 0, -1);
  region.enclosed = {100};
  const SurfaceMap W = index_map(region, face);
  // A motion of all is a motion of the enclosed vertex too; one of its neighbour moves it most.
  const Eigen::RowVector3d shift(1, 2, 3);
  const Points moved = W * Points(shift.replicate(100, 1));
  EXPECT_LT((moved.row(100) - shift).norm(), 1e-12);
  Eigen::VectorXd::Index heaviest = 0;
  Eigen::VectorXd(W.row(100).transpose()).maxCoeff(&heaviest);
  EXPECT_EQ(heaviest, 44);
}

TEST(SurfaceMap, OfAWholeFaceIsTheIdentity) {
  const IntermediateMesh region = testing::whole_region(testing::flat_disk(100, 36, 2));
  const SurfaceMap W = index_map(region, region.mesh.vertices);
  const Points u = Points::Random(100, 3);
  EXPECT_EQ(Points(W * u), u);
}

}  // namespace
}  // namespace gnathion
