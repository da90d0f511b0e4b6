#include "render/ready_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

#include "base/error.h"
#include "geometry/triangle_mesh.h"
#include "render/coarse_surface.h"
#include "render/split_surface.h"
#include "render/texture_image.h"
#include "render/vtk_surface.h"

namespace gnathion {
namespace {

const Eigen::Vector3d skin{0.86, 0.70, 0.61};

vtkSmartPointer<vtkFloatArray> float_array(const char* name, int components, std::size_t tuples) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

SurfaceArrays arrays_of(std::vector<int> vertex, const Triangles& triangles, const Points& points,
                        const Points& normals) {
  SurfaceArrays arrays;
  arrays.vertex = std::move(vertex);
  arrays.cells = cells_of(triangles);
  arrays.points = float_array("positions", 3, arrays.vertex.size());
  arrays.normals = float_array("normals", 3, arrays.vertex.size());
  copy_rows(points, arrays.vertex, arrays.points);
  copy_rows(normals, arrays.vertex, arrays.normals);
  return arrays;
}

/// Only the vertices that the triangles use.
SurfaceArrays used_arrays(const Points& points, const Points& normals, const Triangles& triangles) {
  std::vector<int> place(static_cast<std::size_t>(points.rows()), -1);
  std::vector<int> used;
  Triangles renumbered(triangles.rows(), 3);
  for (Eigen::Index i = 0; i < triangles.size(); ++i) {
    int& known = place[static_cast<std::size_t>(triangles.data()[i])];
    if (known < 0) {
      known = static_cast<int>(used.size());
      used.push_back(triangles.data()[i]);
    }
    renumbered.data()[i] = known;
  }
  return arrays_of(std::move(used), renumbered, points, normals);
}

/// Whether every edge is one of two triangles that run along it opposite ways, and the normals
/// point outward. An edge is told by its vertices; of a closed surface each is there once either
/// way, so that the ways cancel each other.
bool is_outward_closed(const TriangleMesh& mesh) {
  std::vector<std::uint64_t> ways[2];  // from the smaller vertex to the larger, and back
  for (auto& way : ways) way.reserve(static_cast<std::size_t>(mesh.triangles.rows()) * 3 / 2);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const int a = mesh.triangles(t, c), b = mesh.triangles(t, (c + 1) % 3);
      const auto [low, high] = std::minmax(a, b);
      ways[a < b ? 0 : 1].push_back(static_cast<std::uint64_t>(low) << 32U |
                                    static_cast<std::uint64_t>(high));
    }
  }
  if (ways[0].size() != ways[1].size()) return false;
  for (auto& way : ways) std::sort(way.begin(), way.end());
  return ways[0] == ways[1] && signed_volume(mesh) > 0;
}

vtkSmartPointer<vtkFloatArray> uv_array(const std::vector<Eigen::Vector2d>& uv) {
  if (uv.empty()) return nullptr;
  auto array = float_array("texture", 2, uv.size());
  for (std::size_t i = 0; i < uv.size(); ++i) {
    array->SetTuple2(static_cast<vtkIdType>(i), uv[i].x(), uv[i].y());
  }
  return array;
}

/// colours: n×3, 0..1, of the vertices that `vertex` names.
vtkSmartPointer<vtkUnsignedCharArray> colour_array(const Points& colours,
                                                   const std::vector<int>& vertex) {
  if (colours.rows() == 0) return nullptr;
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetName("paint");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(vertex.size()));
  unsigned char* out = array->GetPointer(0);
  for (const int row : vertex) {
    for (const double channel : colours.row(row)) {
      *out++ = static_cast<unsigned char>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
    }
  }
  return array;
}

/// What a part is shown with besides its shape.
struct PartLook {
  vtkSmartPointer<vtkImageData> texture;
  Eigen::Vector3d plain_colour = skin;
};

/// Reads each texture once.
class PartLooks {
 public:
  explicit PartLooks(const TexturedMesh& face) : face_(face) {}

  PartLook of(const SurfacePart& part) {
    if (part.material < 0) return {};
    const Material& material = face_.materials[static_cast<std::size_t>(part.material)];
    if (material.texture.empty()) return {nullptr, material.diffuse};
    if (part.uv.empty()) return {};
    vtkSmartPointer<vtkImageData>& image = images_[material.texture];
    if (!image) image = read_texture(material.texture);
    return {image, skin};
  }

 private:
  const TexturedMesh& face_;
  std::map<std::filesystem::path, vtkSmartPointer<vtkImageData>> images_;
};

