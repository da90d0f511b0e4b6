#include "imaging/voxel_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gnathion {
namespace {

/// lower[i] = min over |d| ≤ radius of values[i + d] + d², along one line of the grid.
void minimum_along(const std::uint8_t* values, std::ptrdiff_t stride, int count, int radius,
                   std::uint8_t limit, std::vector<std::uint8_t>& line, std::uint8_t* out) {
  line.assign(static_cast<std::size_t>(count) + 2 * radius, limit);
  for (int i = 0; i < count; ++i) {
    line[static_cast<std::size_t>(i) + radius] = values[i * stride];
  }
  for (int i = 0; i < count; ++i) {
    int best = limit;
    for (int d = -radius; d <= radius; ++d) {
      best = std::min(best, line[static_cast<std::size_t>(i + radius + d)] + d * d);
    }
    out[i * stride] = static_cast<std::uint8_t>(best);
  }
}

/// Combines whole rows, which the compiler can do many at a time.
void minimum_across(const Mask& in, Mask& out, const VoxelGrid& grid, int axis, int radius,
                    std::uint8_t limit) {
  const int rows = grid.dims.y(), slices = grid.dims.z(), width = grid.dims.x();
  for (int z = 0; z < slices; ++z) {
    for (int y = 0; y < rows; ++y) {
      std::uint8_t* to = out.data() + grid.index(0, y, z);
      std::fill(to, to + width, limit);
      for (int d = -radius; d <= radius; ++d) {
        const int sy = axis == 1 ? y + d : y;
        const int sz = axis == 2 ? z + d : z;
        if (sy < 0 || sy >= rows || sz < 0 || sz >= slices) continue;
        const std::uint8_t* from = in.data() + grid.index(0, sy, sz);
        const int add = d * d;
        for (int x = 0; x < width; ++x) {
          to[x] = static_cast<std::uint8_t>(std::min<int>(to[x], from[x] + add));
        }
      }
    }
  }
}

}  // namespace

Eigen::Vector3i VoxelGrid::at(std::size_t index) const {
  const auto width = static_cast<std::size_t>(dims.x());
  const auto height = static_cast<std::size_t>(dims.y());
  return {static_cast<int>(index % width), static_cast<int>(index / width % height),
          static_cast<int>(index / width / height)};
}

VoxelGrid grid_over(const LpsBox& box, double step, int margin) {
  VoxelGrid grid;
  grid.step = step;
  grid.origin = box.min - Eigen::Vector3d::Constant(margin * step);
  grid.dims = ((box.max - box.min).array() / step).ceil().cast<int>() + (2 * margin + 1);
  return grid;
}

LpsBox bounds_of(const CtVolume& volume) {
  LpsBox box{volume.lps(Eigen::Vector3d::Zero()), volume.lps(Eigen::Vector3d::Zero())};
  for (int corner = 1; corner < 8; ++corner) {
    const Eigen::Vector3d ijk((corner & 1) ? volume.dims().x() - 1 : 0,
                              (corner & 2) ? volume.dims().y() - 1 : 0,
                              (corner & 4) ? volume.dims().z() - 1 : 0);
    box.min = box.min.cwiseMin(volume.lps(ijk));
    box.max = box.max.cwiseMax(volume.lps(ijk));
  }
  return box;
}

std::vector<float> resampled(const CtVolume& volume, const VoxelGrid& grid, float outside) {
  std::vector<float> values(grid.size(), outside);
  const Eigen::Vector3d step = volume.ijk_from_lps().block<3, 1>(0, 0) * grid.step;
  const std::int16_t* hu = volume.hu().data();
  const Eigen::Vector3i& dims = volume.dims();
  const auto row = static_cast<std::ptrdiff_t>(dims.x());
  const auto slice = row * dims.y();
  const Eigen::Vector3d last = (dims.array() - 1).cast<double>();
  for (int z = 0; z < grid.dims.z(); ++z) {
    for (int y = 0; y < grid.dims.y(); ++y) {
      const Eigen::Vector3d begin = volume.ijk(grid.lps(Eigen::Vector3d(0, y, z)));
      float* out = values.data() + grid.index(0, y, z);
      for (int x = 0; x < grid.dims.x(); ++x) {
        const Eigen::Vector3d p = begin + x * step;
        if (!((p.array() >= 0).all() && (p.array() <= last.array()).all())) continue;
        const int i = std::min(static_cast<int>(p.x()), dims.x() - 2);
        const int j = std::min(static_cast<int>(p.y()), dims.y() - 2);
        const int k = std::min(static_cast<int>(p.z()), dims.z() - 2);
        const auto u = static_cast<float>(p.x() - i);
        const auto v = static_cast<float>(p.y() - j);
        const auto w = static_cast<float>(p.z() - k);
        const std::int16_t* c = hu + k * slice + j * row + i;
        const auto along_i = [u](const std::int16_t* a) {
          return static_cast<float>(a[0]) + u * static_cast<float>(a[1] - a[0]);
        };
        const float a = along_i(c), b = along_i(c + row);
        const float d = along_i(c + slice), e = along_i(c + slice + row);
        const float front = a + v * (b - a), back = d + v * (e - d);
        out[x] = front + w * (back - front);
      }
    }
  }
  return values;
}

Mask squared_distances(const Mask& mask, const VoxelGrid& grid, int radius) {
  const auto limit = static_cast<std::uint8_t>((radius + 1) * (radius + 1));
  Mask first(mask.size()), second(mask.size());
  for (std::size_t i = 0; i < mask.size(); ++i) first[i] = mask[i] ? 0 : limit;
  std::vector<std::uint8_t> line;
  for (int z = 0; z < grid.dims.z(); ++z) {
    for (int y = 0; y < grid.dims.y(); ++y) {
      const std::size_t begin = grid.index(0, y, z);
      minimum_along(first.data() + begin, 1, grid.dims.x(), radius, limit, line,
                    second.data() + begin);
    }
  }
  minimum_across(second, first, grid, 1, radius, limit);
  minimum_across(first, second, grid, 2, radius, limit);
  return second;
}

std::vector<std::size_t> flood(Mask& mask, const VoxelGrid& grid, std::uint8_t from,
                               std::uint8_t to, const std::vector<std::size_t>& seeds) {
  std::vector<std::size_t> reached;
  for (const std::size_t seed : seeds) {
    if (mask[seed] != from) continue;
    mask[seed] = to;
    reached.push_back(seed);
  }
  const auto width = static_cast<std::size_t>(grid.dims.x());
  const std::size_t slice = width * static_cast<std::size_t>(grid.dims.y());
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const std::size_t here = reached[next];
    const Eigen::Vector3i p = grid.at(here);
    const auto visit = [&](bool inside, std::size_t neighbour) {
      if (!inside || mask[neighbour] != from) return;
      mask[neighbour] = to;
      reached.push_back(neighbour);
    };
    visit(p.x() > 0, here - 1);
    visit(p.x() + 1 < grid.dims.x(), here + 1);
    visit(p.y() > 0, here - width);
    visit(p.y() + 1 < grid.dims.y(), here + width);
    visit(p.z() > 0, here - slice);
    visit(p.z() + 1 < grid.dims.z(), here + slice);
  }
  return reached;
}

}  // namespace gnathion
