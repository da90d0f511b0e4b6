#pragma once

#include <vector>

#include "projection/skin_painting.h"

namespace gnathion {

/// What one photograph shows of the skin, vertex by vertex.
struct PhotoView {
  std::vector<double> weight;  ///< n, how squarely it is seen, 0..1; 0: not at all
  Points broad;             ///< n×3, sRGB 0..1, evened out over some 5 mm; where weight is above 0
                            ///< or a neighbour's is
  double mm_per_pixel = 0;  ///< of the photograph on the skin it sees, median
};

/// neighbours: of the skin's vertices. Throws Error(input) naming a photograph that sees nothing.
PhotoView view_of(const PlacedPhoto& photo, const SkinSight& skin,
                  const std::vector<std::vector<int>>& neighbours, Progress& progress);

/// mm along the surface's edges from each vertex to the nearest flagged one (Dijkstra), up to
/// `reach`; beyond, `reach`.
std::vector<double> edge_distances(const Points& vertices,
                                   const std::vector<std::vector<int>>& neighbours,
                                   const std::vector<bool>& from, double reach);

/// A rise from 0 at `from` to 1 at `to` without corners.
double smooth_step(double from, double to, double x);

}  // namespace gnathion
