#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

class PrivateFolder;
struct RawScan;

/// A textured photograph as its OBJ file has it. The file's text is kept, so that a changed face is
/// written with nothing but the coordinates of its `v` lines changed: order, texture coordinates,
/// faces, groups and materials stay to the letter. A scan in another format is given the text that
/// it would have as OBJ.
class ObjDocument {
 public:
  /// Reads the OBJ, its MTL files and the names of their textures.
  /// Throws Error(input) naming the file, and the line where there is one: file missing or empty,
  /// a coordinate that is no finite number, no faces, a face with an index out of range or fewer
  /// than three corners, a missing MTL or texture, or one outside the OBJ's folder.
  static ObjDocument read(const std::filesystem::path& path);

  /// A document that is in no file: a surface without texture, such as the skin of a CT.
  static ObjDocument of_surface(const TriangleMesh& surface, const std::string& name);

  /// A scan in another format: its vertices in order, triangles, materials, colours; the MTL is
  /// called after the scan. Pictures that the file carries within itself lie in a private folder
  /// for as long as this document or a copy of it lives. `path` is the scan's. The scan must hold
  /// together, as what scan_of_bytes() gives does. Throws Error(output) when the pictures cannot be
  /// put there.
  static ObjDocument of_scan(const std::filesystem::path& path, const RawScan& scan);

  /// The file's own frame and unit: all its vertices in order, polygons triangulated. Vertices at
  /// exactly the same place (a seam that was split) are one vertex to the triangles: the first.
  const TexturedMesh& mesh() const { return mesh_; }
  const std::filesystem::path& path() const { return path_; }
  /// n×3, sRGB 0..1, of the vertices; no rows when the file has none. Of an OBJ: the three numbers
  /// behind the coordinates (`v x y z r g b`) where every vertex has them, in 0..1 or in 0..255.
  const Points& vertex_colours() const { return vertex_colours_; }
  /// The scan, its MTL files and textures. (Of a document in no file, the first does not exist.)
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

  /// A file that write() copies beside the OBJ.
  struct Copied {
    std::filesystem::path from;
    std::string name;  ///< relative to the OBJ's folder
  };

  static ObjDocument parse(const std::filesystem::path& path, std::string text);
  double number_at(std::size_t& begin, std::size_t end, int line, const char* what) const;
  void read_vertices();
  void read_texture_coordinates();
  void check_faces() const;  ///< the parser passes over faces that it cannot use
  void find_material_files();
  void find_texture_files();
  void read_faces();
  void take_corners(const std::vector<int>& corners, const std::vector<int>& textures);
  void weld_split_vertices();
  void take_colours(const std::vector<double>& colours);
  void take_materials(const RawScan& scan);
  void compose_text();
  void compose_vertices();
  void compose_faces();
  std::vector<Copied> copied_files() const;

  std::filesystem::path path_;
  std::string text_;
  std::vector<VertexLine> vertex_lines_;
  std::vector<std::size_t> texture_lines_;  ///< where the `vt` lines stand in the text
  std::vector<int> welded_to_;              ///< for each vertex, the first at the same place
  std::vector<std::string> material_files_;
  std::vector<std::string> texture_files_;
  std::string material_text_;
  std::string own_material_file_;                ///< a scan's: write() makes it of material_text_
  std::shared_ptr<const PrivateFolder> inside_;  ///< of a scan's own pictures
  std::vector<std::string> inside_files_;
  TexturedMesh mesh_;
  Points vertex_colours_;
};

}  // namespace gnathion
