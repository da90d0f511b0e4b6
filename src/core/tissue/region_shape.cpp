#include "tissue/region_shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

/// m flags: the triangles with all three vertices in the selection.
std::vector<bool> triangles_within(const SurfaceBrush& brush, const Selection& selection) {
  const Triangles& triangles = brush.face().triangles;
  std::vector<bool> within(static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    within[f] =
        selection[triangles(f, 0)] && selection[triangles(f, 1)] && selection[triangles(f, 2)];
  }
  return within;
}

bool is_rim(const SurfaceBrush& brush, const std::vector<bool>& within, std::size_t side) {
  const int other = brush.across()[side];
  return other == -1 || !within[other];
}

Selection inverse(const Selection& selection) {
  Selection others = selection;
  others.flip();
  return others;
}

/// The selected vertices that have a neighbour which is not.
std::vector<int> border_of(const SurfaceBrush& brush, const Selection& selection) {
  std::vector<int> border;
  for (std::size_t v = 0; v < selection.size(); ++v) {
    if (!selection[v]) continue;
    const auto around = brush.neighbours(static_cast<int>(v));
    if (std::any_of(around.begin(), around.end(), [&](int w) { return !selection[w]; })) {
      border.push_back(static_cast<int>(v));
    }
  }
  return border;
}

/// The vertices on both sides of the rim, at most `reach` mm from it.
std::vector<int> band_of(const SurfaceBrush& brush, const Selection& selection, double reach) {
  std::vector<int> band;
  const Selection everywhere(selection.size(), true);
  for (const ReachedVertex& near : brush.front(border_of(brush, selection), reach, everywhere)) {
    band.push_back(near.vertex);
  }
  return band;
}

double mean_edge(const SurfaceBrush& brush, const std::vector<int>& vertices) {
  double sum = 0;
  int count = 0;
  for (const int v : vertices) {
    for (const int w : brush.neighbours(v)) {
      sum += (brush.face().vertices.row(v) - brush.face().vertices.row(w)).norm();
      ++count;
    }
  }
  return count == 0 ? 1 : sum / count;
}

/// Connected pieces of the selected vertices, through edges.
std::vector<std::vector<int>> vertex_pieces(const SurfaceBrush& brush, const Selection& selection) {
  Selection waiting = selection;
  std::vector<std::vector<int>> pieces;
  for (std::size_t start = 0; start < waiting.size(); ++start) {
    if (!waiting[start]) continue;
    std::vector<int> piece{static_cast<int>(start)};
    waiting[start] = false;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      for (const int w : brush.neighbours(piece[k])) {
        if (!waiting[w]) continue;
        waiting[w] = false;
        piece.push_back(w);
      }
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// For each triangle of the selection its piece, connected through vertices; and each piece's area.
struct Pieces {
  SubMesh part;
  std::vector<int> of_triangle;
  std::vector<double> area;

  int largest() const {
    return static_cast<int>(std::max_element(area.begin(), area.end()) - area.begin());
  }
};

Pieces pieces_of(const SurfaceBrush& brush, const Selection& selection) {
  Pieces pieces{sub_mesh(brush.face(), triangles_within(brush, selection)), {}, {}};
  pieces.of_triangle = triangle_components(pieces.part.mesh);
  for (std::size_t i = 0; i < pieces.of_triangle.size(); ++i) {
    const auto piece = static_cast<std::size_t>(pieces.of_triangle[i]);
    if (pieces.area.size() <= piece) pieces.area.resize(piece + 1, 0.0);
    pieces.area[piece] += brush.areas()[pieces.part.parent_triangle[i]];
  }
  return pieces;
}

/// The number of rim edges at each vertex.
std::vector<int> rim_edges(const SurfaceBrush& brush, const std::vector<bool>& within) {
  const Triangles& triangles = brush.face().triangles;
  std::vector<int> count(static_cast<std::size_t>(brush.face().vertices.rows()), 0);
  for (std::size_t f = 0; f < within.size(); ++f) {
    for (std::size_t k = 0; within[f] && k < 3; ++k) {
      if (!is_rim(brush, within, 3 * f + k)) continue;
      ++count[triangles(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k))];
      ++count[triangles(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>((k + 1) % 3))];
    }
  }
  return count;
}

}  // namespace

Selection selection_of(const std::vector<int>& vertices, Eigen::Index face_vertices) {
  Selection selection(static_cast<std::size_t>(face_vertices), false);
  for (const int v : vertices) {
    if (v >= 0 && v < face_vertices) selection[v] = true;
  }
  return selection;
}

std::vector<int> vertices_of(const Selection& selection) {
  std::vector<int> vertices;
  for (std::size_t v = 0; v < selection.size(); ++v) {
    if (selection[v]) vertices.push_back(static_cast<int>(v));
  }
  return vertices;
}

RegionOutline outline_of(const SurfaceBrush& brush, const Selection& selection) {
  const std::vector<bool> within = triangles_within(brush, selection);
  const Triangles& all = brush.face().triangles;
  RegionOutline outline;
  outline.triangles.resize(std::count(within.begin(), within.end(), true), 3);
  Eigen::Index next = 0;
  for (std::size_t f = 0; f < within.size(); ++f) {
    if (!within[f]) continue;
    const auto corners = all.row(static_cast<Eigen::Index>(f));
    outline.triangles.row(next++) = corners;
    outline.area_mm2 += brush.areas()[f];
    for (std::size_t k = 0; k < 3; ++k) {
      if (!is_rim(brush, within, 3 * f + k)) continue;
      outline.rim.push_back(
          {corners[static_cast<Eigen::Index>(k)], corners[static_cast<Eigen::Index>((k + 1) % 3)]});
    }
  }
  return outline;
}

