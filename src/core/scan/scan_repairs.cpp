#include "scan/scan_repairs.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/same_places.h"
#include "io/files.h"
#include "scan/scan_problems.h"

namespace gnathion {
namespace {

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

RepairedScan untouched(const RawScan& scan) {
  RepairedScan repaired{scan, std::vector<int>(std::size_t(scan.surface.vertices.rows())), 0, ""};
  std::iota(repaired.vertex_of.begin(), repaired.vertex_of.end(), 0);
  return repaired;
}

/// Rows of `rows` for which keep is true.
template <typename Matrix>
Matrix kept_rows(const Matrix& rows, const std::vector<bool>& keep) {
  std::vector<int> kept;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i]) kept.push_back(static_cast<int>(i));
  }
  return rows(kept, Eigen::all);
}

void keep_triangles(RawScan& scan, const std::vector<bool>& keep) {
  scan.surface.triangles = kept_rows(scan.surface.triangles, keep);
  scan.corner_texture = kept_rows(scan.corner_texture, keep);
  std::size_t kept = 0;
  for (std::size_t f = 0; f < keep.size(); ++f) {
    if (keep[f]) scan.material[kept++] = scan.material[f];
  }
  scan.material.resize(kept);
}

/// Triangles name only vertices that stay. Returns how many went.
std::size_t keep_vertices(RepairedScan& repaired, const std::vector<bool>& keep) {
  RawScan& scan = repaired.scan;
  std::vector<int> row(keep.size(), -1), kept;
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (!keep[v]) continue;
    row[v] = static_cast<int>(kept.size());
    kept.push_back(repaired.vertex_of[v]);
  }
  scan.surface.vertices = kept_rows(scan.surface.vertices, keep);
  if (scan.colours.rows() > 0) scan.colours = kept_rows(scan.colours, keep);
  for (int& v : scan.surface.triangles.reshaped()) v = row[v];
  repaired.vertex_of = std::move(kept);
  return keep.size() - repaired.vertex_of.size();
}

std::vector<bool> used_vertices(const RawScan& scan) {
  std::vector<bool> used(static_cast<std::size_t>(scan.surface.vertices.rows()), false);
  for (const int v : scan.surface.triangles.reshaped()) used[v] = true;
  return used;
}

}  // namespace

RawScan raw_scan(const ObjDocument& document) {
  const TexturedMesh& mesh = document.mesh();
  RawScan scan;
  scan.surface = mesh.surface;
  scan.colours = document.vertex_colours();
  scan.texture_coordinates = mesh.texture_coordinates;
  scan.corner_texture = mesh.corner_texture;
  scan.material = mesh.triangle_material;
  const std::filesystem::path folder = document.path().parent_path();
  for (const Material& material : mesh.materials) {
    int row = -1;
    if (!material.texture.empty()) {
      row = static_cast<int>(scan.textures.size());
      const std::filesystem::path relative = material.texture.lexically_relative(folder);
      const bool beside = !relative.empty() && *relative.begin() != "..";
      scan.textures.push_back({beside ? relative.string() : material.texture.filename().string(),
                               !beside, beside ? "" : read_text_file(material.texture)});
    }
    scan.materials.push_back({material.name, material.diffuse, row});
  }
  return scan;
}

RepairedScan without_duplicate_vertices(const RawScan& scan) {
  RepairedScan repaired = untouched(scan);
  const std::vector<int> first = first_at_same_place(scan.surface.vertices);
  std::vector<bool> keep(first.size());
  for (std::size_t v = 0; v < first.size(); ++v) keep[v] = first[v] == static_cast<int>(v);
  for (int& v : repaired.scan.surface.triangles.reshaped()) v = first[v];
  repaired.changed = keep_vertices(repaired, keep);
  repaired.said = counted(repaired.changed, "vertex", "vertices") +
                  " removed that lay exactly where another does";
  return repaired;
}

RepairedScan without_unreferenced_vertices(const RawScan& scan) {
  RepairedScan repaired = untouched(scan);
  repaired.changed = keep_vertices(repaired, used_vertices(scan));
  repaired.said =
      counted(repaired.changed, "vertex", "vertices") + " removed that were in no triangle";
  return repaired;
}

RepairedScan without_degenerate_triangles(const RawScan& scan) {
  RepairedScan repaired = untouched(scan);
  std::vector<bool> keep;
  for (Eigen::Index f = 0; f < scan.surface.triangles.rows(); ++f) {
    keep.push_back(!is_degenerate(scan.surface, f));
  }
  repaired.changed = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), false));
  keep_triangles(repaired.scan, keep);
  repaired.said = counted(repaired.changed, "triangle", "triangles") + " without area removed";
  return repaired;
}

RepairedScan without_islands_below(const RawScan& scan, double size) {
  RepairedScan repaired = untouched(scan);
  const std::vector<Island> islands = islands_of(scan.surface);
  std::vector<bool> keep(scan.material.size(), true);
  std::size_t gone = 0;
  for (std::size_t i = 1; i < islands.size(); ++i) {
    if (islands[i].size >= size) continue;
    ++gone;
    for (const int f : islands[i].triangles) keep[f] = false;
  }
  const std::vector<bool> used_before = used_vertices(scan);
  keep_triangles(repaired.scan, keep);
  std::vector<bool> keep_vertex = used_vertices(repaired.scan);
  for (std::size_t v = 0; v < keep_vertex.size(); ++v) {
    keep_vertex[v] = keep_vertex[v] || !used_before[v];  // those are another repair's
  }
  keep_vertices(repaired, keep_vertex);
  repaired.changed = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), false));
  repaired.said = counted(gone, "piece", "pieces") + " removed, with " +
                  counted(repaired.changed, "triangle", "triangles");
  return repaired;
}

RepairedScan oriented(const RawScan& scan) {
  RepairedScan repaired = untouched(scan);
  const std::vector<bool> flipped = flipped_triangles(scan.surface);
  for (std::size_t f = 0; f < flipped.size(); ++f) {
    if (!flipped[f]) continue;
    ++repaired.changed;
    const auto row = static_cast<Eigen::Index>(f);
    std::swap(repaired.scan.surface.triangles(row, 1), repaired.scan.surface.triangles(row, 2));
    std::swap(repaired.scan.corner_texture(row, 1), repaired.scan.corner_texture(row, 2));
  }
  repaired.said =
      counted(repaired.changed, "triangle", "triangles") + " turned, so that all face outward";
  return repaired;
}

std::vector<int> composed(const std::vector<int>& first, const std::vector<int>& second) {
  std::vector<int> both;
  for (const int v : second) both.push_back(first[v]);
  return both;
}

}  // namespace gnathion
