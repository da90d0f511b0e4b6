#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// A textured photograph as its OBJ file has it. The file's text is kept, so that a changed face is
/// written with nothing but the coordinates of its `v` lines changed: order, texture coordinates,
/// faces, groups and materials stay to the letter.
class ObjDocument {
 public:
  /// Reads the OBJ, its MTL files and the names of their textures.
  /// Throws Error(input) naming the file, and the line where there is one: file missing or empty,
  /// a coordinate that is no finite number, no faces, a face with an index out of range or fewer
  /// than three corners, a missing MTL or texture, or one outside the OBJ's folder.
  static ObjDocument read(const std::filesystem::path& path);

  /// A document that is in no file: a surface without texture, such as the skin of a CT.
  static ObjDocument of_surface(const TriangleMesh& surface, const std::string& name);

  /// The file's own frame and unit: all its vertices in order, polygons triangulated. Vertices at
  /// exactly the same place (a seam that was split) are one vertex to the triangles: the first.
  const TexturedMesh& mesh() const { return mesh_; }
  const std::filesystem::path& path() const { return path_; }
  /// The OBJ, its MTL files and textures. (Of a document in no file, the first does not exist.)
  std::vector<std::filesystem::path> files() const;

  /// The OBJ's text with other vertices: n×3, file's frame. A row equal to the file's own keeps its
  /// line to the letter. Rows of split vertices are taken from the vertex they are one with.
  std::string text_with(const Points& vertices) const;

  /// Writes `name` with these vertices into an existing folder, and copies of the MTL files and
  /// textures, byte for byte, beside it as the OBJ names them. Throws Error(output), also when a
  /// name is that of a file in it.
  void write(const std::filesystem::path& folder, const std::string& name,
             const Points& vertices) const;

 private:
  struct VertexLine {
    std::size_t begin = 0, end = 0;  ///< of the three coordinates in the text
  };

  static ObjDocument parse(const std::filesystem::path& path, std::string text);
  void find_vertex_lines();  ///< and checks their numbers, and those of texture coordinates
  void check_faces() const;  ///< the parser passes over faces that it cannot use
  void find_materials();
  void read_faces();
  void weld_split_vertices();

  std::filesystem::path path_;
  std::string text_;
  std::vector<VertexLine> vertex_lines_;
  std::vector<std::size_t> texture_lines_;  ///< where the `vt` lines stand in the text
  std::vector<int> welded_to_;              ///< for each vertex, the first at the same place
  std::vector<std::string> material_files_;
  std::vector<std::string> texture_files_;
  std::string material_text_;
  TexturedMesh mesh_;
};

}  // namespace gnathion
