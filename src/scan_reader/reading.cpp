#include "scan_reader/reading.h"

#include <algorithm>
#include <utility>

#include "geometry/same_places.h"

namespace gnathion {

namespace fs = std::filesystem;

std::string picture_beside(const fs::path& scan, const std::string& name) {
  std::string plain = name;
  std::replace(plain.begin(), plain.end(), '\\', '/');
  const fs::path folder = scan.parent_path();
  const fs::path as_named = fs::path(plain).lexically_normal();
  const bool elsewhere = as_named.is_absolute() || plain.find(':') != std::string::npos;
  std::error_code none;
  if (!elsewhere && !as_named.empty() && *as_named.begin() == "..") {
    throw ScanFailure{name, "the scan names this picture outside its own folder",
                      "put the picture into the scan's folder and correct its name there"};
  }
  for (const fs::path& at : {elsewhere ? as_named.filename() : as_named, as_named.filename()}) {
    if (!at.empty() && fs::is_regular_file(folder / at, none)) return at.string();
  }
  throw ScanFailure{name, "the picture that the scan names does not exist",
                    "put it beside the scan under this name"};
}

void unite_texture_coordinates(RawScan& scan) {
  Points flat = Points::Zero(scan.texture_coordinates.rows(), 3);
  flat.leftCols<2>() = scan.texture_coordinates;
  const std::vector<int> first = first_at_same_place(flat);
  std::vector<int> row(first.size());
  Eigen::Index kept = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != static_cast<int>(i)) {
      row[i] = row[first[i]];
      continue;
    }
    row[i] = static_cast<int>(kept);
    scan.texture_coordinates.row(kept++) = flat.row(static_cast<Eigen::Index>(i)).head<2>();
  }
  scan.texture_coordinates.conservativeResize(kept, 2);
  for (int& corner : scan.corner_texture.reshaped<Eigen::RowMajor>()) {
    if (corner >= 0) corner = row[corner];
  }
}

void unite_vertices(RawScan& scan) {
  const std::vector<int> first = first_at_same_place(scan.surface.vertices);
  std::vector<int> row(first.size());
  Eigen::Index kept = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto from = static_cast<Eigen::Index>(i);
    if (first[i] != static_cast<int>(i)) {
      row[i] = row[first[i]];
      continue;
    }
    row[i] = static_cast<int>(kept);
    scan.surface.vertices.row(kept) = scan.surface.vertices.row(from).eval();
    if (scan.colours.rows() > 0) scan.colours.row(kept) = scan.colours.row(from).eval();
    ++kept;
  }
  scan.surface.vertices.conservativeResize(kept, 3);
  if (scan.colours.rows() > 0) scan.colours.conservativeResize(kept, 3);
  for (int& corner : scan.surface.triangles.reshaped<Eigen::RowMajor>()) corner = row[corner];
}

void TriangleList::add(const Eigen::RowVector3i& vertices, const Eigen::RowVector3i& texture,
                       int material) {
  if (material_.size() >= kMostTriangles) {
    throw ScanFailure{"", "it has more than 20 million triangles",
                      "reduce it in the scanner's software"};
  }
  vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
  texture_.insert(texture_.end(), texture.begin(), texture.end());
  material_.push_back(material);
}

void TriangleList::move_into(RawScan& scan) {
  if (material_.empty()) {
    throw ScanFailure{"", "it has no faces", "export the scan as a surface, not as a point cloud"};
  }
  const auto count = static_cast<Eigen::Index>(material_.size());
  scan.surface.triangles = Eigen::Map<const Triangles>(vertices_.data(), count, 3);
  scan.corner_texture = Eigen::Map<const Triangles>(texture_.data(), count, 3);
  scan.material = std::exchange(material_, {});
}

}  // namespace gnathion
