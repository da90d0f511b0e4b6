#pragma once

#include <array>
#include <vector>

#include "geometry/mesh_types.h"
#include "geometry/surface_point.h"

namespace gnathion {

/// A vertex and how far it is along the surface, mm.
struct ReachedVertex {
  int vertex = -1;
  double distance = 0;
};

/// A point of an edge: (1 − share) a + share b.
struct EdgePoint {
  int a = -1, b = -1;
  double share = 0;
};

/// A face made ready for a round brush: distances are measured along the skin, so that a brush on
/// the upper lip does not reach the lower one through the air. They are computed by marching a
/// front over the triangles; a triangle's third vertex takes its distance from a source unfolded
/// into the triangle's plane (Novotni and Klein 2002), exact on flat skin where the front meets the
/// triangle through the known edge, and otherwise from the nearer of its edges. Only the window
/// that the brush reaches is visited. Keeps room to work in: one thread at a time.
class SurfaceBrush {
 public:
  /// Any triangles with indices in range and finite vertices; edges of more than two triangles
  /// count as a border.
  explicit SurfaceBrush(TriangleMesh face);

  const TriangleMesh& face() const { return face_; }
  /// mm², one a triangle.
  const std::vector<double>& areas() const { return areas_; }
  /// 3m: the triangle on the other side of triangle f's edge from corner k to the next one is
  /// across()[3f + k]; −1 at the border.
  const std::vector<int>& across() const { return across_; }
  /// Vertices that share an edge with `vertex`, ascending.
  struct Range {
    const int* first;
    const int* last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };
  Range neighbours(int vertex) const;

  /// A third of the area of the vertex's triangles, mm².
  double area_of(int vertex) const;

  /// The vertices at most `radius` mm from a point along the surface; at least the
  /// nearest corner of the point's triangle, so that the smallest brush paints something.
  std::vector<ReachedVertex> disc(const SurfacePoint& centre, double radius) const;

  /// The brush's edge: where the distance from the centre is `radius`, as segments across single
  /// triangles. None when the circle lies within one triangle.
  std::vector<std::array<EdgePoint, 2>> circle(const SurfacePoint& centre, double radius) const;

  /// The vertices within `reach` mm of a front that starts at all of `sources` (each at distance
  /// 0). `within`: n flags; the front runs
  /// over these vertices only. A triangle's third vertex continues a straight front (Kimmel and
  /// Sethian 1998).
  std::vector<ReachedVertex> front(const std::vector<int>& sources, double reach,
                                   const std::vector<bool>& within) const;

 private:
  struct Start {
    int vertex;
    double distance;
  };
  enum class Shape { point, line };
  std::vector<ReachedVertex> march(const std::vector<Start>& starts, double reach, Shape shape,
                                   const std::vector<bool>* within) const;
  std::vector<Start> starts_at(const SurfacePoint& centre) const;
  double through_triangle(int a, int b, int c, Shape shape) const;
  void forget() const;

  TriangleMesh face_;
  std::vector<double> areas_;
  std::vector<int> across_;
  std::vector<int> triangle_start_, triangle_of_;    ///< the triangles of each vertex
  std::vector<int> neighbour_start_, neighbour_of_;  ///< the neighbours of each vertex
  mutable std::vector<double> distance_;             ///< of the last march; infinite: not reached
  mutable std::vector<bool> settled_;
  mutable std::vector<int> touched_;  ///< whose distance_ is finite
};

}  // namespace gnathion
