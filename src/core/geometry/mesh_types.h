#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace gnathion {

/// n×3, one point a row, mm, LPS unless said otherwise.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// m×3 vertex indices, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// m×4 vertex indices; positive volume: (b−a)×(c−a)·(d−a) > 0.
using Tets = Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// A triangle surface. Plain data: whoever makes one guarantees indices in range and finite
/// coordinates.
struct TriangleMesh {
  Points vertices;      ///< n×3, mm, LPS
  Triangles triangles;  ///< m×3
};

/// A tetrahedral mesh. Plain data, as TriangleMesh.
struct TetMesh {
  Points vertices;  ///< n×3, mm, LPS
  Tets tets;        ///< m×4
};

/// How a part of a photograph looks.
struct Material {
  std::string name;
  Eigen::Vector3d diffuse = Eigen::Vector3d::Constant(0.8);  ///< RGB, 0..1
  std::filesystem::path texture;                             ///< empty: untextured
};

/// A face surface as it is shown and simulated: the photograph's own vertices, its polygons
/// triangulated. Texture coordinates belong to corners, so a seam needs no split vertices.
struct TexturedMesh {
  TriangleMesh surface;
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> texture_coordinates;  ///< k×2, v up
  Triangles corner_texture;  ///< m×3 rows of texture_coordinates, −1 where there is none
  std::vector<int> triangle_material;  ///< m, index into materials, −1 where there is none
  std::vector<Material> materials;
};

}  // namespace gnathion
