#include "tissue/bone_map.h"

#include <algorithm>
#include <cmath>

namespace gnathion {
namespace {

/// Depths of vertices with no bone below: a mean of the neighbours', drawn a little to the default,
/// so that the tissue does not end in a step where the bone does.
void spread_depths(const std::vector<std::vector<int>>& neighbours, double default_depth,
                   BoneBelow& below) {
  constexpr int kRounds = 60;
  constexpr double kDraw = 0.03;
  for (int round = 0; round < kRounds; ++round) {
    for (Eigen::Index v = 0; v < below.depth.size(); ++v) {
      if (below.bone[v] != Underlying::none || neighbours[v].empty()) continue;
      double mean = 0;
      for (const int w : neighbours[v]) mean += below.depth[w];
      mean /= static_cast<double>(neighbours[v].size());
      below.depth[v] = (1 - kDraw) * mean + kDraw * default_depth;
    }
  }
}

}  // namespace

std::vector<BoneLink> bone_map(const TriangleMesh& bone, const BspTree& bone_tree,
                               const IntermediateMesh& region, const BspTree& skin_tree,
                               double threshold) {
  const Points normals = vertex_normals(bone);
  const Points skin_normals = triangle_normals(region.mesh);
  Eigen::AlignedBox3d box(region.mesh.vertices.colwise().minCoeff().transpose(),
                          region.mesh.vertices.colwise().maxCoeff().transpose());
  box.min().array() -= threshold;
  box.max().array() += threshold;
  constexpr double kOffBone = 0.05;  // mm: a ray must not meet the triangles it starts from
  std::vector<BoneLink> links;
  for (int v = 0; v < bone.vertices.rows(); ++v) {
    const Eigen::Vector3d origin = bone.vertices.row(v);
    const Eigen::Vector3d direction = normals.row(v);
    if (!box.contains(origin) || direction.isZero()) continue;
    const auto hit = skin_tree.first_hit(origin, direction, threshold);
    if (!hit || skin_normals.row(hit->triangle).dot(direction) <= 0) continue;
    if (bone_tree.first_hit(origin + kOffBone * direction, direction, hit->distance)) continue;
    links.push_back({v, hit->triangle, hit->barycentric, hit->distance});
  }
  return links;
}

BoneBelow bone_below(const IntermediateMesh& region, const Points& directions,
                     const BspTree& segment, const BspTree& skull,
                     const std::vector<BoneLink>& links, const BoneBelowOptions& options) {
  const Eigen::Index M = region.mesh.vertices.rows();
  BoneBelow below;
  below.bone.assign(static_cast<std::size_t>(M), Underlying::none);
  below.depth = Eigen::VectorXd::Constant(M, options.default_depth);

  Eigen::VectorXd link_length = Eigen::VectorXd::Zero(M), link_count = Eigen::VectorXd::Zero(M);
  for (const BoneLink& link : links) {
    for (const int v : region.mesh.triangles.row(link.triangle)) {
      link_length[v] += link.distance;
      ++link_count[v];
    }
  }
  for (Eigen::Index v = 0; v < M; ++v) {
    const Eigen::Vector3d origin = region.mesh.vertices.row(v);
    const Eigen::Vector3d direction = directions.row(v);
    const auto on_segment = segment.first_hit(origin, direction, options.threshold);
    const double reach = on_segment ? on_segment->distance : options.threshold;
    const auto on_skull = skull.first_hit(origin, direction, reach);
    if (on_skull) {
      below.bone[v] = Underlying::skull;
      below.depth[v] = on_skull->distance;
    } else if (on_segment) {
      below.bone[v] = Underlying::segment;
      below.depth[v] = on_segment->distance;
    } else if (link_count[v] > 0) {
      below.bone[v] = Underlying::segment;
      below.depth[v] = link_length[v] / link_count[v];
    }
    if (below.depth[v] < options.least_depth) {
      below.bone[v] = Underlying::none;
      below.depth[v] = options.least_depth;
    }
  }
  spread_depths(vertex_neighbours(region.mesh), options.default_depth, below);
  return below;
}

}  // namespace gnathion
