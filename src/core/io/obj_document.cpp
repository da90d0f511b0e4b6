#include "io/obj_document.h"

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <tiny_obj_loader.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "base/error.h"
#include "geometry/same_places.h"
#include "io/files.h"
#include "io/private_folder.h"
#include "scan_stream/scan_stream.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& problem,
                         const std::string& remedy) {
  throw Error(ErrorKind::input, file.string(), problem, remedy);
}

bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// What follows a keyword on its line, without blanks around it.
std::string rest_of_line(const std::string& text, std::size_t begin, std::size_t end) {
  while (begin < end && is_blank(text[begin])) ++begin;
  while (end > begin && (is_blank(text[end - 1]) || text[end - 1] == '\r')) --end;
  return text.substr(begin, end - begin);
}

/// Calls `use(begin, end, number)` for every line of the text that starts with the keyword, begin
/// behind it.
template <typename Use>
void for_lines(const std::string& text, const std::string& keyword, Use use) {
  int number = 0;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) end = text.size();
    std::size_t at = begin;
    while (at < end && is_blank(text[at])) ++at;
    const std::size_t after = at + keyword.size();
    if (text.compare(at, keyword.size(), keyword) == 0 && after < end && is_blank(text[after])) {
      use(after, end, number + 1);
    }
    begin = end + 1;
  }
}

/// The next word in [begin, end): blanks before it are passed over. Empty at the line's end.
std::string_view next_word(const std::string& text, std::size_t& begin, std::size_t end) {
  while (begin < end && (is_blank(text[begin]) || text[begin] == '\r')) ++begin;
  const std::size_t start = begin;
  while (begin < end && !is_blank(text[begin]) && text[begin] != '\r') ++begin;
  return std::string_view(text).substr(start, begin - start);
}

/// Nothing unless the whole word is one finite number, with a decimal point if any.
std::optional<double> finite_number(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0;
  const char* end = word.data() + word.size();
  const auto [rest, status] = std::from_chars(word.data(), end, value);
  if (word.empty() || status != std::errc() || rest != end || !std::isfinite(value)) return {};
  return value;
}

/// Throws unless the name leads to a file within the OBJ's folder: another could not be exported.
void require_within(const fs::path& folder, const std::string& name) {
  const fs::path relative = fs::path(name).lexically_normal();
  if (!relative.is_absolute() && *relative.begin() != "..") return;
  refuse(folder / name, "the photograph names this file outside its own folder",
         "put MTL and textures into the OBJ's folder and correct their names");
}

/// A file that an OBJ or MTL names, which may have Windows' slashes.
std::string existing_name(const fs::path& folder, std::string name) {
  if (fs::exists(folder / name)) return name;
  std::replace(name.begin(), name.end(), '\\', '/');
  return fs::exists(folder / name) ? name : "";
}

}  // namespace

ObjDocument ObjDocument::read(const fs::path& path) {
  return parse(path, read_text_file(path));
}

namespace {

/// The shortest number that reads back as this one, behind a blank.
template <typename Number>
void add_number(std::string& text, Number number, char blank = ' ') {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  (text += blank).append(digits.data(), end);
}

/// A name as OBJ and MTL can hold it: nothing that ends it.
std::string one_word(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ' || c == 127) c = '_';
  }
  return name;
}

}  // namespace

ObjDocument ObjDocument::of_surface(const TriangleMesh& surface, const std::string& name) {
  std::string text = "# " + name + ", millimetres, LPS (x left, y posterior, z superior)\n";
  for (Eigen::Index v = 0; v < surface.vertices.rows(); ++v) {
    text += 'v';
    for (const double x : surface.vertices.row(v)) add_number(text, x);
    text += '\n';
  }
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    text += 'f';
    for (const int v : surface.triangles.row(f)) add_number(text, v + 1);
    text += '\n';
  }
  return parse(name, std::move(text));
}

ObjDocument ObjDocument::of_scan(const fs::path& path, const RawScan& scan) {
  ObjDocument document;
  document.path_ = path;
  document.mesh_.surface = scan.surface;
  document.mesh_.texture_coordinates = scan.texture_coordinates;
  document.mesh_.corner_texture = scan.corner_texture;
  document.mesh_.triangle_material = scan.material;
  document.vertex_colours_ = scan.colours.cwiseMax(0).cwiseMin(1);
  document.take_materials(scan);
  document.compose_text();
  document.weld_split_vertices();
  return document;
}

