#include "imaging/surfaces.h"

#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geometry/triangle_mesh.h"
#include "imaging/head_mask.h"

namespace gnathion {
namespace {

constexpr double support_hu = -300;    // what counts as a body when the head is looked for
constexpr double support_opening = 6;  // mm
constexpr std::int16_t air = -1024;

[[noreturn]] void nothing_at(const CtVolume& volume, const std::string& what, double hu) {
  throw Error(ErrorKind::anatomy, volume.source(),
              "holds no " + what + " at " + std::to_string(std::lround(hu)) + " HU",
              "choose another HU level, or another CT");
}

/// The volume's voxels with a border of air, only where something reaches the level.
struct PaddedBlock {
  vtkNew<vtkImageData> image;
  Eigen::Vector3d first;  ///< ijk of the image's origin
};

/// First and last index along each axis of the voxels that reach the level; last < first: none do.
std::pair<Eigen::Array3i, Eigen::Array3i> occupied(const CtVolume& volume, double hu) {
  Eigen::Array3i low = volume.dims().array(), high = Eigen::Array3i::Constant(-1);
  for (int k = 0; k < volume.dims().z(); ++k) {
    for (int j = 0; j < volume.dims().y(); ++j) {
      const std::int16_t* row = volume.hu().data() + volume.index(0, j, k);
      const std::int16_t* end = row + volume.dims().x();
      const auto solid = [hu](std::int16_t v) { return v >= hu; };
      const std::int16_t* left = std::find_if(row, end, solid);
      if (left == end) continue;
      const std::int16_t* right = end - 1;
      while (!solid(*right)) --right;
      low = low.min(Eigen::Array3i(static_cast<int>(left - row), j, k));
      high = high.max(Eigen::Array3i(static_cast<int>(right - row), j, k));
    }
  }
  return {low, high};
}

/// Copies the voxels that reach the level and, where the volume goes on, one more on each side: the
/// surface lies between them, and its place needs both values. False when nothing reaches the
/// level.
bool fill_block(const CtVolume& volume, double hu, const HeadMask* head, PaddedBlock& block) {
  const auto [lowest, highest] = occupied(volume, hu);
  if ((highest < lowest).any()) return false;
  const Eigen::Array3i low = (lowest - 1).max(0);
  const Eigen::Array3i high = (highest + 1).min(volume.dims().array() - 1);
  const Eigen::Array3i size = high - low + 3;
  block.first = (low - 1).cast<double>();
  block.image->SetDimensions(size.x(), size.y(), size.z());
  block.image->AllocateScalars(VTK_SHORT, 1);
  auto* out = static_cast<std::int16_t*>(block.image->GetScalarPointer());
  std::fill(out, out + size.cast<std::ptrdiff_t>().prod(), air);
  for (int k = low.z(); k <= high.z(); ++k) {
    for (int j = low.y(); j <= high.y(); ++j) {
      const std::int16_t* row = volume.hu().data() + volume.index(0, j, k);
      const std::ptrdiff_t line =
          (k - low.z() + 1) * static_cast<std::ptrdiff_t>(size.y()) + j - low.y() + 1;
      std::int16_t* to = out + line * size.x() + 1;
      for (int i = low.x(); i <= high.x(); ++i, ++to) {
        const bool dropped = row[i] >= hu && head &&
                             head->at(volume.lps(Eigen::Vector3d(i, j, k))) == HeadMask::support;
        *to = dropped ? air : row[i];
      }
    }
  }
  return true;
}

TriangleMesh contour(const CtVolume& volume, double hu, const HeadMask* head) {
  PaddedBlock block;
  if (!fill_block(volume, hu, head, block)) return {};
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(block.image);
  // Half way between two whole HU no voxel equals the level, which would make triangles without
  // area; voxels of just `hu` are inside.
  edges->SetValue(0, std::ceil(hu) - 0.5);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  edges->InterpolateAttributesOff();
  edges->Update();
  vtkPolyData* surface = edges->GetOutput();

  TriangleMesh mesh;
  mesh.vertices.resize(surface->GetNumberOfPoints(), 3);
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    Eigen::Vector3d p;
    surface->GetPoint(v, p.data());
    mesh.vertices.row(v) = volume.lps(p + block.first);
  }
  // Flying edges makes the normal point to lower values in the grid's own handedness.
  const bool mirrored = volume.lps_from_ijk().topLeftCorner<3, 3>().determinant() < 0;
  mesh.triangles.resize(surface->GetNumberOfPolys(), 3);
  vtkCellArray* polys = surface->GetPolys();
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polys->GetCellAtId(t, count, ids);
    mesh.triangles.row(t) << static_cast<int>(ids[0]), static_cast<int>(ids[mirrored ? 2 : 1]),
        static_cast<int>(ids[mirrored ? 1 : 2]);
  }
  return mesh;
}

