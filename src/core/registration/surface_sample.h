#pragma once

#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// Points of a surface, evenly spread, in no order, with the way it faces.
struct SurfaceSample {
  Points points;            ///< n×3
  Points normals;           ///< n×3, length 1, outward
  std::vector<int> vertex;  ///< n, of the surface
  double area = 0;          ///< of the surface that each point stands for
  double spacing = 0;       ///< between neighbours, about

  Eigen::Index size() const { return points.rows(); }
};

/// Which vertices are no spikes: a spike stands off from the median of its neighbours more than
/// twice as far as these do. Vertices of no triangle are spikes too.
std::vector<bool> without_spikes(const TriangleMesh& mesh);

/// A surface cleaned of spikes, ready to be sampled at any spacing.
class SampledSurface {
 public:
  /// use: flags of the vertices to take points from; empty: all. Indices must be in range and
  /// coordinates finite. Any unit.
  SampledSurface(const TriangleMesh& mesh, const std::vector<bool>& use = {});

  /// One vertex for each cell of side `spacing`, the same ones each time. Normals are means over
  /// the vertices within `smoothing`: noise of a dense scan turns those of single triangles about.
  SurfaceSample sample(double spacing, double smoothing) const;

  /// As the spacing makes them, but no more than `most`: the spacing grows until they fit.
  SurfaceSample sample_of(Eigen::Index most, double smoothing) const;

  /// Of the parts without spikes.
  double area() const { return area_; }

 private:
  std::vector<int> thinned(double spacing) const;

  Points points_;  ///< without spikes
  Points normals_;
  std::vector<int> vertex_;  ///< of the mesh
  std::vector<int> usable_;  ///< rows of points_, shuffled
  double area_ = 0;
};

}  // namespace gnathion
