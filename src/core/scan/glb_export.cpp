#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geometry/triangle_mesh.h"
#include "io/files.h"
#include "scan/scan_export.h"

namespace gnathion {
namespace {

using nlohmann::json;

// glTF 2.0's numbers for kinds of values and uses of buffers (5.1.3, 5.11.5).
constexpr int kFloat = 5126, kUnsigned = 5125, kVertices = 34962, kIndices = 34963;

/// sRGB to an amount of light (IEC 61966-2-1), as glTF has colours.
double light_of_srgb(double x) {
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

/// The vertices of one material's triangles: one for each pair of vertex and texture coordinate.
struct Part {
  std::vector<int> vertex, uv;
  std::vector<std::uint32_t> indices;
};

Part part_of(const TexturedMesh& mesh, int material, bool textured) {
  Part part;
  std::unordered_map<std::uint64_t, std::uint32_t> known;
  for (Eigen::Index f = 0; f < mesh.surface.triangles.rows(); ++f) {
    if (mesh.triangle_material[static_cast<std::size_t>(f)] != material ||
        (mesh.corner_texture.row(f).minCoeff() >= 0) != textured) {
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const int v = mesh.surface.triangles(f, k), uv = textured ? mesh.corner_texture(f, k) : -1;
      const auto key = static_cast<std::uint64_t>(v) << 32U | static_cast<std::uint32_t>(uv);
      const auto [found, is_new] =
          known.try_emplace(key, static_cast<std::uint32_t>(part.vertex.size()));
      if (is_new) {
        part.vertex.push_back(v);
        part.uv.push_back(uv);
      }
      part.indices.push_back(found->second);
    }
  }
  return part;
}

class GlbWriter {
 public:
  GlbWriter(const ObjDocument& document, const Points& vertices)
      : document_(document),
        mesh_(document.mesh()),
        vertices_(vertices),
        normals_(vertex_normals({vertices, mesh_.surface.triangles})) {}

  std::string file() {
    json_ = {{"asset", {{"version", "2.0"}, {"generator", "Gnathion"}}},
             {"scene", 0},
             {"scenes", {{{"nodes", {0}}}}},
             {"nodes", {{{"mesh", 0}}}}};
    add_materials();
    json_["meshes"] = {{{"primitives", json::array()}}};
    for (int m = -1; m < static_cast<int>(mesh_.materials.size()); ++m) {
      for (const bool textured : {true, false}) add_part(m, part_of(mesh_, m, textured));
    }
    json_["buffers"] = {{{"byteLength", bytes_.size()}}};
    return packed();
  }

 private:
  void add_materials() {
    for (const Material& material : mesh_.materials) {
      json look = {{"metallicFactor", 0}, {"roughnessFactor", 1}};
      if (material.texture.empty()) {
        look["baseColorFactor"] = {light_of_srgb(material.diffuse.x()),
                                   light_of_srgb(material.diffuse.y()),
                                   light_of_srgb(material.diffuse.z()), 1};
      } else {
        look["baseColorTexture"] = {{"index", texture(material.texture)}};
      }
      json_["materials"].push_back(
          {{"name", material.name}, {"doubleSided", true}, {"pbrMetallicRoughness", look}});
    }
  }

  int texture(const std::filesystem::path& file) {
    const auto known = textures_.find(file);
    if (known != textures_.end()) return known->second;
    std::string bytes = read_text_file(file);
    const bool jpeg = bytes.starts_with("\xff\xd8\xff");
    if (!jpeg && !bytes.starts_with("\x89PNG")) bytes = png_of(file);
    json_["images"].push_back({{"bufferView", view(bytes.data(), bytes.size(), 0)},
                               {"mimeType", jpeg ? "image/jpeg" : "image/png"},
                               {"name", file.stem().string()}});
    const int row = static_cast<int>(textures_.size());
    json_["textures"].push_back({{"source", row}});
    return textures_[file] = row;
  }

  static std::string png_of(const std::filesystem::path& file) {
    std::vector<unsigned char> png;
    try {
      const cv::Mat picture =
          cv::imread(file.string(), cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
      if (!picture.empty()) cv::imencode(".png", picture, png);
    } catch (const cv::Exception&) {
      png.clear();  // told below like any picture that cannot be read
    }
    if (png.empty()) {
      throw Error(ErrorKind::input, file.string(), "the texture image cannot be read",
                  "open it in an image program and save it again as JPEG or PNG");
    }
    return {png.begin(), png.end()};
  }

  void add_part(int material, const Part& part) {
    if (part.indices.empty()) return;
    json attributes;
    attributes["POSITION"] = rows(part.vertex, vertices_);
    attributes["NORMAL"] = rows(part.vertex, normals_);
    if (part.uv.front() >= 0) attributes["TEXCOORD_0"] = texture_coordinates(part);
    if (document_.vertex_colours().rows() > 0) {
      attributes["COLOR_0"] =
          rows(part.vertex, document_.vertex_colours().unaryExpr(&light_of_srgb));
    }
    const int indices = accessor(part.indices.data(), part.indices.size(), 1, kUnsigned, "SCALAR");
    json primitive = {{"attributes", attributes}, {"indices", indices}};
    if (material >= 0) primitive["material"] = material;
    json_["meshes"][0]["primitives"].push_back(primitive);
  }

  int rows(const std::vector<int>& row_of, const Points& points) {
    std::vector<float> numbers;
    numbers.reserve(3 * row_of.size());
    for (const int row : row_of) {
      for (const double x : points.row(row)) numbers.push_back(static_cast<float>(x));
    }
    const int index = accessor(numbers.data(), row_of.size(), 3, kFloat, "VEC3");
    // The format asks for the box of positions; of the other rows it does no harm.
    const Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>> all(
        numbers.data(), static_cast<Eigen::Index>(row_of.size()), 3);
    const Eigen::RowVector3f low = all.colwise().minCoeff(), high = all.colwise().maxCoeff();
    json_["accessors"].back()["min"] = {low.x(), low.y(), low.z()};
    json_["accessors"].back()["max"] = {high.x(), high.y(), high.z()};
    return index;
  }

  int texture_coordinates(const Part& part) {
    std::vector<float> numbers;
    for (const int row : part.uv) {
      numbers.push_back(static_cast<float>(mesh_.texture_coordinates(row, 0)));
      numbers.push_back(static_cast<float>(1 - mesh_.texture_coordinates(row, 1)));  // v down
    }
    return accessor(numbers.data(), part.uv.size(), 2, kFloat, "VEC2");
  }

  template <typename T>
  int accessor(const T* numbers, std::size_t count, std::size_t columns, int kind,
               const char* shape) {
    const int of =
        view(numbers, count * columns * sizeof(T), kind == kUnsigned ? kIndices : kVertices);
    json_["accessors"].push_back(
        {{"bufferView", of}, {"componentType", kind}, {"count", count}, {"type", shape}});
    return static_cast<int>(json_["accessors"].size()) - 1;
  }

  int view(const void* data, std::size_t size, int use) {
    json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}};
    if (use != 0) view["target"] = use;
    bytes_.append(static_cast<const char*>(data), size);
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    json_["bufferViews"].push_back(view);
    return static_cast<int>(json_["bufferViews"].size()) - 1;
  }

  /// Header and two chunks (glTF 2.0, 4.4). Little-endian, as every machine this runs on.
  std::string packed() const {
    std::string text = json_.dump(-1, ' ', false, json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t total = 12 + 8 + text.size() + 8 + bytes_.size();
    if (total > std::numeric_limits<std::uint32_t>::max()) {
      throw Error(ErrorKind::output, document_.path().string(),
                  "the scan and its pictures are larger than a GLB can be (4 GiB)",
                  "write it as OBJ");
    }
    std::string file = "glTF";
    const auto add = [&file](std::size_t value) {
      const auto number = static_cast<std::uint32_t>(value);
      file.append(reinterpret_cast<const char*>(&number), 4);
    };
    add(2);
    add(total);
    add(text.size());
    (file += "JSON") += text;
    add(bytes_.size());
    file.append("BIN\0", 4);
    return file += bytes_;
  }

  const ObjDocument& document_;
  const TexturedMesh& mesh_;
  const Points& vertices_;
  Points normals_;
  json json_;
  std::string bytes_;
  std::map<std::filesystem::path, int> textures_;
};

}  // namespace

void write_scan_glb(const ObjDocument& document, const Points& vertices,
                    const std::filesystem::path& file) {
  write_text_file(file, GlbWriter(document, vertices).file());
}

}  // namespace gnathion