Selection grown(const SurfaceBrush& brush, const Selection& selection, double mm) {
  Selection larger = selection;
  const Selection everywhere(selection.size(), true);
  const std::vector<int> border = border_of(brush, selection);
  const double reach = mm + mean_edge(brush, border) / 2;
  for (const ReachedVertex& near : brush.front(border, reach, everywhere)) {
    larger[near.vertex] = true;
  }
  return larger;
}

Selection shrunk(const SurfaceBrush& brush, const Selection& selection, double mm) {
  // From the border inward, so that growing by as much brings a plain shape back.
  Selection smaller = selection;
  const std::vector<int> border = border_of(brush, selection);
  const double reach = std::max(0.0, mm - mean_edge(brush, border) / 2);
  for (const ReachedVertex& near : brush.front(border, reach, selection)) {
    smaller[near.vertex] = false;
  }
  return smaller;
}

Selection smoothed(const SurfaceBrush& brush, const Selection& selection, double mm) {
  const std::vector<int> band = band_of(brush, selection, 3 * mm);
  std::vector<float> level(selection.begin(), selection.end());
  std::vector<float> next = level;
  // A step to the neighbours or to oneself, all alike, spreads by about 3/7 of an edge's square
  // along each axis, of a vertex with six neighbours.
  const double edge = mean_edge(brush, band);
  const int steps =
      std::clamp(static_cast<int>(std::ceil(mm * mm / (edge * edge) * 7 / 3)), 2, 300);
  for (int step = 0; step < steps; ++step) {
    for (const int v : band) {
      float sum = level[v];
      int count = 1;
      for (const int w : brush.neighbours(v)) {
        sum += level[w];
        ++count;
      }
      next[v] = sum / static_cast<float>(count);
    }
    for (const int v : band) level[v] = next[v];
  }
  Selection smooth = selection;
  for (const int v : band) smooth[v] = level[v] >= 0.5F;
  return smooth;
}

Selection largest_piece(const SurfaceBrush& brush, const Selection& selection) {
  const Pieces pieces = pieces_of(brush, selection);
  Selection largest(selection.size(), false);
  for (std::size_t i = 0; i < pieces.of_triangle.size(); ++i) {
    if (pieces.of_triangle[i] != pieces.largest()) continue;
    for (const int v : brush.face().triangles.row(pieces.part.parent_triangle[i])) {
      largest[v] = true;
    }
  }
  return largest;
}

Selection filled(const SurfaceBrush& brush, const PocketSearch& pockets, const Selection& selection,
                 double mm2) {
  Selection whole = selection;
  const Selection others = inverse(selection);
  for (const std::vector<int>& piece : vertex_pieces(brush, others)) {
    double area = 0;
    bool touches = false;
    for (const int v : piece) {
      for (const int w : brush.neighbours(v)) touches = touches || selection[w];
      area += brush.area_of(v);
    }
    if (!touches || area >= mm2) continue;
    const auto hidden =
        std::count_if(piece.begin(), piece.end(), [&](int v) { return pockets.is_hidden(v); });
    if (2 * hidden > static_cast<std::ptrdiff_t>(piece.size())) continue;
    for (const int v : piece) whole[v] = true;
  }
  return whole;
}

Selection without_pinches(const SurfaceBrush& brush, const Selection& selection) {
  Selection clean = selection;
  bool changed = true;
  while (changed) {
    changed = false;
    const std::vector<bool> within = triangles_within(brush, clean);
    const std::vector<int> count = rim_edges(brush, within);
    Selection used(clean.size(), false);
    for (std::size_t f = 0; f < within.size(); ++f) {
      if (!within[f]) continue;
      for (const int v : brush.face().triangles.row(static_cast<Eigen::Index>(f))) used[v] = true;
    }
    for (std::size_t v = 0; v < clean.size(); ++v) {
      if (!clean[v] || (used[v] && count[v] <= 2)) continue;
      clean[v] = false;
      changed = true;
    }
  }
  return clean;
}

std::vector<RegionFault> region_faults(const SurfaceBrush& brush, const Selection& selection) {
  using Kind = RegionFault::Kind;
  std::vector<RegionFault> faults;
  const Pieces pieces = pieces_of(brush, selection);
  if (pieces.area.empty()) return {{Kind::empty, 0, vertices_of(selection)}};
  if (pieces.area.size() > 1) {
    const Selection largest = largest_piece(brush, selection);
    RegionFault fault{Kind::pieces, static_cast<int>(pieces.area.size()), {}};
    for (const int v : pieces.part.parent_vertex) {
      if (!largest[v]) fault.vertices.push_back(v);
    }
    faults.push_back(std::move(fault));
  }
  const std::vector<int> count = rim_edges(brush, triangles_within(brush, selection));
  if (std::all_of(count.begin(), count.end(), [](int edges) { return edges == 0; })) {
    faults.push_back({Kind::no_rim, 0, pieces.part.parent_vertex});
  }
  RegionFault pinch{Kind::touches_itself, 0, {}};
  for (std::size_t v = 0; v < count.size(); ++v) {
    if (count[v] > 2) pinch.vertices.push_back(static_cast<int>(v));
  }
  pinch.count = static_cast<int>(pinch.vertices.size());
  if (pinch.count > 0) faults.push_back(std::move(pinch));
  return faults;
}

}  // namespace gnathion
