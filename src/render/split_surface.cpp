#include "render/split_surface.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <unordered_map>

#include "base/error.h"
#include "render/coarse_surface.h"

namespace gnathion {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& problem) {
  throw Error(ErrorKind::input, name, problem,
              "repair the mesh in a mesh editor and load it again");
}

bool is_textured(const TexturedMesh& face, Eigen::Index triangle) {
  const int material = face.triangle_material[static_cast<size_t>(triangle)];
  return material >= 0 && !face.materials[static_cast<size_t>(material)].texture.empty() &&
         face.corner_texture.row(triangle).minCoeff() >= 0;
}

/// Triangles of each part, in order of (material, textured).
std::map<std::pair<int, bool>, std::vector<Eigen::Index>> triangles_by_part(
    const TexturedMesh& face) {
  std::map<std::pair<int, bool>, std::vector<Eigen::Index>> parts;
  for (Eigen::Index t = 0; t < face.surface.triangles.rows(); ++t) {
    parts[{face.triangle_material[static_cast<size_t>(t)], is_textured(face, t)}].push_back(t);
  }
  return parts;
}

SurfacePart make_part(const TexturedMesh& face, int material, bool textured,
                      const std::vector<Eigen::Index>& triangles) {
  SurfacePart part;
  part.material = material;
  part.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  const auto width = static_cast<long long>(face.texture_coordinates.rows()) + 1;
  std::unordered_map<long long, int> known;
  for (Eigen::Index row = 0; row < part.triangles.rows(); ++row) {
    const Eigen::Index t = triangles[static_cast<size_t>(row)];
    for (int c = 0; c < 3; ++c) {
      const int vertex = face.surface.triangles(t, c);
      const int uv = textured ? face.corner_texture(t, c) : -1;
      const auto [found, is_new] =
          known.try_emplace(vertex * width + uv + 1, static_cast<int>(part.face_vertex.size()));
      if (is_new) {
        part.face_vertex.push_back(vertex);
        if (textured) part.uv.emplace_back(face.texture_coordinates.row(uv));
      }
      part.triangles(row, c) = found->second;
    }
  }
  return part;
}

}  // namespace

std::vector<SurfacePart> split_by_corner(const TexturedMesh& face) {
  std::vector<SurfacePart> parts;
  for (const auto& [key, triangles] : triangles_by_part(face)) {
    parts.push_back(make_part(face, key.first, key.second, triangles));
  }
  return parts;
}

namespace {

/// How many triangles meet at an edge, by its vertices, the smaller in the upper half of the key. A
/// photograph need not be a manifold.
std::unordered_map<std::uint64_t, int> triangles_at_edges(const Triangles& triangles) {
  std::unordered_map<std::uint64_t, int> count;
  count.reserve(static_cast<std::size_t>(triangles.rows()) * 2);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax(triangles(t, c), triangles(t, (c + 1) % 3));
      ++count[static_cast<std::uint64_t>(low) << 32U | static_cast<std::uint64_t>(high)];
    }
  }
  return count;
}

}  // namespace

SurfacePart coarse_part(const SurfacePart& part, const Points& vertices, int wanted) {
  const TriangleMesh surface{vertices(part.face_vertex, Eigen::all), part.triangles};
  std::vector<bool> border(part.face_vertex.size(), false);
  for (const auto& [edge, count] : triangles_at_edges(part.triangles)) {
    if (count == 2) continue;
    border[edge >> 32U] = border[edge & 0xffffffffU] = true;
  }
  const Triangles coarse = coarse_triangles(surface, wanted, border);
  SurfacePart result;
  result.material = part.material;
  result.triangles.resize(coarse.rows(), 3);
  std::vector<int> place(part.face_vertex.size(), -1);
  for (Eigen::Index i = 0; i < coarse.size(); ++i) {
    const auto v = static_cast<std::size_t>(coarse.data()[i]);
    if (place[v] < 0) {
      place[v] = static_cast<int>(result.face_vertex.size());
      result.face_vertex.push_back(part.face_vertex[v]);
      if (!part.uv.empty()) result.uv.push_back(part.uv[v]);
    }
    result.triangles.data()[i] = place[v];
  }
  return result;
}

void check_surface(const TriangleMesh& surface, const std::string& name) {
  if (surface.triangles.rows() == 0) refuse(name, "it has no triangles");
  if (!surface.vertices.allFinite()) {
    refuse(name, "a vertex coordinate is infinite or not a number");
  }
  if (surface.triangles.minCoeff() < 0 || surface.triangles.maxCoeff() >= surface.vertices.rows()) {
    refuse(name, "a triangle names a vertex that does not exist");
  }
}

void check_face(const TexturedMesh& face, const std::string& name) {
  check_surface(face.surface, name);
  const Eigen::Index count = face.surface.triangles.rows();
  if (face.corner_texture.rows() != count ||
      face.triangle_material.size() != static_cast<size_t>(count)) {
    refuse(name, "materials or texture corners do not match the number of triangles");
  }
  if (!face.texture_coordinates.allFinite()) {
    refuse(name, "a texture coordinate is infinite or not a number");
  }
  if (face.corner_texture.minCoeff() < -1 ||
      face.corner_texture.maxCoeff() >= face.texture_coordinates.rows()) {
    refuse(name, "a corner names a texture coordinate that does not exist");
  }
  for (const int material : face.triangle_material) {
    if (material < -1 || material >= static_cast<int>(face.materials.size())) {
      refuse(name, "a triangle names a material that does not exist");
    }
  }
}

}  // namespace gnathion
