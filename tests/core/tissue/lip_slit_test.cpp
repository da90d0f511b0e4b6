#include "tissue/lip_slit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "base/error.h"
#include "fem/static_solver.h"
#include "geometry/tet_quality.h"
#include "support/expect_error.h"
#include "support/face_patch.h"
#include "tissue/coarse_region.h"
#include "tissue/inner_surface.h"
#include "tissue/st_generator.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
using test::expect_error;
using testing::whole_region;
using Line = std::vector<Vector3d>;

/// A flat patch of 53 × 53 mm, edges 2.2 mm, up is +y, outward +z.
IntermediateMesh flat_region() {
  return whole_region(testing::flat_disk(625, 96, 2.2));
}

Vector3d middle_of(const TriangleMesh& mesh) {
  return (mesh.vertices.colwise().minCoeff() + mesh.vertices.colwise().maxCoeff()) / 2;
}

/// 30 mm long, curved as a mouth is, along +x through the patch's middle.
Line mouth_line(const TriangleMesh& mesh) {
  Line line;
  for (int k = -5; k <= 5; ++k) {
    line.emplace_back(middle_of(mesh) + Vector3d(3 * k, 0.06 * k * k - 0.7, 0));
  }
  return line;
}

LipSlit slit_of(const IntermediateMesh& region, const Line& line) {
  TriangleMesh face = region.mesh;
  return slit_along(region, index_map(region, face.vertices), lip_path(region, line));
}

SoftTissueMesh tissue_below(const LipSlit& slit, double depth) {
  const Points directions = parted_directions(slit.vertices, offset_directions(slit.region, depth));
  return st_generator(slit.region, directions,
                      Eigen::VectorXd::Constant(slit.region.mesh.vertices.rows(), depth));
}

void expect_rows_of_one(const SurfaceMap& W) {
  for (int row = 0; row < W.rows(); ++row) {
    double sum = 0;
    int count = 0;
    for (SurfaceMap::InnerIterator weight(W, row); weight; ++weight, ++count) {
      EXPECT_GE(weight.value(), 0);
      sum += weight.value();
    }
    if (count > 0) {
      EXPECT_NEAR(sum, 1, 1e-12) << "face vertex " << row;
    }
  }
}

TEST(LipSlit, OpensTheRegionAlongTheLineAndLeavesItsEndsJoined) {
  const IntermediateMesh region = flat_region();
  const Line line = mouth_line(region.mesh);
  const std::vector<int> path = lip_path(region, line);
  const LipSlit slit = slit_of(region, line);
  const auto doubled = static_cast<Eigen::Index>(slit.vertices.size());
  ASSERT_EQ(doubled + 2, static_cast<Eigen::Index>(path.size()));
  EXPECT_GT(doubled, 8);
  const TriangleMesh& mesh = slit.region.mesh;
  EXPECT_EQ(mesh.vertices.rows(), region.mesh.vertices.rows() + doubled);
  EXPECT_EQ(mesh.triangles.rows(), region.mesh.triangles.rows());
  EXPECT_NEAR(surface_area(mesh), surface_area(region.mesh), 1e-9);
  // A disk has the Euler number 1, one with a hole 0; edges_of throws unless it is a manifold.
  const auto edges = edges_of(mesh);
  EXPECT_EQ(mesh.vertices.rows() - static_cast<Eigen::Index>(edges.size()) + mesh.triangles.rows(),
            0);
  for (const int piece : triangle_components(mesh)) EXPECT_EQ(piece, 0);
  for (const SlitVertex& v : slit.vertices) {
    EXPECT_TRUE(slit.region.rim[v.left] && slit.region.rim[v.right]);
    EXPECT_FALSE(slit.region.held[v.left] || slit.region.held[v.right]);
    EXPECT_EQ(slit.region.face_vertex[v.left], slit.region.face_vertex[v.right]);
    EXPECT_GT(v.leftward[1], 0.7);  // the line runs along +x and is seen from +z
  }
  EXPECT_TRUE(slit.region.rim[path.front()] && slit.region.rim[path.back()]);
}

TEST(LipSlit, EachSideHasItsOwnTriangles) {
  const IntermediateMesh region = flat_region();
  const Line line = mouth_line(region.mesh);
  const LipSlit slit = slit_of(region, line);
  const TriangleMesh& mesh = slit.region.mesh;
  for (const SlitVertex& v : slit.vertices) {
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
      const auto f = mesh.triangles.row(t);
      const Vector3d centre =
          (mesh.vertices.row(f[0]) + mesh.vertices.row(f[1]) + mesh.vertices.row(f[2])) / 3;
      const Vector3d x = mesh.vertices.row(v.left);
      if ((f.array() == v.left).any()) {
        EXPECT_GT((centre - x).dot(v.leftward), -0.6);
      }
      if ((f.array() == v.right).any()) {
        EXPECT_LT((centre - x).dot(v.leftward), 0.6);
      }
      EXPECT_FALSE((f.array() == v.left).any() && (f.array() == v.right).any());
    }
  }
}