void ObjDocument::take_materials(const RawScan& scan) {
  std::vector<fs::path> pictures;
  for (const ScanTexture& texture : scan.textures) {
    if (texture.inside) {
      if (inside_ == nullptr) inside_ = std::make_shared<const PrivateFolder>();
      const std::string name = one_word(fs::path(texture.name).filename().string());
      write_text_file(inside_->path() / name, texture.bytes);
      inside_files_.push_back(name);
      pictures.push_back(inside_->path() / name);
    } else {
      require_within(path_.parent_path(), texture.name);
      texture_files_.push_back(texture.name);
      pictures.push_back(path_.parent_path() / texture.name);
    }
  }
  std::set<std::string> names;
  const auto add = [&](std::string name, const Eigen::Vector3d& diffuse, int texture) {
    name = name.empty() ? "material" : one_word(name);
    while (!names.insert(name).second) name += '_';
    material_text_ += "newmtl " + name + "\nKd";
    for (const double channel : diffuse) add_number(material_text_, channel);
    material_text_ += '\n';
    if (texture >= 0) {
      const ScanTexture& picture = scan.textures[static_cast<std::size_t>(texture)];
      material_text_ += "map_Kd " + (picture.inside ? one_word(picture.name) : picture.name) + "\n";
    }
    mesh_.materials.push_back(
        {name, diffuse, texture < 0 ? fs::path() : pictures[static_cast<std::size_t>(texture)]});
  };
  for (const ScanMaterial& m : scan.materials) add(m.name, m.diffuse, m.texture);
  // OBJ has no word for "without material" once there was one.
  auto& of_triangle = mesh_.triangle_material;
  if (scan.materials.empty() || std::count(of_triangle.begin(), of_triangle.end(), -1) == 0) return;
  std::replace(of_triangle.begin(), of_triangle.end(), -1, static_cast<int>(scan.materials.size()));
  add("plain", Material().diffuse, -1);
}

void ObjDocument::compose_text() {
  const std::string stem = one_word(path_.stem().string());
  text_ = "# " + one_word(path_.filename().string()) + " as OBJ, in its own frame and unit\n";
  if (!mesh_.materials.empty()) {
    own_material_file_ = stem + ".mtl";
    text_ += "mtllib " + own_material_file_ + "\n";
  }
  text_.reserve(static_cast<std::size_t>(mesh_.surface.vertices.rows()) * 60 +
                static_cast<std::size_t>(mesh_.surface.triangles.rows()) * 44);
  compose_vertices();
  compose_faces();
}

void ObjDocument::compose_vertices() {
  const Points& x = mesh_.surface.vertices;
  vertex_lines_.reserve(static_cast<std::size_t>(x.rows()));
  for (Eigen::Index v = 0; v < x.rows(); ++v) {
    text_ += 'v';
    const std::size_t begin = text_.size() + 1;
    for (const double coordinate : x.row(v)) add_number(text_, coordinate);
    vertex_lines_.push_back({begin, text_.size()});
    if (vertex_colours_.rows() > 0) {
      for (const double channel : vertex_colours_.row(v)) add_number(text_, channel);
    }
    text_ += '\n';
  }
  for (const auto& uv : mesh_.texture_coordinates.rowwise()) {
    text_ += "vt";
    for (const double coordinate : uv) add_number(text_, coordinate);
    text_ += '\n';
  }
}

void ObjDocument::compose_faces() {
  int material = -1;
  for (Eigen::Index f = 0; f < mesh_.surface.triangles.rows(); ++f) {
    const int own = mesh_.triangle_material[static_cast<std::size_t>(f)];
    if (own != material) {
      text_ += "usemtl " + mesh_.materials[static_cast<std::size_t>(own)].name + "\n";
      material = own;
    }
    text_ += 'f';
    for (int k = 0; k < 3; ++k) {
      add_number(text_, mesh_.surface.triangles(f, k) + 1);
      const int texture = mesh_.corner_texture(f, k);
      if (texture >= 0) add_number(text_, texture + 1, '/');
    }
    text_ += '\n';
  }
}

