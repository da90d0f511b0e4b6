#include "imaging/head_mask.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gnathion {
namespace {

constexpr double grid_step = 2;        // mm; finer than any support part that matters
constexpr float not_scanned = -32768;  // below every HU: beyond the volume
constexpr float bone_hu = 300;
constexpr double farthest_thin_part = 28;  // mm; an ear stands off by less
constexpr double widest_thin_part = 90;    // mm; an ear is smaller
constexpr double kept_of_shell = 8;        // mm; what a shell hides of the head's own surface

/// y (LPS mm, posterior) behind which only 2 % of the densest bone lies.
double back_of_skull(const std::vector<float>& hu, const VoxelGrid& grid) {
  for (const float level : {700.0F, bone_hu}) {
    std::vector<std::size_t> count(static_cast<std::size_t>(grid.dims.y()), 0);
    std::size_t all = 0;
    for (std::size_t i = 0; i < hu.size(); ++i) {
      if (hu[i] < level) continue;
      ++count[static_cast<std::size_t>(grid.at(i).y())];
      ++all;
    }
    if (all < 1000) continue;
    std::size_t behind = 0;
    int y = grid.dims.y();
    while (y > 0 && 50 * behind < all) behind += count[static_cast<std::size_t>(--y)];
    return grid.origin.y() + grid.step * y;
  }
  return std::numeric_limits<double>::infinity();
}

/// Flags, one a column (x, y): solid in nine of ten slices.
Mask solid_columns(const std::vector<float>& hu, const VoxelGrid& grid, double level) {
  const std::size_t slice = static_cast<std::size_t>(grid.dims.x()) * grid.dims.y();
  std::vector<int> solid(slice, 0), scanned(slice, 0);
  for (std::size_t i = 0; i < hu.size(); ++i) {
    scanned[i % slice] += hu[i] > not_scanned;
    solid[i % slice] += hu[i] >= level;
  }
  const int most = *std::max_element(scanned.begin(), scanned.end());
  Mask columns(slice, 0);
  for (std::size_t i = 0; i < slice; ++i) {
    columns[i] = 2 * scanned[i] > most && 10 * solid[i] >= 9 * scanned[i];
  }
  return columns;
}

/// For each x the first y (voxels) that belongs to a couch; dims.y where there is none.
std::vector<int> couch_front(const std::vector<float>& hu, const VoxelGrid& grid, double level) {
  std::vector<int> front(static_cast<std::size_t>(grid.dims.x()), grid.dims.y());
  const double skull = back_of_skull(hu, grid);
  Mask columns = solid_columns(hu, grid, level);
  VoxelGrid flat = grid;
  flat.dims.z() = 1;
  for (std::size_t seed = 0; seed < columns.size(); ++seed) {
    const std::vector<std::size_t> part = flood(columns, flat, 1, 2, {seed});
    if (part.empty()) continue;
    Eigen::Array2i low(grid.dims.x(), grid.dims.y()), high(0, 0);
    double mean_y = 0;
    for (const std::size_t column : part) {
      const Eigen::Array2i p = flat.at(column).head<2>().array();
      low = low.min(p);
      high = high.max(p);
      mean_y += p.y();
    }
    mean_y = grid.origin.y() + grid.step * mean_y / static_cast<double>(part.size());
    const Eigen::Array2i extent = high - low + 1;
    const bool wide = extent.x() * grid.step > 60 && extent.x() > 2 * extent.y();
    if (!wide || mean_y < skull) continue;
    for (const std::size_t column : part) {
      const Eigen::Vector3i p = flat.at(column);
      int& first = front[static_cast<std::size_t>(p.x())];
      first = std::min(first, p.y());
    }
  }
  return front;
}

/// The thick body with the most bone, without its thin parts; also flags all other thick bodies.
Mask core_of(const Mask& body, const std::vector<float>& hu, const VoxelGrid& grid, int radius,
             Mask* other_cores) {
  Mask outside(body.size());
  std::transform(body.begin(), body.end(), outside.begin(), [](auto b) { return b != 1; });
  const Mask depth = squared_distances(outside, grid, radius);
  Mask thick(body.size());
  for (std::size_t i = 0; i < body.size(); ++i) thick[i] = depth[i] > radius * radius;
  std::vector<std::size_t> best;
  std::pair<std::size_t, std::size_t> most{0, 0};
  for (std::size_t seed = 0; seed < thick.size(); ++seed) {
    if (thick[seed] != 1) continue;
    std::vector<std::size_t> part = flood(thick, grid, 1, 2, {seed});
    const auto bone = static_cast<std::size_t>(
        std::count_if(part.begin(), part.end(), [&](auto i) { return hu[i] >= bone_hu; }));
    const std::pair score{bone, part.size()};
    if (score > most) {
      most = score;
      best = std::move(part);
    }
  }
  Mask core(body.size(), 0);
  for (const std::size_t i : best) core[i] = 1;
  for (std::size_t i = 0; i < body.size(); ++i) (*other_cores)[i] = thick[i] && !core[i];
  return core;
}

/// Adds to `head` the thin parts of `body` that belong to it: an ear wholly, of a shell or a strap
/// only what lies against the head.
void put_thin_parts_back(const Mask& body, const Mask& other_cores, const VoxelGrid& grid,
                         Mask& head) {
  Mask open(body.size());
  for (std::size_t i = 0; i < body.size(); ++i) open[i] = body[i] == 1 && !head[i];
  const int reach = static_cast<int>(farthest_thin_part / grid.step);
  const Mask distance = squared_distances(head, grid, reach);
  for (std::size_t seed = 0; seed < open.size(); ++seed) {
    if (open[seed] != 1) continue;
    const std::vector<std::size_t> part = flood(open, grid, 1, 2, {seed});
    bool touches = false, is_own = true;
    Eigen::Array3i low = grid.dims.array(), high = Eigen::Array3i::Zero();
    for (const std::size_t i : part) {
      touches = touches || distance[i] <= 1;
      is_own = is_own && distance[i] <= reach * reach && !other_cores[i];
      low = low.min(grid.at(i).array());
      high = high.max(grid.at(i).array());
    }
    if (!touches) continue;
    is_own = is_own && (high - low).maxCoeff() * grid.step < widest_thin_part;
    const int kept = is_own ? reach : static_cast<int>(kept_of_shell / grid.step);
    for (const std::size_t i : part) head[i] = distance[i] <= kept * kept;
  }
}

}  // namespace