TEST(LipSlit, ADoubledFaceVertexTakesTheMeanOfItsSides) {
  const IntermediateMesh region = flat_region();
  const LipSlit slit = slit_of(region, mouth_line(region.mesh));
  expect_rows_of_one(slit.surface_map);
  for (const SlitVertex& v : slit.vertices) {
    const int row = slit.region.face_vertex[v.left];
    EXPECT_EQ(slit.surface_map.coeff(row, v.left), 0.5);
    EXPECT_EQ(slit.surface_map.coeff(row, v.right), 0.5);
  }
  EXPECT_EQ(slit.surface_map.nonZeros(),
            region.mesh.vertices.rows() + static_cast<Eigen::Index>(slit.vertices.size()));
}

/// A dense patch, remeshed to 3 mm and slit along the mouth's line.
struct DenseMouth {
  TriangleMesh face = testing::flat_disk(10000, 396, 0.6);
  Line line = mouth_line(face);
  LipSlit slit;
  IntermediateMesh before, drawn;
  std::vector<int> path;

  DenseMouth() {
    testing::raise(face, [](double x, double y) { return -(x * x + y * y) / 150; });
    for (Vector3d& p : line) {
      const Vector3d off = p - middle_of(face);
      p[2] = -off.head<2>().squaredNorm() / 150;
    }
    const IntermediateMesh dense = whole_region(face);
    before = coarse_region(dense, face.vertices, 3).region;
    path = lip_path(before, line);
    drawn = drawn_to_line(before, BspTree(dense.mesh), path, line);
    slit = slit_along(drawn, barycentric_map(dense, drawn, face.vertices), path);
  }
  double height(double x) const {  // of the line above the middle, mm
    const double k = (x - middle_of(face)[0]) / 3;
    return middle_of(face)[1] + 0.06 * k * k - 0.7;
  }
};

TEST(LipSlit, ARemeshIsDrawnToTheLineAndNoTriangleTurnsOver) {
  const DenseMouth mouth;
  double before = 0;
  for (const int v : mouth.path) {
    const Eigen::RowVector3d x = mouth.drawn.mesh.vertices.row(v);
    EXPECT_NEAR(x[1], mouth.height(x[0]), 0.4) << "at x = " << x[0];
    const Eigen::RowVector3d old = mouth.before.mesh.vertices.row(v);
    before = std::max(before, std::abs(old[1] - mouth.height(old[0])));
  }
  EXPECT_GT(before, 0.8);  // there was something to draw
  EXPECT_GT(triangle_normals(mouth.drawn.mesh).col(2).minCoeff(), 0.7);
}

TEST(LipSlit, FaceVerticesFollowTheSideTheyLieOn) {
  const DenseMouth mouth;
  expect_rows_of_one(mouth.slit.surface_map);
  // Displace the right, lower copies only: nothing above the line may follow.
  Eigen::VectorXd lower = Eigen::VectorXd::Zero(mouth.slit.region.mesh.vertices.rows());
  for (const SlitVertex& v : mouth.slit.vertices) lower[v.right] = 1;
  const Eigen::VectorXd follows = mouth.slit.surface_map * lower;
  int below = 0;
  for (Eigen::Index v = 0; v < follows.size(); ++v) {
    const double above = mouth.face.vertices(v, 1) - mouth.height(mouth.face.vertices(v, 0));
    if (above > 0.45) {
      EXPECT_EQ(follows[v], 0) << "face vertex " << v;
    }
    below += follows[v] > 0.8;
  }
  EXPECT_GT(below, 20);
}

TEST(LipSlit, TissueIsSoundOnFlatAndCurvedPatches) {
  const LipSlit flat = slit_of(flat_region(), mouth_line(flat_region().mesh));
  const LipSlit round = DenseMouth().slit;
  for (const LipSlit* slit : {&flat, &round}) {
    for (const double depth : {3.0, 8.0}) {
      const SoftTissueMesh tissue = tissue_below(*slit, depth);
      EXPECT_EQ(tet_quality(tissue.mesh).inverted, 0);
      EXPECT_TRUE(inner_surface_crossings(slit->region, inner_surface(slit->region, tissue), tissue)
                      .none());
      EXPECT_GT(tissue.depth.mean(), 0.85 * depth);
    }
  }
}

/// Patch tissue of which the inner nodes below the line are driven, those above it free.
struct Driven {
  SoftTissueMesh tissue;
  Points displacements;
};

Driven driven_lower_half(const IntermediateMesh& region, const std::vector<SlitVertex>& slit) {
  Driven driven;
  driven.tissue = st_generator(region, parted_directions(slit, offset_directions(region, 5)),
                               Eigen::VectorXd::Constant(region.mesh.vertices.rows(), 5));
  const Points& x = driven.tissue.mesh.vertices;
  const Vector3d middle = middle_of(region.mesh);
  Supports supports(static_cast<std::size_t>(x.rows()), Support::free);
  Points prescribed = Points::Zero(x.rows(), 3);
  for (int v = 0; v < driven.tissue.surface_count; ++v) {
    const int inner = driven.tissue.inner(v);
    const Vector3d off = Vector3d(x.row(v)) - middle;
    if (region.held[v]) {
      supports[v] = supports[inner] = Support::fixed;
    } else if (off[1] < -4 && std::abs(off[0]) < 14) {
      supports[inner] = Support::attached;
      prescribed(inner, 2) = 1;
    }
  }
  Progress progress;
  const StaticSolver solver(driven.tissue.mesh, {}, supports, progress);
  driven.displacements = solver.solve(prescribed, Points::Zero(x.rows(), 3)).displacements;
  return driven;
}