ObjDocument ObjDocument::parse(const fs::path& path, std::string text) {
  ObjDocument document;
  document.path_ = path;
  document.text_ = std::move(text);
  document.read_vertices();
  document.read_texture_coordinates();
  document.check_faces();
  document.find_material_files();
  document.find_texture_files();
  document.read_faces();
  document.weld_split_vertices();
  return document;
}

/// The next word of a line as a finite number, or else that `what` is none.
double ObjDocument::number_at(std::size_t& begin, std::size_t end, int line,
                              const char* what) const {
  if (const auto value = finite_number(next_word(text_, begin, end))) return *value;
  refuse(path_, "line " + std::to_string(line) + ": " + what + " is not a finite number",
         "mend the file (numbers with a decimal point) or export it again");
}

void ObjDocument::read_vertices() {
  std::vector<double> values, colours;
  for_lines(text_, "v", [&](std::size_t begin, std::size_t end, int number) {
    while (begin < end && is_blank(text_[begin])) ++begin;
    VertexLine line{begin, begin};
    for (const char* what : {"coordinate 1 of the vertex", "coordinate 2 of the vertex",
                             "coordinate 3 of the vertex"}) {
      values.push_back(number_at(line.end, end, number, what));
    }
    vertex_lines_.push_back(line);
    for (std::size_t at = line.end; at < end;) {
      if (const auto value = finite_number(next_word(text_, at, end))) colours.push_back(*value);
    }
  });
  if (values.empty()) refuse(path_, "it has no vertices", "choose a Wavefront OBJ file");
  mesh_.surface.vertices =
      Eigen::Map<const Points>(values.data(), static_cast<Eigen::Index>(values.size() / 3), 3);
  take_colours(colours);
}

void ObjDocument::read_texture_coordinates() {
  std::vector<double> texture;
  for_lines(text_, "vt", [&](std::size_t begin, std::size_t end, int number) {
    texture_lines_.push_back(begin);
    std::array<double, 3> uvw{};  // the third is for solid textures, and not used
    std::size_t read = 0;
    do {
      const double value = number_at(begin, end, number, "a texture coordinate");
      if (read < uvw.size()) uvw[read++] = value;
      while (begin < end && (is_blank(text_[begin]) || text_[begin] == '\r')) ++begin;
    } while (begin < end);
    texture.insert(texture.end(), uvw.begin(), uvw.begin() + 2);
  });
  mesh_.texture_coordinates = Eigen::Map<const decltype(mesh_.texture_coordinates)>(
      texture.data(), static_cast<Eigen::Index>(texture.size() / 2), 2);
}

void ObjDocument::take_colours(const std::vector<double>& colours) {
  const Eigen::Index count = mesh_.surface.vertices.rows();
  if (colours.empty() || colours.size() != static_cast<std::size_t>(3 * count)) return;
  vertex_colours_ = Eigen::Map<const Points>(colours.data(), count, 3);
  if (vertex_colours_.maxCoeff() > 1) vertex_colours_ /= 255;
  vertex_colours_ = vertex_colours_.cwiseMax(0).cwiseMin(1);
}

void ObjDocument::check_faces() const {
  std::vector<std::size_t> vertices_at;
  for (const VertexLine& line : vertex_lines_) vertices_at.push_back(line.begin);
  const auto check = [this](std::string_view index, const std::vector<std::size_t>& at,
                            std::size_t line, int number, const char* what) {
    long i = 0;
    const char* end = index.data() + index.size();
    const auto [rest, status] = std::from_chars(index.data(), end, i);
    const auto before = std::lower_bound(at.begin(), at.end(), line) - at.begin();
    const auto count = static_cast<long>(at.size());
    if (status == std::errc() && rest == end && i != 0 && i <= count && i >= -before) return;
    refuse(path_,
           "line " + std::to_string(number) + ": a face names " + what + " \"" +
               std::string(index) + "\", but there are only " + std::to_string(count),
           "the file is damaged: export the photograph again");
  };
  for_lines(text_, "f", [&](std::size_t begin, std::size_t end, int number) {
    const std::size_t line = begin;
    int corners = 0;
    for (std::string_view word = next_word(text_, begin, end); !word.empty();
         word = next_word(text_, begin, end), ++corners) {
      const std::size_t slash = std::min(word.find('/'), word.size());
      check(word.substr(0, slash), vertices_at, line, number, "vertex");
      if (slash == word.size()) continue;
      const std::string_view texture =
          word.substr(slash + 1, word.find('/', slash + 1) - slash - 1);
      if (!texture.empty()) check(texture, texture_lines_, line, number, "texture coordinate");
    }
    if (corners < 3) {
      refuse(path_, "line " + std::to_string(number) + ": a face has fewer than 3 corners",
             "the file is damaged: export the photograph again");
    }
  });
}

