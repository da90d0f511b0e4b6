#pragma once

#include <array>
#include <string>
#include <vector>

#include "tissue/hidden.h"
#include "tissue/region_brush.h"

namespace gnathion {

/// A part of a face as it is painted: n flags, one a vertex of the face. Its triangles are those
/// with all three vertices in it (region_of_vertices() in tissue/intermediate_mesh.h). The
/// functions below take `brush`, the face made ready, and a selection of as many flags.
using Selection = std::vector<bool>;

/// Indices beyond the face are left out.
Selection selection_of(const std::vector<int>& vertices, Eigen::Index face_vertices);
/// Ascending.
std::vector<int> vertices_of(const Selection& selection);

/// What is drawn of a selection, and its size.
struct RegionOutline {
  Triangles triangles;                  ///< m×3, vertices of the face
  std::vector<std::array<int, 2>> rim;  ///< edges with a triangle on one side only
  double area_mm2 = 0;
};
RegionOutline outline_of(const SurfaceBrush& brush, const Selection& selection);

/// With the skin up to `mm` farther out along the surface, to half an edge of the face.
Selection grown(const SurfaceBrush& brush, const Selection& selection, double mm);
/// Without the skin up to `mm` from its rim, to half an edge. Where the face itself ends nothing is
/// taken away.
Selection shrunk(const SurfaceBrush& brush, const Selection& selection, double mm);
/// The rim moved by its curvature, so that bays and spikes narrower than about `mm` go: the flags
/// are diffused over a width of `mm` and cut at one half (Merriman, Bence and Osher 1992).
Selection smoothed(const SurfaceBrush& brush, const Selection& selection, double mm);

/// The piece with the largest area.
Selection largest_piece(const SurfaceBrush& brush, const Selection& selection);
/// Holes of less than `mm2` of visible skin filled; pockets such as a nostril stay holes.
Selection filled(const SurfaceBrush& brush, const PocketSearch& pockets, const Selection& selection,
                 double mm2);
/// Without vertices that have no triangle, and without those in which the rim touches itself,
/// which no mesh of the tissue below could have.
Selection without_pinches(const SurfaceBrush& brush, const Selection& selection);

/// Why a selection cannot be the region of a model.
struct RegionFault {
  enum class Kind {
    empty,           ///< it has no triangle
    pieces,          ///< it is in several: vertices of all but the largest
    no_rim,          ///< it is a whole closed surface: all vertices
    touches_itself,  ///< its rim does, in these vertices
  };
  Kind kind;
  int count = 0;              ///< pieces: how many; touches_itself: in how many vertices
  std::vector<int> vertices;  ///< of the face, ascending
};
/// None: it is one connected piece with a rim.
std::vector<RegionFault> region_faults(const SurfaceBrush& brush, const Selection& selection);

}  // namespace gnathion
