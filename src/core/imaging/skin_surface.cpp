#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/triangle_mesh.h"
#include "imaging/head_mask.h"
#include "imaging/surface_nets.h"
#include "imaging/surfaces.h"

namespace gnathion {
namespace {

constexpr float not_scanned = -32768;  // below every HU: beyond the volume
constexpr float air = -1000;
constexpr float solid = 300;  // HU above the level, inside what was filled
// mm; so near to a couch its blur reaches the skin's level, and would stand off the head as a rim.
constexpr double couch_blur = 4;
constexpr double edge_per_step = 0.925;  // of a relaxed surface net, as measured on heads

/// HU on a grid around the head, edited where the skin is to differ from the level surface.
struct SkinField {
  VoxelGrid grid;
  std::vector<float> hu;
  Mask edited;  ///< where the skin is not the scanned level surface
};

LpsBox box_of_head(const HeadMask& head) {
  LpsBox box{Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()),
             Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity())};
  for (std::size_t i = 0; i < head.label.size(); ++i) {
    if (head.label[i] != HeadMask::head) continue;
    const Eigen::Vector3d p = head.grid.lps(head.grid.at(i).cast<double>());
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  return box;
}

/// Sets what holds the head to air.
void drop_support(const HeadMask& head, SkinField& field) {
  const VoxelGrid& grid = field.grid;
  for (std::size_t i = 0; i < field.hu.size(); ++i) {
    if (field.hu[i] == not_scanned) continue;
    if (head.at(grid.lps(grid.at(i).cast<double>())) != HeadMask::support) continue;
    field.hu[i] = air;
    field.edited[i] = 1;
  }
}

/// Whether the flood of outer air may begin here: at the grid's border, or along the volume's
/// twelve edges. Not on its faces, which the neck and its airway may cross.
bool is_outermost(const CtVolume& volume, const VoxelGrid& grid, const Eigen::Vector3i& p) {
  if ((p.array() == 0).any() || (p.array() == grid.dims.array() - 1).any()) return true;
  const Eigen::Array3d ijk = volume.ijk(grid.lps(p.cast<double>())).array();
  const Eigen::Array3d last = (volume.dims().array() - 1).cast<double>();
  const Eigen::Array3d near = 1.01 * grid.step / volume.steps().array();
  return (ijk < near || ijk > last - near).count() >= 2;
}

/// Air that a ball of `radius` voxels can reach from around the head. Beyond the volume there is no
/// way: an airway that is cut where the scan ends would lead inside.
Mask outer_air(const CtVolume& volume, const SkinField& field, double level, int radius) {
  const VoxelGrid& grid = field.grid;
  Mask body(field.hu.size());
  for (std::size_t i = 0; i < body.size(); ++i) body[i] = field.hu[i] >= level;
  const Mask distance = squared_distances(body, grid, radius);
  Mask room(body.size());
  std::vector<std::size_t> seeds;
  for (std::size_t i = 0; i < room.size(); ++i) {
    room[i] = distance[i] > radius * radius && field.hu[i] > not_scanned;
    if (room[i] && is_outermost(volume, grid, grid.at(i))) seeds.push_back(i);
  }
  flood(room, grid, 1, 2, seeds);
  for (auto& r : room) r = r == 2;
  Mask outside = squared_distances(room, grid, radius);
  for (std::size_t i = 0; i < outside.size(); ++i) {
    outside[i] = (outside[i] <= radius * radius && !body[i]) || field.hu[i] == not_scanned;
  }
  return outside;
}

/// Fills what the outer air does not reach, and keeps the largest body.
void fill_inside(const Mask& outside, double level, SkinField& field) {
  Mask inside(outside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) inside[i] = !outside[i];
  std::vector<std::size_t> largest;
  for (std::size_t seed = 0; seed < inside.size(); ++seed) {
    if (inside[seed] != 1) continue;
    std::vector<std::size_t> body = flood(inside, field.grid, 1, 2, {seed});
    if (body.size() > largest.size()) largest.swap(body);
  }
  for (const std::size_t i : largest) inside[i] = 3;
  const auto filled = static_cast<float>(level) + solid;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    float& hu = field.hu[i];
    if (hu == not_scanned) {
      hu = air;
    } else if (inside[i] == 3 && hu < level) {
      hu = filled;
      field.edited[i] = 1;
    } else if (inside[i] == 2) {
      hu = air;
      field.edited[i] = 1;
    }
  }
}

