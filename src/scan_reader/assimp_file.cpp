#include <assimp/DefaultIOSystem.h>
#include <assimp/GltfMaterial.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <Eigen/LU>
#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cctype>
#include <cmath>
#include <memory>

#include "scan_reader/reading.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

/// Opens nothing outside the scan's folder, and no pipe or device.
class FilesOfFolder : public Assimp::DefaultIOSystem {
 public:
  explicit FilesOfFolder(const fs::path& scan)
      : scan_(fs::weakly_canonical(scan)), folder_(scan_.parent_path()) {}

  bool Exists(const char* file) const override {
    return may_open(file) && DefaultIOSystem::Exists(file);
  }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return may_open(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
  }
  /// The first file that was asked for outside, or is not there.
  const std::string& refused() const { return refused_; }

 private:
  bool may_open(const char* file) const {
    std::error_code none;
    const fs::path real = fs::weakly_canonical(file, none);
    const auto [end, rest] =
        std::mismatch(folder_.begin(), folder_.end(), real.begin(), real.end());
    const bool within = real == scan_ || end == folder_.end();
    if (within && fs::is_regular_file(real, none)) return true;
    if (refused_.empty()) refused_ = file;
    return false;
  }

  fs::path scan_, folder_;
  mutable std::string refused_;
};

std::string lower_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// Hears what assimp only logs: that it left out faces whose vertices do not exist.
class Complaints : public Assimp::LogStream {
 public:
  void write(const char* message) override {
    const std::string text(message);
    for (const char* words : {"out of range", "out-of-range", "invalid index"}) {
      if (text.find(words) != std::string::npos) damaged_ = true;
    }
  }
  bool damaged() const { return damaged_; }

 private:
  bool damaged_ = false;
};

/// On one line, and not without end.
std::string plain(std::string text) {
  for (char& c : text) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  }
  if (text.size() > 200) text = text.substr(0, 200) + " …";
  return text.empty() ? "no reason is known" : text;
}

/// glTF's colours are amounts of light (glTF 2.0, 3.9.2); everything else here is sRGB (IEC
/// 61966-2-1).
double srgb_of_light(double x) {
  if (x >= 1) return 1;
  x = std::max(x, 0.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

/// An extension for a picture's bytes; empty for what is none that OpenCV reads.
std::string picture_kind(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xff\xd8\xff"sv)) return "jpg";
  if (bytes.starts_with("\x89PNG"sv)) return "png";
  if (bytes.starts_with("BM"sv)) return "bmp";
  if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv)) return "tif";
  if (bytes.starts_with("RIFF"sv) && bytes.substr(0, 12).ends_with("WEBP"sv)) return "webp";
  return "";
}

class SceneReader {
 public:
  SceneReader(const fs::path& file, const aiScene& scene)
      : file_(file), scene_(scene), extension_(lower_extension(file)) {}

  RawScan read() {
    read_materials();
    add_node(*scene_.mRootNode, Eigen::Matrix4d::Identity(), 0);
    triangles_.move_into(scan_);
    drop_material_of_assimp();
    take_numbers();
    unite_texture_coordinates(scan_);
    // Of these, glTF and OFF alone have vertices that several triangles share.
    if (!is_gltf() && extension_ != ".off") unite_vertices(scan_);
    return std::move(scan_);
  }

 private:
  bool is_gltf() const { return extension_ == ".gltf" || extension_ == ".glb"; }
  double colour(double channel) const { return is_gltf() ? srgb_of_light(channel) : channel; }
  void notice(const std::string& text) {
    auto& all = scan_.notices;
    if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
  }