void ObjDocument::find_material_files() {
  const fs::path folder = path_.parent_path();
  for_lines(text_, "mtllib", [&](std::size_t begin, std::size_t end, int) {
    // The whole rest is one name, blanks included, unless only its parts exist.
    const std::string rest = rest_of_line(text_, begin, end);
    std::vector<std::string> names{rest};
    if (existing_name(folder, rest).empty()) {
      std::istringstream words(rest);
      const std::vector<std::string> parts(std::istream_iterator<std::string>(words), {});
      if (!parts.empty() && !existing_name(folder, parts.front()).empty()) names = parts;
    }
    for (const std::string& name : names) {
      const std::string found = existing_name(folder, name);
      if (found.empty()) {
        refuse(folder / name,
               "the material file that " + path_.filename().string() + " names does not exist",
               "put it beside the OBJ, or remove the mtllib line");
      }
      require_within(folder, found);
      material_files_.push_back(found);
      material_text_ += read_text_file(folder / found) + "\n";
    }
  });
}

void ObjDocument::find_texture_files() {
  const fs::path folder = path_.parent_path();
  for (const char* keyword :
       {"map_Kd", "map_Ka", "map_Ks", "map_Bump", "map_bump", "map_d", "bump", "norm", "map_Ns"}) {
    for_lines(material_text_, keyword, [&](std::size_t begin, std::size_t end, int) {
      const std::string rest = rest_of_line(material_text_, begin, end);
      std::string name = existing_name(folder, rest);
      // With options such as "-bm 0.2" before it, the name is the last word.
      if (name.empty()) name = existing_name(folder, rest.substr(rest.find_last_of(" \t") + 1));
      if (name.empty()) {
        refuse(folder / rest, "the texture that the photograph's material names does not exist",
               "put the picture beside the OBJ under this name");
      }
      if (std::find(texture_files_.begin(), texture_files_.end(), name) == texture_files_.end()) {
        require_within(folder, name);
        texture_files_.push_back(name);
      }
    });
  }
}

void ObjDocument::read_faces() {
  tinyobj::ObjReaderConfig config;
  config.vertex_color = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(text_, material_text_, config)) {
    refuse(path_, "it cannot be read: " + reader.Error(), "export the photograph again as OBJ");
  }
  // It leaves polygons out whose vertices come later in the file, and only warns of it.
  if (reader.Warning().find("invalid vertex index") != std::string::npos) {
    refuse(path_, "a face stands before its vertices", "export the photograph again as OBJ");
  }
  std::vector<int> corners, textures;
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    // All polygons are triangles by now.
    const auto& materials = shape.mesh.material_ids;
    for (const tinyobj::index_t& index : shape.mesh.indices) {
      corners.push_back(index.vertex_index);
      textures.push_back(index.texcoord_index);
    }
    mesh_.triangle_material.insert(mesh_.triangle_material.end(), materials.begin(),
                                   materials.end());
  }
  take_corners(corners, textures);
  const fs::path folder = path_.parent_path();
  for (const tinyobj::material_t& material : reader.GetMaterials()) {
    const std::string texture = existing_name(folder, material.diffuse_texname);
    mesh_.materials.push_back({material.name,
                               {material.diffuse[0], material.diffuse[1], material.diffuse[2]},
                               material.diffuse_texname.empty() ? fs::path() : folder / texture});
  }
}

