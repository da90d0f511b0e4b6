#pragma once

#include "support/held_patch.h"

namespace gnathion::testing {

/// Tissue 5 mm thick below a patch, its rim fixed, over two bones side by side (x below and above
/// the middle): inner points within 7 mm of the middle are attached to them, those within 14 mm
/// slide on them along directions that no axis has.
inline HeldPatch sliding_patch(const TriangleMesh& mesh = hard_patch(1, 0)) {
  HeldPatch patch = held_patch(mesh, 14);
  const Points& x = patch.tissue.mesh.vertices;
  const Eigen::RowVector3d middle = x.topRows(patch.tissue.surface_count).colwise().mean();
  for (int v = 0; v < patch.tissue.surface_count; ++v) {
    const int inner = patch.tissue.inner(v);
    if (patch.supports[inner] != Support::attached) continue;
    const int body = x(v, 0) < middle[0] ? 0 : 1;
    const Eigen::Vector3d outward = (x.row(v) - x.row(inner)).transpose().normalized();
    patch.supports[inner] = (x.row(v) - middle).head<2>().norm() < 7
                                ? Support(Support::attached, body)
                                : Support::slides(outward, body);
  }
  return patch;
}

}  // namespace gnathion::testing