TEST(LipSlit, TheLowerLipNoLongerTakesTheUpperOneWithIt) {
  const IntermediateMesh region = flat_region();
  const LipSlit slit = slit_of(region, mouth_line(region.mesh));
  const Points joined = driven_lower_half(region, {}).displacements;
  const Points parted = driven_lower_half(slit.region, slit.vertices).displacements;
  double upper = 0, lower = 0, together = 0;
  const auto count = static_cast<double>(slit.vertices.size());
  for (const SlitVertex& v : slit.vertices) {
    upper += parted(v.left, 2) / count;
    lower += parted(v.right, 2) / count;
    together += joined(v.left, 2) / count;
  }
  EXPECT_GT(together, 0.3);
  EXPECT_LT(upper, 0.5 * together);
  EXPECT_GT(lower, together);
  EXPECT_LT(upper, 0.4 * lower);
}

TEST(LipSlit, WhatMovesTheWholeTissueRigidlyMovesBothSidesAlike) {
  const IntermediateMesh region = flat_region();
  const LipSlit slit = slit_of(region, mouth_line(region.mesh));
  const SoftTissueMesh tissue = tissue_below(slit, 5);
  const Points& x = tissue.mesh.vertices;
  const Vector3d turn(0.02, -0.03, 0.01), shift(1, 2, -3);
  Points rigid(x.rows(), 3);
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    rigid.row(i) = (turn.cross(Vector3d(x.row(i))) + shift).transpose();
  }
  Supports supports(static_cast<std::size_t>(x.rows()), Support::free);
  for (int v = 0; v < tissue.surface_count; ++v) {
    if (region.rim.size() > static_cast<std::size_t>(v) && region.held[v]) {
      supports[v] = supports[tissue.inner(v)] = Support::attached;
    }
  }
  Progress progress;
  const StaticSolver solver(tissue.mesh, {}, supports, progress);
  const Points u = solver.solve(rigid, Points::Zero(x.rows(), 3)).displacements;
  EXPECT_LT((u - rigid).cwiseAbs().maxCoeff(), 1e-9);
  const Points face = slit.surface_map * u.topRows(tissue.surface_count);
  EXPECT_LT((face - rigid.topRows(face.rows())).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(LipSlit, LinesThatCannotBeCutAreRefusedByName) {
  const IntermediateMesh region = flat_region();
  const Vector3d m = middle_of(region.mesh);
  const auto path = [&](const Line& line) { return [&region, line] { lip_path(region, line); }; };
  const auto refuses = [&](const std::string& why, const Line& line) {
    expect_error(ErrorKind::anatomy, {"region.lip_line", why}, path(line));
  };
  refuses("fewer than two points", {m});
  refuses("leaves the region",
          {m, m + Vector3d(0, 0, 8), m + Vector3d(10, 0, 8), m + Vector3d(10, 0, 0)});
  refuses("ends at the region's rim", {m, m + Vector3d(26.5, 0, 0)});
  refuses("too short", {m, m + Vector3d(3, 0, 0)});
  // A mouth that is open already: a hole in the region that the line would have to cross.
  std::vector<int> around;
  for (int v = 0; v < region.mesh.vertices.rows(); ++v) {
    const Vector3d off = Vector3d(region.mesh.vertices.row(v)) - m;
    if (std::abs(off[0]) > 3 || std::abs(off[1]) > 12) around.push_back(v);
  }
  const IntermediateMesh holed = region_of_vertices(region.mesh, around);
  expect_error(ErrorKind::anatomy, {"region.lip_line", "leaves the region"}, [&] {
    lip_path(holed, {m - Vector3d(15, 0, 0), m + Vector3d(15, 0, 0)});
  });
}

TEST(LipSlit, DirectionsThatWouldCrossAreTurnedApart) {
  const IntermediateMesh region = flat_region();
  const LipSlit slit = slit_of(region, mouth_line(region.mesh));
  Points crossing = offset_directions(slit.region, 5);
  for (const SlitVertex& v : slit.vertices) {
    crossing.row(v.left) = (Vector3d(0, 0, -1) - 0.5 * v.leftward).normalized();
  }
  const Points parted = parted_directions(slit.vertices, crossing);
  for (const SlitVertex& v : slit.vertices) {
    EXPECT_GT(parted.row(v.left).dot(v.leftward), 0.04);
    EXPECT_LT(parted.row(v.right).dot(v.leftward), -0.04);
    EXPECT_NEAR(parted.row(v.left).norm(), 1, 1e-12);
  }
}

}  // namespace
}  // namespace gnathion
