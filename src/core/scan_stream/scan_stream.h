#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// A picture that a scan is painted with.
struct ScanTexture {
  std::string name;     ///< of the file, relative to the scan's folder
  bool inside = false;  ///< the scan's file carries the picture itself
  std::string bytes;    ///< then: as they would be in a picture's file (JPEG, PNG …)
};

struct ScanMaterial {
  std::string name;
  Eigen::Vector3d diffuse = Eigen::Vector3d::Constant(0.8);  ///< RGB, 0..1
  int texture = -1;                                          ///< row of the textures, −1: none
};

/// A scan as its file has it, in its own frame and unit: what the reading program hands over.
struct RawScan {
  TriangleMesh surface;  ///< vertices in the file's order, polygons triangulated
  Points colours;        ///< n×3, sRGB 0..1, one a vertex; no rows: none
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> texture_coordinates;  ///< k×2, v up
  Triangles corner_texture;   ///< m×3 rows of texture_coordinates, −1: none
  std::vector<int> material;  ///< m rows of materials, −1: none
  std::vector<ScanMaterial> materials;
  std::vector<ScanTexture> textures;
  std::vector<std::string> notices;  ///< what of the file is not kept, a sentence each
};

/// Why the reading program could not read a file.
struct ScanFailure {
  std::string subject;  ///< a file that is not the scan itself; empty: the scan
  std::string problem, remedy;
};

/// The bytes that the reading program writes. Not meant to be kept: byte order and layout are this
/// machine's.
std::string scan_bytes(const RawScan& scan);
std::string scan_bytes(const ScanFailure& failure);

/// What such bytes say. They come from a program that read a file of a stranger, so nothing is
/// believed: no count is taken before so many bytes are there, every index is in range, every
/// number finite. Throws Error(input) whose subject is `name`.
std::variant<RawScan, ScanFailure> scan_of_bytes(std::string_view bytes, const std::string& name);

}  // namespace gnathion
