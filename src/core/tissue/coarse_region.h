#pragma once

#include "geometry/surface_distance.h"
#include "tissue/intermediate_mesh.h"
#include "tissue/surface_map.h"

namespace gnathion {

/// A region for meshing, coarser than the face, and the way back to the face.
struct CoarseRegion {
  /// mm, LPS, on the region's surface. When it was remeshed its vertices are no vertices of the
  /// face and face_vertex is empty; `enclosed` still counts the face's vertices.
  IntermediateMesh region;
  SurfaceMap surface_map;  ///< |face| × |region.mesh.vertices|
  /// Of the dense region's vertices from the coarse surface, mm.
  DistanceStatistics distance;
};

/// Remeshes a region of a dense photograph to triangles with edges of about `edge_mm` (edge
/// collapse, then isotropic remeshing, vertices put back on the dense surface). The rim keeps its
/// shape: the coarse rim's vertices lie on it, and it leaves it by about a tenth of an edge at
/// most, but where it zigzags within half an edge. Held and free parts of the rim stay so. A region
/// whose edges are not shorter than three quarters of that is left as it is, with index_map.
/// `face`: rest positions of the whole face, n×3.
/// Throws Error(anatomy): an edge length that is no positive number, or at which less than twenty
/// triangles would be left; a region that touches itself in a vertex.
CoarseRegion coarse_region(const IntermediateMesh& dense, const Points& face, double edge_mm);

}  // namespace gnathion
