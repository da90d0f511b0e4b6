#include "tissue/bone_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
      if (below.bone[v] != kNoBone || neighbours[v].empty()) continue;
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
                               double threshold, int segment) {
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
    links.push_back({segment, v, hit->triangle, hit->barycentric, hit->distance});
  }
  return links;
}

namespace {

/// The nearest bone along a ray within the threshold: its number and distance.
std::pair<int, double> first_bone(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                  std::span<const BspTree> segments, const BspTree& skull,
                                  double threshold) {
  std::pair<int, double> first{kNoBone, threshold};
  const auto try_bone = [&](const BspTree& tree, int number) {
    const auto hit = tree.first_hit(origin, direction, first.second);
    if (hit) first = {number, hit->distance};
  };
  for (std::size_t s = 0; s < segments.size(); ++s) try_bone(segments[s], static_cast<int>(s));
  try_bone(skull, Support::kUnmoved);
  return first;
}

}  // namespace

BoneBelow bone_below(const IntermediateMesh& region, const Points& directions,
                     std::span<const BspTree> segments, const BspTree& skull,
                     const std::vector<BoneLink>& links, const BoneBelowOptions& options) {
  const Eigen::Index M = region.mesh.vertices.rows();
  BoneBelow below;
  below.bone.assign(static_cast<std::size_t>(M), kNoBone);
  below.depth = Eigen::VectorXd::Constant(M, options.default_depth);

  Eigen::VectorXd link_length = Eigen::VectorXd::Zero(M), link_count = Eigen::VectorXd::Zero(M);
  std::vector<int> linked_to(static_cast<std::size_t>(M), kNoBone);
  for (const BoneLink& link : links) {
    for (const int v : region.mesh.triangles.row(link.triangle)) {
      link_length[v] += link.distance;
      ++link_count[v];
      linked_to[v] = link.segment;
    }
  }
  for (Eigen::Index v = 0; v < M; ++v) {
    const auto [bone, distance] = first_bone(region.mesh.vertices.row(v), directions.row(v),
                                             segments, skull, options.threshold);
    if (bone != kNoBone) {
      below.bone[v] = bone;
      below.depth[v] = distance;
    } else if (link_count[v] > 0) {
      below.bone[v] = linked_to[v];
      below.depth[v] = link_length[v] / link_count[v];
    }
    if (below.depth[v] < options.least_depth) {
      below.bone[v] = kNoBone;
      below.depth[v] = options.least_depth;
    }
  }
  spread_depths(vertex_neighbours(region.mesh), options.default_depth, below);
  return below;
}

}  // namespace gnathion