struct Component {
  double volume = 0;                                      // mm³, negative for a hollow
  Eigen::Vector3d inner_point = Eigen::Vector3d::Zero();  // any point of its surface
};

std::vector<Component> measured(const TriangleMesh& mesh, const std::vector<int>& component) {
  const int count =
      component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + 1;
  std::vector<Component> all(static_cast<std::size_t>(count));
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(t, 0));
    const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(t, 1));
    const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(t, 2));
    Component& own = all[static_cast<std::size_t>(component[static_cast<std::size_t>(t)])];
    own.volume += a.dot(b.cross(c)) / 6;
    own.inner_point = a;
  }
  return all;
}

/// How often the ray from p along a direction off all axes crosses component `which`.
int crossings(const TriangleMesh& mesh, const std::vector<int>& component, int which,
              const Eigen::Vector3d& p) {
  const Eigen::Vector3d direction = Eigen::Vector3d(0.8017, 0.5345, 0.2673).normalized();
  int count = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    if (component[static_cast<std::size_t>(t)] != which) continue;
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(t, 0)).transpose() - p;
    const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(t, 1)).transpose() - p;
    const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(t, 2)).transpose() - p;
    const double u = direction.dot(a.cross(b)), v = direction.dot(b.cross(c)),
                 w = direction.dot(c.cross(a));
    const bool same_side = (u >= 0) == (v >= 0) && (v >= 0) == (w >= 0);
    if (same_side && (a.dot(b.cross(c)) >= 0) == (u + v + w >= 0)) ++count;
  }
  return count;
}

/// Keeps the pieces of at least the volume. Hollows go, and with them whatever lies inside one:
/// its hull is solid then.
TriangleMesh without_specks(const TriangleMesh& mesh, double minimum_volume) {
  const std::vector<int> component = triangle_components(mesh);
  const std::vector<Component> all = measured(mesh, component);
  std::vector<bool> kept(all.size());
  for (std::size_t c = 0; c < all.size(); ++c) kept[c] = all[c].volume >= minimum_volume;
  for (std::size_t c = 0; c < all.size(); ++c) {
    for (std::size_t hull = 0; kept[c] && hull < all.size(); ++hull) {
      if (hull == c || !kept[hull] || all[hull].volume < all[c].volume) continue;
      if (crossings(mesh, component, static_cast<int>(hull), all[c].inner_point) % 2 == 1) {
        kept[c] = false;
      }
    }
  }
  std::vector<bool> keep(component.size());
  for (std::size_t t = 0; t < keep.size(); ++t) {
    keep[t] = kept[static_cast<std::size_t>(component[t])];
  }
  return sub_mesh(mesh, keep).mesh;
}

}  // namespace

TriangleMesh bone_surface(const CtVolume& volume, const BoneSurfaceOptions& options,
                          Progress& progress) {
  const auto stage = progress.stage("bone surface");
  const CtVolume part = options.crop ? cropped(volume, *options.crop) : volume;
  HeadMask head;
  if (options.remove_support) head = find_head(part, support_hu, support_opening, 0);
  progress.check();
  const TriangleMesh all = contour(part, options.hu, options.remove_support ? &head : nullptr);
  progress.check();
  TriangleMesh bone = without_specks(all, options.minimum_component_volume);
  if (bone.triangles.rows() == 0) nothing_at(volume, "bone", options.hu);
  return bone;
}

}  // namespace gnathion
