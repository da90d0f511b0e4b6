#include "scan/scan_export.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/error.h"
#include "io/files.h"
#include "scan/vertex_paint.h"

namespace gnathion {

namespace fs = std::filesystem;

void write_scan(const ObjDocument& document, const Points& vertices, const fs::path& folder,
                const std::string& name) {
  std::string ending = fs::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".obj") return document.write(folder, name, vertices);
  if (ending == ".ply") return write_scan_ply(document, vertices, folder / name);
  if (ending == ".glb") return write_scan_glb(document, vertices, folder / name);
  throw Error(ErrorKind::output, name, "scans are not written in this format",
              "give a name that ends in .obj, .glb or .ply");
}

void write_scan_ply(const ObjDocument& document, const Points& vertices, const fs::path& file) {
  const Points paint = vertex_paint(document);
  const Triangles& triangles = document.mesh().surface.triangles;
  std::string text =
      "ply\nformat binary_little_endian 1.0\n"
      "comment Gnathion, in the scan's own frame and unit\n"
      "element vertex " +
      std::to_string(vertices.rows()) +
      "\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face " +
      std::to_string(triangles.rows()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  text.reserve(text.size() +
               static_cast<std::size_t>(27 * vertices.rows() + 13 * triangles.rows()));
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    text.append(reinterpret_cast<const char*>(vertices.row(v).data()), 24);
    for (const double channel : paint.row(v)) {
      text += static_cast<char>(static_cast<unsigned char>(std::lround(channel * 255)));
    }
  }
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    text += '\3';
    text.append(reinterpret_cast<const char*>(triangles.row(f).data()), 12);
  }
  write_text_file(file, text);
}

}  // namespace gnathion
