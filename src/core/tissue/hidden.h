#pragma once

#include <vector>

#include "geometry/bsp_tree.h"
#include "geometry/mesh_types.h"

namespace gnathion {

/// Which vertices of a closed or open surface lie in a pocket: the inside of the mouth or of a
/// nostril, which scans of a whole head have. A vertex is hidden when at most one in ten of the
/// directions around its normal leads out, that is, meets no other part of the surface within
/// 60 mm. May be asked from several threads.
class PocketSearch {
 public:
  explicit PocketSearch(const TriangleMesh& surface);
  bool is_hidden(int vertex) const;

 private:
  BspTree tree_;
  Points places_;   ///< of the vertices
  Points normals_;  ///< of the vertices
  std::vector<Eigen::Vector3d> around_;
};

/// The same for the asked vertices of a surface: one flag a vertex; the others are not hidden.
std::vector<bool> hidden_vertices(const TriangleMesh& surface, const std::vector<bool>& asked);

}  // namespace gnathion
