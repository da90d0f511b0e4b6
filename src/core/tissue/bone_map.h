#pragma once

#include <span>
#include <vector>

#include "fem/supports.h"
#include "geometry/bsp_tree.h"
#include "tissue/intermediate_mesh.h"

namespace gnathion {

/// One ray of the bone map: from a vertex of the bone along its normal to the intermediate mesh.
struct BoneLink {
  int segment = 0;  ///< which of the moving bones
  int bone_vertex = -1;
  int triangle = -1;  ///< of the intermediate mesh
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();
  double distance = 0;  ///< mm
};

/// The bone map (paper, 4.2.2): the ray from each bone vertex along its outward normal meets the
/// intermediate mesh; hits farther than `threshold` mm are dropped, and so are those that reach the
/// skin from outside. Only bone that can see the region is asked: vertices within the region's box
/// grown by the threshold, whose ray does not meet the bone itself before the skin.
/// `bone_tree`: of `bone`; `skin_tree`: of `region.mesh`; `segment`: the number that the links
/// bear. Links are in order of bone_vertex.
std::vector<BoneLink> bone_map(const TriangleMesh& bone, const BspTree& bone_tree,
                               const IntermediateMesh& region, const BspTree& skin_tree,
                               double threshold, int segment = 0);

/// Instead of a bone's number: no bone lies under a vertex of the region.
inline constexpr int kNoBone = -2;

/// What lies below each vertex of the region, within the threshold.
struct BoneBelow {
  std::vector<int> bone;  ///< M: the number of a moving segment, Support::kUnmoved, or kNoBone
  Eigen::VectorXd depth;  ///< M, mm: to the bone, or the default where there is none
};

struct BoneBelowOptions {
  double threshold = 20;     ///< mm: bone farther away is not below
  double default_depth = 8;  ///< mm, where there is no bone
  double least_depth = 1;    ///< mm: thinner tissue is not modelled; such bone does not hold it
};

/// Casts a ray from each vertex of the region along `directions` (M×3, unit, into the tissue) to
/// the moving segments and to the rest of the skull; the nearest one counts. Vertices that a bone
/// link of a segment meets, but whose own ray misses all bone, take the mean length of their links.
/// Depths between are interpolated over the surface towards the default.
BoneBelow bone_below(const IntermediateMesh& region, const Points& directions,
                     std::span<const BspTree> segments, const BspTree& skull,
                     const std::vector<BoneLink>& links, const BoneBelowOptions& options);

}  // namespace gnathion