/// Three a triangle. textures: −1 for none.
void ObjDocument::take_corners(const std::vector<int>& corners, const std::vector<int>& textures) {
  if (corners.empty()) {
    refuse(path_, "it has no faces", "export the photograph as a surface, not as a point cloud");
  }
  const auto require_below = [this](const std::vector<int>& indices, int least, Eigen::Index count,
                                    const std::string& what) {
    for (const int i : indices) {
      if (i >= least && i < count) continue;
      refuse(path_,
             "a face names " + what + " " + std::to_string(i + 1) + ", but there are only " +
                 std::to_string(count),
             "the file is damaged: export the photograph again");
    }
  };
  require_below(corners, 0, mesh_.surface.vertices.rows(), "vertex");
  require_below(textures, -1, mesh_.texture_coordinates.rows(), "texture coordinate");
  const auto count = static_cast<Eigen::Index>(corners.size() / 3);
  mesh_.surface.triangles = Eigen::Map<const Triangles>(corners.data(), count, 3);
  mesh_.corner_texture = Eigen::Map<const Triangles>(textures.data(), count, 3);
}

void ObjDocument::weld_split_vertices() {
  welded_to_ = first_at_same_place(mesh_.surface.vertices);
  // Triangles that welding leaves without area (two corners the same) carry nothing.
  Eigen::Index kept = 0;
  TriangleMesh& surface = mesh_.surface;
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    Eigen::RowVector3i t;
    for (int k = 0; k < 3; ++k) t[k] = welded_to_[surface.triangles(f, k)];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    surface.triangles.row(kept) = t;
    mesh_.corner_texture.row(kept) = mesh_.corner_texture.row(f).eval();
    mesh_.triangle_material[kept] = mesh_.triangle_material[f];
    ++kept;
  }
  surface.triangles.conservativeResize(kept, 3);
  mesh_.corner_texture.conservativeResize(kept, 3);
  mesh_.triangle_material.resize(static_cast<std::size_t>(kept));
}

std::vector<fs::path> ObjDocument::files() const {
  std::vector<fs::path> files{path_};
  for (const std::string& name : material_files_) files.push_back(path_.parent_path() / name);
  for (const std::string& name : texture_files_) files.push_back(path_.parent_path() / name);
  return files;
}

std::string ObjDocument::text_with(const Points& vertices) const {
  std::string text;
  text.reserve(text_.size() + vertex_lines_.size() * 16);
  std::size_t done = 0;
  for (std::size_t v = 0; v < vertex_lines_.size(); ++v) {
    const Eigen::RowVector3d x = vertices.row(welded_to_[v]);
    if (x == mesh_.surface.vertices.row(welded_to_[v])) continue;
    text.append(text_, done, vertex_lines_[v].begin - done);
    for (int axis = 0; axis < 3; ++axis) {
      std::array<char, 32> digits;
      const auto [end, status] =
          std::to_chars(digits.data(), digits.data() + digits.size(), x[axis]);
      if (axis > 0) text += ' ';
      text.append(digits.data(), end);
    }
    done = vertex_lines_[v].end;
  }
  return text.append(text_, done, std::string::npos);
}

std::vector<ObjDocument::Copied> ObjDocument::copied_files() const {
  std::set<std::string> names(material_files_.begin(), material_files_.end());
  names.insert(texture_files_.begin(), texture_files_.end());
  std::vector<Copied> copied;
  for (const std::string& name : names) copied.push_back({path_.parent_path() / name, name});
  for (const std::string& name : inside_files_) copied.push_back({inside_->path() / name, name});
  return copied;
}

void ObjDocument::write(const fs::path& folder, const std::string& name,
                        const Points& vertices) const {
  write_text_file(folder / name, text_with(vertices));
  if (!own_material_file_.empty()) write_text_file(folder / own_material_file_, material_text_);
  for (const Copied& copy : copied_files()) {
    const fs::path relative = fs::path(copy.name).lexically_normal();  // within, as read() saw
    std::error_code failure;
    fs::create_directories((folder / relative).parent_path(), failure);
    fs::copy_file(copy.from, folder / relative, failure);
    if (failure) {
      throw Error(ErrorKind::output, (folder / relative).string(), failure.message(),
                  failure == std::errc::file_exists
                      ? "give this file of the photograph another name"
                      : "check free space and rights");
    }
  }
}

}  // namespace gnathion