/// Rounds the steps of edited places by three passes of the kernel (1 2 1)/4 along each axis.
/// Everywhere else the field stays as it was scanned.
void smooth_edited(double level, SkinField& field) {
  const VoxelGrid& grid = field.grid;
  const Mask near = squared_distances(field.edited, grid, 2);
  const auto low = static_cast<float>(level) - solid, high = static_cast<float>(level) + solid;
  std::vector<float> from(field.hu.size());
  std::transform(field.hu.begin(), field.hu.end(), from.begin(),
                 [&](float v) { return std::clamp(v, low, high); });
  std::vector<float> to = from;
  const std::size_t width = static_cast<std::size_t>(grid.dims.x());
  const std::size_t slice = width * static_cast<std::size_t>(grid.dims.y());
  for (int pass = 0; pass < 3; ++pass) {
    for (const std::size_t step : {std::size_t{1}, width, slice}) {
      for (std::size_t i = step; i + step < from.size(); ++i) {
        if (near[i] <= 4) to[i] = (from[i - step] + 2 * from[i] + from[i + step]) / 4;
      }
      from = to;
    }
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    field.edited[i] = near[i] <= 4;
    if (field.edited[i]) field.hu[i] = from[i];
  }
}

/// Moves the vertices from the coarse field's level onto the scan's own, along its gradient, by at
/// most half a grid step; edited places stay.
void project_onto_scan(const CtVolume& volume, double level, const SkinField& field,
                       TriangleMesh& mesh) {
  const VoxelGrid& grid = field.grid;
  constexpr double h = 0.5;  // mm; half the spacing of a fine CT
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    const Eigen::Vector3d start = mesh.vertices.row(v);
    const Eigen::Vector3i cell =
        ((start - grid.origin).array() / grid.step + 0.5).floor().cast<int>().matrix();
    if (field.edited[grid.index(cell.x(), cell.y(), cell.z())]) continue;
    Eigen::Vector3d p = start;
    for (int step = 0; step < 4; ++step) {
      Eigen::Vector3d slope;
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d d = h * Eigen::Vector3d::Unit(axis);
        slope[axis] = (volume.sample(p + d) - volume.sample(p - d)) / (2 * h);
      }
      const double off = level - volume.sample(p);
      if (std::abs(off) < 1 || slope.norm() < 10) break;
      const Eigen::Vector3d move = off / slope.squaredNorm() * slope;
      p += move * std::min(1.0, 0.25 * grid.step / move.norm());
    }
    const bool close = (p - start).norm() <= 0.5 * grid.step;
    if (close && std::abs(volume.sample(p) - level) < 20) mesh.vertices.row(v) = p;
  }
}

TriangleMesh largest_component(const TriangleMesh& mesh) {
  const std::vector<int> component = triangle_components(mesh);
  std::vector<std::size_t> count;
  for (const int c : component) {
    if (static_cast<std::size_t>(c) >= count.size()) count.resize(static_cast<std::size_t>(c) + 1);
    ++count[static_cast<std::size_t>(c)];
  }
  const auto largest = std::max_element(count.begin(), count.end()) - count.begin();
  std::vector<bool> keep(component.size());
  std::transform(component.begin(), component.end(), keep.begin(),
                 [largest](int c) { return c == largest; });
  return sub_mesh(mesh, keep).mesh;
}

void check_options(const SkinSurfaceOptions& options) {
  if (options.edge_mm >= 0.5 && options.edge_mm <= 10) return;
  throw Error(ErrorKind::usage, "skin edge length",
              std::to_string(options.edge_mm) + " mm is outside 0.5 to 10 mm", "give about 2 mm");
}

}  // namespace

TriangleMesh skin_surface(const CtVolume& volume, const SkinSurfaceOptions& options,
                          Progress& progress) {
  const auto stage = progress.stage("skin surface");
  check_options(options);
  const CtVolume part = options.crop ? cropped(volume, *options.crop) : volume;
  SkinField field;
  HeadMask head;
  LpsBox box = bounds_of(part);
  if (options.remove_support) {
    head = find_head(part, options.hu, options.opening_radius_mm, couch_blur);
    box = box_of_head(head);
  }
  progress.check();
  const double step = options.edge_mm / edge_per_step;
  const int closing =
      std::clamp(static_cast<int>(std::lround(options.closing_radius_mm / step)), 1, 14);
  const bool empty = !(box.min.array() <= box.max.array()).all();
  if (!empty) {
    field.grid = grid_over(box, step, closing + 3);
    field.hu = resampled(part, field.grid, not_scanned);
    field.edited.assign(field.hu.size(), 0);
    if (options.remove_support) drop_support(head, field);
    progress.check();
    fill_inside(outer_air(part, field, options.hu, closing), options.hu, field);
    smooth_edited(options.hu, field);
    const auto level = static_cast<float>(options.hu);
    make_well_composed(field.hu, field.grid, level);
    progress.check();
    const TriangleMesh net = surface_nets(field.hu, field.grid, level, 10);
    if (net.triangles.rows() > 0) {
      TriangleMesh skin = largest_component(net);
      project_onto_scan(part, options.hu, field, skin);
      return skin;
    }
  }
  throw Error(ErrorKind::anatomy, volume.source(),
              "holds no skin at " + std::to_string(std::lround(options.hu)) + " HU",
              "choose another HU level, or another CT");
}

}  // namespace gnathion