ReadyFace::Part ready_part(SurfacePart part, const Points& points, const Points& normals,
                           const Points& colours, const PartLook& look) {
  ReadyFace::Part ready{arrays_of(std::move(part.face_vertex), part.triangles, points, normals),
                        look.texture, look.plain_colour};
  if (look.texture) ready.arrays.uv = uv_array(part.uv);
  ready.arrays.vertex_colours = colour_array(colours, ready.arrays.vertex);
  return ready;
}

/// The parts with fewer triangles; their vertices are numbered anew, as they are used.
std::vector<SurfacePart> coarse_parts(const std::vector<SurfacePart>& parts,
                                      const TriangleMesh& surface, std::vector<int>& used) {
  std::vector<int> place(static_cast<std::size_t>(surface.vertices.rows()), -1);
  std::vector<SurfacePart> coarse;
  for (const SurfacePart& part : parts) {
    const auto share =
        static_cast<int>(part.triangles.rows() * kQuickFace / surface.triangles.rows());
    coarse.push_back(coarse_part(part, surface.vertices, std::max(share, 1)));
    for (int& v : coarse.back().face_vertex) {
      int& known = place[static_cast<std::size_t>(v)];
      if (known < 0) {
        known = static_cast<int>(used.size());
        used.push_back(v);
      }
      v = known;
    }
  }
  return coarse;
}

/// All triangles of the parts, in terms of what their vertices are copies of.
Triangles joined(const std::vector<SurfacePart>& parts) {
  Eigen::Index count = 0;
  for (const SurfacePart& part : parts) count += part.triangles.rows();
  Triangles all(count, 3);
  Eigen::Index row = 0;
  for (const SurfacePart& part : parts) {
    for (Eigen::Index t = 0; t < part.triangles.rows(); ++t, ++row) {
      for (int c = 0; c < 3; ++c) {
        all(row, c) = part.face_vertex[static_cast<std::size_t>(part.triangles(t, c))];
      }
    }
  }
  return all;
}

void add_coarse(const std::vector<SurfacePart>& split, const std::vector<PartLook>& looks,
                const Points& vertex_colours, ReadyFace& face) {
  if (face.surface.triangles.rows() <= kQuickFace) return;
  std::vector<SurfacePart> parts = coarse_parts(split, face.surface, face.coarse_vertex);
  face.coarse_mesh = {face.surface.vertices(face.coarse_vertex, Eigen::all), joined(parts)};
  const Points normals = vertex_normals(face.coarse_mesh);
  Points colours;
  if (vertex_colours.rows() > 0) colours = vertex_colours(face.coarse_vertex, Eigen::all);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    face.coarse.push_back(
        ready_part(std::move(parts[p]), face.coarse_mesh.vertices, normals, colours, looks[p]));
  }
}

}  // namespace

void copy_rows(const Points& source, const std::vector<int>& row_of, vtkFloatArray* target) {
  float* out = target->GetPointer(0);
  for (const int row : row_of) {
    for (int k = 0; k < 3; ++k) *out++ = static_cast<float>(source(row, k));
  }
  target->Modified();
}

std::shared_ptr<const ReadyBone> ready_bone(const TriangleMesh& bone, const std::string& name,
                                            const Triangles& coarse) {
  check_surface(bone, name);
  if (coarse.rows() > 0) check_surface({bone.vertices, coarse}, name);
  auto ready = std::make_shared<ReadyBone>();
  const Points normals = vertex_normals(bone);
  ready->vertices = bone.vertices;
  ready->whole = used_arrays(bone.vertices, normals, bone.triangles);
  if (coarse.rows() > 0) ready->coarse = used_arrays(bone.vertices, normals, coarse);
  ready->is_outward_closed = is_outward_closed(bone);
  return ready;
}

std::shared_ptr<const ReadyFace> ready_face(const TexturedMesh& face, const std::string& name,
                                            const Points& vertex_colours) {
  check_face(face, name);
  if (vertex_colours.rows() != 0 && vertex_colours.rows() != face.surface.vertices.rows()) {
    throw Error(ErrorKind::input, name, "colours and vertices differ in number",
                "export the scan again");
  }
  auto ready = std::make_shared<ReadyFace>();
  ready->surface = face.surface;
  ready->is_outward_closed = is_outward_closed(face.surface);
  const Points normals = vertex_normals(face.surface);
  const std::vector<SurfacePart> split = split_by_corner(face);
  PartLooks reader(face);
  std::vector<PartLook> looks;
  for (const SurfacePart& part : split) {
    looks.push_back(reader.of(part));
    ready->whole.push_back(
        ready_part(part, face.surface.vertices, normals, vertex_colours, looks.back()));
  }
  add_coarse(split, looks, vertex_colours, *ready);
  return ready;
}

}  // namespace gnathion