std::uint8_t HeadMask::at(const Eigen::Vector3d& lps) const {
  const Eigen::Vector3i p =
      ((lps - grid.origin).array() / grid.step + 0.5).floor().cast<int>().matrix();
  const bool inside = (p.array() >= 0).all() && (p.array() < grid.dims.array()).all();
  return inside ? label[grid.index(p.x(), p.y(), p.z())] : static_cast<std::uint8_t>(air);
}

HeadMask find_head(const CtVolume& volume, double hu, double opening_radius, double couch_blur) {
  HeadMask mask;
  mask.grid = grid_over(bounds_of(volume), grid_step, 1);
  const VoxelGrid& grid = mask.grid;
  const std::vector<float> values = resampled(volume, grid, not_scanned);
  std::vector<int> front = couch_front(values, grid, hu);
  for (int& y : front) y -= static_cast<int>(std::lround(couch_blur / grid.step));
  Mask& label = mask.label;
  label.assign(grid.size(), HeadMask::air);
  for (std::size_t i = 0; i < label.size(); ++i) {
    const Eigen::Vector3i p = grid.at(i);
    if (p.y() >= front[static_cast<std::size_t>(p.x())]) {
      label[i] = HeadMask::support;
    } else if (values[i] >= hu) {
      label[i] = HeadMask::head;
    }
  }
  const int radius = std::clamp(static_cast<int>(std::lround(opening_radius / grid.step)), 1, 13);
  Mask other_cores(label.size());
  const Mask core = core_of(label, values, grid, radius, &other_cores);
  // One voxel more than the opening, so that the core's own rounded corners come back.
  const Mask distance = squared_distances(core, grid, radius + 1);
  Mask head(label.size());
  for (std::size_t i = 0; i < label.size(); ++i) {
    head[i] = label[i] == HeadMask::head && distance[i] <= (radius + 1) * (radius + 1);
  }
  put_thin_parts_back(label, other_cores, grid, head);
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (label[i] == HeadMask::head && !head[i]) label[i] = HeadMask::support;
  }
  return mask;
}

}  // namespace gnathion
