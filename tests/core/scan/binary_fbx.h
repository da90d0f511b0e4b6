#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/scan/scan_files.h"

namespace gnathion::test {

/// A binary FBX of version 7400 (record: where it ends, how many properties, their bytes, a name;
/// then properties and nested records, which a record of zeros ends). Written here, since assimp
/// 5.2 writes binary FBX that nobody reads.
class BinaryFbx {
 public:
  static std::string text(const std::string& s) {
    return "S" + raw<std::uint32_t>({static_cast<std::uint32_t>(s.size())}) + s;
  }
  static std::string id(std::int64_t v) { return "L" + raw<std::int64_t>({v}); }
  static std::string number(std::int32_t v) { return "I" + raw<std::int32_t>({v}); }
  static std::string numbers(const std::vector<double>& v) { return "d" + array(v); }
  static std::string numbers(const std::vector<std::int32_t>& v) { return "i" + array(v); }
  /// FBX's names: with the kind of thing behind them.
  static std::string named(const std::string& name, const std::string& kind) {
    return text(name + std::string("\0\1", 2) + kind);
  }

  /// A record within those that are open.
  BinaryFbx& open(const std::string& name, const std::vector<std::string>& properties = {}) {
    begins_.push_back(bytes_.size());
    nested_.push_back(false);
    if (nested_.size() > 1) nested_[nested_.size() - 2] = true;
    std::string all;
    for (const std::string& property : properties) all += property;
    bytes_ += raw<std::uint32_t>(
        {0, static_cast<std::uint32_t>(properties.size()), static_cast<std::uint32_t>(all.size())});
    bytes_ += static_cast<char>(name.size()) + name + all;
    return *this;
  }
  BinaryFbx& close() {
    if (nested_.back()) bytes_ += std::string(13, '\0');
    bytes_.replace(begins_.back(), 4,
                   raw<std::uint32_t>({static_cast<std::uint32_t>(bytes_.size())}));
    begins_.pop_back();
    nested_.pop_back();
    return *this;
  }
  BinaryFbx& add(const std::string& name, const std::vector<std::string>& properties) {
    return open(name, properties).close();
  }
  std::string bytes() const { return bytes_ + std::string(13 + 160, '\0'); }

 private:
  template <typename T>
  static std::string array(const std::vector<T>& v) {
    const auto count = static_cast<std::uint32_t>(v.size());
    return raw<std::uint32_t>({count, 0, count * static_cast<std::uint32_t>(sizeof(T))}) + raw(v);
  }

  std::string bytes_ = std::string("Kaydara FBX Binary  \0\x1a\0", 23) + raw<std::uint32_t>({7400});
  std::vector<std::size_t> begins_;
  std::vector<bool> nested_;
};

/// Texture coordinates of the square's corners, and a material for each triangle.
inline void add_layers(BinaryFbx& fbx) {
  using F = BinaryFbx;
  fbx.open("LayerElementUV", {F::number(0)})
      .add("MappingInformationType", {F::text("ByPolygonVertex")})
      .add("ReferenceInformationType", {F::text("IndexToDirect")})
      .add("UV", {F::numbers(std::vector<double>{0, 0, 1, 0, 1, 1, 0.25, 1, 0, 0.5})})
      .add("UVIndex", {F::numbers(std::vector<std::int32_t>{0, 1, 2, 4, 2, 3})})
      .close();
  fbx.open("LayerElementMaterial", {F::number(0)})
      .add("MappingInformationType", {F::text("ByPolygon")})
      .add("ReferenceInformationType", {F::text("IndexToDirect")})
      .add("Materials", {F::numbers(std::vector<std::int32_t>{0, 1})})
      .close();
  fbx.open("Layer", {F::number(0)});
  for (const char* layer : {"LayerElementUV", "LayerElementMaterial"}) {
    fbx.open("LayerElement").add("Type", {F::text(layer)}).add("TypedIndex", {F::number(0)});
    fbx.close();
  }
  fbx.close();  // Layer
}

/// Two triangles with a seam between them and a material each, the first with a picture beside the
/// file: v 0 0 0, 1 0 0, 1 1 0, 0 1 0.5.
inline std::string square_as_binary_fbx(const std::string& picture) {
  using F = BinaryFbx;
  F fbx;
  fbx.open("FBXHeaderExtension").add("FBXVersion", {F::number(7400)}).close();
  fbx.open("Objects").open("Geometry", {F::id(1), F::named("face", "Geometry"), F::text("Mesh")});
  fbx.add("Vertices", {F::numbers(std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5})});
  fbx.add("PolygonVertexIndex", {F::numbers(std::vector<std::int32_t>{0, 1, -3, 0, 2, -4})});
  add_layers(fbx);
  fbx.close();  // Geometry
  fbx.open("Model", {F::id(2), F::named("face", "Model"), F::text("Mesh")})
      .add("Version", {F::number(232)})
      .close();
  for (const auto& [id, name] : {std::pair{3, "skin"}, {4, "lip"}}) {
    fbx.open("Material", {F::id(id), F::named(name, "Material"), F::text("")})
        .add("ShadingModel", {F::text("lambert")})
        .close();
  }
  fbx.open("Texture", {F::id(5), F::named("skin", "Texture"), F::text("")})
      .add("FileName", {F::text(picture)})
      .add("RelativeFilename", {F::text(picture)})
      .close();
  fbx.close().open("Connections");
  for (const auto& [from, to] : {std::pair{2, 0}, {1, 2}, {3, 2}, {4, 2}}) {
    fbx.add("C", {F::text("OO"), F::id(from), F::id(to)});
  }
  fbx.add("C", {F::text("OP"), F::id(5), F::id(3), F::text("DiffuseColor")}).close();
  return fbx.bytes();
}

}  // namespace gnathion::test
