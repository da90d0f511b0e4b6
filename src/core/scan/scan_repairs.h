#pragma once

#include <string>
#include <vector>

#include "io/obj_document.h"
#include "scan_stream/scan_stream.h"

namespace gnathion {

/// A scan after one repair.
struct RepairedScan {
  RawScan scan;
  /// For each vertex, its row in the scan before; vertices that stay keep their order. No repair
  /// here makes vertices.
  std::vector<int> vertex_of;
  std::size_t changed = 0;  ///< vertices or triangles removed, triangles turned or added
  std::string said;         ///< what was changed, a sentence for the user
};

// The scan must hold together (RawScan). Each repair is one decision of the user's; none runs by
// itself. Made one after the other, their maps are followed by composed().

/// All of a document for repairs: its vertices in order, its triangles (of an OBJ's polygons too),
/// its pictures. ObjDocument::of_scan() makes a document again. Throws Error(input) when a picture
/// has gone meanwhile.
RawScan raw_scan(const ObjDocument& document);

/// Vertices at exactly the same place become the first of them.
RepairedScan without_duplicate_vertices(const RawScan& scan);

/// Vertices that are in no triangle go.
RepairedScan without_unreferenced_vertices(const RawScan& scan);

/// Triangles without area go (is_degenerate()); their vertices stay.
RepairedScan without_degenerate_triangles(const RawScan& scan);

/// Pieces whose box's diagonal is smaller than `size` (in the scan's unit) go, with their vertices;
/// the largest piece stays whatever its size.
RepairedScan without_islands_below(const RawScan& scan, double size);

/// Triangles that face inward or against their neighbours are turned (flipped_triangles()).
RepairedScan oriented(const RawScan& scan);

/// Borders no longer than `length` (in the scan's unit) and of at most 300 vertices are closed by
/// the triangulation of least area (Barequet and Sharir 1995), in the material beside them and
/// without texture; the longest border of the scan stays, for it is its rim.
RepairedScan with_holes_filled(const RawScan& scan, double length);

/// The map of two repairs, the second made on what the first gave.
std::vector<int> composed(const std::vector<int>& first, const std::vector<int>& second);

}  // namespace gnathion
