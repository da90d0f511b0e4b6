#include "tissue/unfold.h"

#include <algorithm>

namespace gnathion {
namespace {

/// Least cosine that a vertex normal may have with the normals of its triangles.
constexpr double kLeastCosine = 0.3;
/// Least cosine between the normals of neighbouring triangles: a right angle.
constexpr double kSharpestFold = 0;
constexpr int kRoundsPerRing = 20;

/// The vertices of folds.
std::vector<bool> folded_vertices(const TriangleMesh& mesh, const std::vector<Edge>& edges) {
  const Points normals = vertex_normals(mesh);
  const Points faces = triangle_normals(mesh);
  std::vector<bool> folded(static_cast<std::size_t>(mesh.vertices.rows()), false);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (const int v : mesh.triangles.row(f)) {
      if (normals.row(v).dot(faces.row(f)) < kLeastCosine) folded[v] = true;
    }
  }
  for (const Edge& edge : edges) {
    if (edge.right == -1) continue;
    if (faces.row(edge.left).dot(faces.row(edge.right)) >= kSharpestFold) continue;
    folded[edge.a] = folded[edge.b] = true;
  }
  return folded;
}

}  // namespace

Unfolding unfold(const IntermediateMesh& region, int rounds) {
  Unfolding result{region, 0, 0};
  Points& x = result.region.mesh.vertices;
  const auto neighbours = vertex_neighbours(region.mesh);
  for (int round = 0; round < rounds; ++round) {
    std::vector<bool> folded = folded_vertices(result.region.mesh, region.edges);
    if (std::find(folded.begin(), folded.end(), true) == folded.end()) break;
    // Between fixed neighbours a folded triangle can stay folded: a fold that lasts takes in more.
    for (int ring = 0; ring <= round / kRoundsPerRing; ++ring) folded = widened(folded, neighbours);
    const Points before = x;
    for (std::size_t v = 0; v < folded.size(); ++v) {
      if (!folded[v] || region.held[v]) continue;
      Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
      for (const int w : neighbours[v]) middle += before.row(w);
      middle /= static_cast<double>(neighbours[v].size());
      const auto row = static_cast<Eigen::Index>(v);
      x.row(row) = (before.row(row) + middle) / 2;
    }
  }
  const Eigen::VectorXd moves = (x - region.mesh.vertices).rowwise().norm();
  result.moved_count = static_cast<int>((moves.array() > 0).count());
  result.largest_move = moves.size() > 0 ? moves.maxCoeff() : 0;
  return result;
}

}  // namespace gnathion
