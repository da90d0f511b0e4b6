#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh_types.h"

namespace gnathion {

/// A border of the surface: a hole, or the scan's outer rim.
struct BorderLoop {
  std::vector<int> vertices;  ///< in order, the surface to the left seen from outside
  double length = 0;          ///< in the scan's unit
};

/// A piece of the surface that hangs together through its vertices.
struct Island {
  std::vector<int> triangles;
  double size = 0;  ///< diagonal of its box, in the scan's unit
};

/// What is wrong with a scan, each with its places. Nothing here is repaired; a face scan may well
/// be used with most of it. Rows are those of the surface that was looked at.
struct ScanProblems {
  std::vector<int> duplicate_vertices;                 ///< lie exactly where an earlier one does
  std::vector<int> unreferenced_vertices;              ///< in no triangle, and no duplicates
  std::vector<std::array<int, 2>> non_manifold_edges;  ///< with more than two triangles
  std::vector<int> non_manifold_vertices;              ///< where pieces touch in a point only
  std::vector<std::array<int, 2>> inconsistent_edges;  ///< both triangles run the same way
  std::vector<int> flipped_triangles;     ///< against most of their piece, or a piece inside out
  std::vector<int> degenerate_triangles;  ///< without area
  std::vector<BorderLoop> borders;        ///< the longest first
  std::vector<Island> islands;            ///< the largest first; one is no problem
  std::vector<std::array<int, 2>> crossing_triangles;  ///< that run through each other
};

/// Looks at a surface: finite coordinates, indices in range, any unit. Throws Error(cancelled).
ScanProblems scan_problems(const TriangleMesh& surface, Progress& progress);

/// The borders, the longest first. Where faces run against each other at a border, a loop may end
/// without having come round.
std::vector<BorderLoop> border_loops(const TriangleMesh& surface);

/// The pieces that hang together through vertices, the largest first.
std::vector<Island> islands_of(const TriangleMesh& surface);

/// Pairs of triangles that run through each other, in exact arithmetic on the coordinates, each
/// pair once, ascending. Neighbours count where they cross or fold onto each other; triangles
/// without area do not. Throws Error(cancelled).
std::vector<std::array<int, 2>> crossing_triangles(const TriangleMesh& surface, Progress& progress);

/// Flags of the triangles that must be turned so that neighbours agree in each piece (connected
/// through edges with two triangles) and the piece faces outward: that its signed volume seen from
/// its centre is positive. A piece too flat to tell keeps what most of its area has.
std::vector<bool> flipped_triangles(const TriangleMesh& surface);

/// Whether the triangle has no area: narrower than 1e-10 of its longest side.
bool is_degenerate(const TriangleMesh& surface, Eigen::Index triangle);

/// A sentence for each kind of problem, with its count; the first says what is there. `unit` is
/// that of lengths: "mm".
std::vector<std::string> in_words(const ScanProblems& problems, const TriangleMesh& surface,
                                  const std::string& unit);

}  // namespace gnathion