  void read_materials() {
    for (unsigned m = 0; m < scene_.mNumMaterials; ++m) {
      const aiMaterial& from = *scene_.mMaterials[m];
      ScanMaterial material;
      material.name = from.GetName().C_Str();
      aiColor4D diffuse;
      if (from.Get(AI_MATKEY_BASE_COLOR, diffuse) == AI_SUCCESS ||
          from.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse) == AI_SUCCESS) {
        material.diffuse = {colour(diffuse.r), colour(diffuse.g), colour(diffuse.b)};
      }
      material.texture = texture_of(from, m);
      scan_.materials.push_back(material);
    }
  }

  /// To every glTF assimp adds a material for parts that have none.
  void drop_material_of_assimp() {
    const auto last = static_cast<int>(scan_.materials.size()) - 1;
    if (!is_gltf() || last < 0) return;
    if (std::find(scan_.material.begin(), scan_.material.end(), last) != scan_.material.end()) {
      return;
    }
    scan_.materials.pop_back();
  }

  int texture_of(const aiMaterial& material, unsigned m) {
    uv_set_.push_back(0);
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      aiString name;
      if (material.GetTexture(type, 0, &name) != AI_SUCCESS || name.length == 0) continue;
      int set = 0;
      if (material.Get(AI_MATKEY_UVWSRC(type, 0), set) == AI_SUCCESS && set >= 0 && set < 8) {
        uv_set_[m] = static_cast<unsigned>(set);
      }
      aiUVTransform transform;
      if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == AI_SUCCESS) {
        notice("a material moves its picture by a transform of its own, which is not applied");
      }
      return texture_row(name.C_Str());
    }
    return -1;
  }

  int texture_row(const std::string& name) {
    const auto known = std::find(texture_names_.begin(), texture_names_.end(), name);
    if (known != texture_names_.end()) return static_cast<int>(known - texture_names_.begin());
    const auto row = static_cast<int>(texture_names_.size());
    texture_names_.push_back(name);
    const aiTexture* inside = scene_.GetEmbeddedTexture(name.c_str());
    if (inside == nullptr) {
      scan_.textures.push_back({picture_beside(file_, name), false, ""});
      return row;
    }
    const std::string_view bytes(reinterpret_cast<const char*>(inside->pcData), inside->mWidth);
    const std::string kind = inside->mHeight == 0 ? picture_kind(bytes) : "";
    if (kind.empty()) {
      throw ScanFailure{"", "the picture within it is neither JPEG, PNG, TIFF, BMP nor WebP",
                        "export the scan with JPEG or PNG pictures"};
    }
    scan_.textures.push_back(
        {file_.stem().string() + "_" + std::to_string(row) + "." + kind, true, std::string(bytes)});
    return row;
  }

  void add_node(const aiNode& node, const Eigen::Matrix4d& parent, int depth) {
    if (depth > 1000) throw ScanFailure{"", "its parts are nested without end", "export it again"};
    Eigen::Matrix4d own;
    const aiMatrix4x4& m = node.mTransformation;
    own << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3,
        m.d4;
    const Eigen::Matrix4d place = parent * own;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes) {
        throw ScanFailure{"", "a part of it names a mesh that does not exist", "export it again"};
      }
      add_mesh(*scene_.mMeshes[node.mMeshes[i]], place);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      add_node(*node.mChildren[i], place, depth + 1);
    }
  }

  void add_mesh(const aiMesh& mesh, const Eigen::Matrix4d& place) {
    if (mesh.mNumAnimMeshes > 0) notice("shapes that it could be morphed to are not kept");
    const auto first = static_cast<int>(vertices_.size() / 3);
    if (vertices_.size() / 3 + mesh.mNumVertices > kMostVertices) {
      throw ScanFailure{"", "it has more than 60 million vertices",
                        "reduce it in the scanner's software"};
    }
    add_vertices(mesh, place);
    const int first_uv = add_texture_coordinates(mesh);
    const auto material =
        mesh.mMaterialIndex < scene_.mNumMaterials ? int(mesh.mMaterialIndex) : -1;
    // A part that is placed as its own mirror image is wound the other way round.
    const bool mirrored = place.topLeftCorner<3, 3>().determinant() < 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines; polygons were triangulated
      Eigen::RowVector3i corners;
      for (int k = 0; k < 3; ++k) {
        const unsigned index = face.mIndices[mirrored ? 2 - k : k];
        if (index >= mesh.mNumVertices) {
          throw ScanFailure{"",
                            "a face of it names vertex " + std::to_string(index) +
                                ", but there are only " + std::to_string(mesh.mNumVertices),
                            "the file is damaged: export the scan again"};
        }
        corners[k] = static_cast<int>(index);
      }
      const Eigen::RowVector3i texture = first_uv < 0
                                             ? Eigen::RowVector3i(-1, -1, -1)
                                             : Eigen::RowVector3i(corners.array() + first_uv);
      triangles_.add(corners.array() + first, texture, material);
    }
  }

  void add_vertices(const aiMesh& mesh, const Eigen::Matrix4d& place) {
    const bool still = place.isIdentity(0);
    const bool coloured = mesh.HasVertexColors(0);
    any_coloured_ |= coloured;
    const Eigen::Vector3d plain_colour = mesh.mMaterialIndex < scene_.mNumMaterials
                                             ? scan_.materials[mesh.mMaterialIndex].diffuse
                                             : Eigen::Vector3d::Constant(0.8);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      Eigen::Vector3d x(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z);
      if (!still) x = place.topLeftCorner<3, 3>() * x + place.topRightCorner<3, 1>();
      if (!x.allFinite()) {
        throw ScanFailure{"",
                          "vertex " + std::to_string(vertices_.size() / 3) +
                              " has a coordinate that is not a finite number",
                          "the file is damaged: export the scan again"};
      }
      vertices_.insert(vertices_.end(), x.begin(), x.end());
      Eigen::Vector3d c = plain_colour;
      if (coloured) {
        const aiColor4D& from = mesh.mColors[0][v];
        c = {colour(from.r), colour(from.g), colour(from.b)};
      }
      colours_.insert(colours_.end(), c.begin(), c.end());
    }
  }

  /// The row of the first of the mesh's, −1: none.
  int add_texture_coordinates(const aiMesh& mesh) {
    const unsigned set = mesh.mMaterialIndex < uv_set_.size() ? uv_set_[mesh.mMaterialIndex] : 0;
    if (!mesh.HasTextureCoords(set)) return -1;
    const auto first = static_cast<int>(uv_.size() / 2);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      uv_.push_back(mesh.mTextureCoords[set][v].x);
      uv_.push_back(mesh.mTextureCoords[set][v].y);
    }
    return first;
  }

  void take_numbers() {
    const auto rows = [](const std::vector<double>& v, int columns) {
      return static_cast<Eigen::Index>(v.size()) / columns;
    };
    scan_.surface.vertices = Eigen::Map<const Points>(vertices_.data(), rows(vertices_, 3), 3);
    if (any_coloured_)
      scan_.colours = Eigen::Map<const Points>(colours_.data(), rows(colours_, 3), 3);
    scan_.texture_coordinates =
        Eigen::Map<const decltype(scan_.texture_coordinates)>(uv_.data(), rows(uv_, 2), 2);
  }

  fs::path file_;
  const aiScene& scene_;
  std::string extension_;
  RawScan scan_;
  TriangleList triangles_;
  std::vector<double> vertices_, colours_, uv_;
  std::vector<unsigned> uv_set_;  ///< that each material's picture uses
  std::vector<std::string> texture_names_;
  bool any_coloured_ = false;
};

}  // namespace

RawScan read_by_assimp(const fs::path& file) {
  Assimp::Importer importer;
  auto* files = new FilesOfFolder(file);  // NOLINT: the importer owns it
  importer.SetIOHandler(files);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  auto* complaints = new Complaints;  // NOLINT: the logger owns it
  Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
  Assimp::DefaultLogger::get()->attachStream(complaints,
                                             Assimp::Logger::Warn | Assimp::Logger::Err);
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_ValidateDataStructure);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    if (!files->refused().empty()) {
      throw ScanFailure{files->refused(),
                        "the scan names this file, which does not exist in its own folder",
                        "put the file beside the scan, or export it as one file"};
    }
    throw ScanFailure{"", "it cannot be read: " + plain(importer.GetErrorString()),
                      "export the scan again, or in another format"};
  }
  if (complaints->damaged()) {
    throw ScanFailure{"", "a face of it names a vertex that does not exist",
                      "the file is damaged: export the scan again"};
  }
  return SceneReader(file, *scene).read();
}

}  // namespace gnathion
