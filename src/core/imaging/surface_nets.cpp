#include "imaging/surface_nets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

/// For each of the 256 ways in which a cell's corners (bit = x + 2y + 4z) are inside: whether both
/// its inside and its outside corners hang together along the cell's edges.
std::array<bool, 256> simple_cells() {
  const auto hangs_together = [](int corners) {
    if (corners == 0) return true;
    int reached = corners & -corners;
    for (int before = 0; before != reached;) {
      before = reached;
      for (int c = 0; c < 8; ++c) {
        if (!(reached >> c & 1)) continue;
        reached |= corners & (1 << (c ^ 1) | 1 << (c ^ 2) | 1 << (c ^ 4));
      }
    }
    return reached == corners;
  };
  std::array<bool, 256> simple{};
  for (int c = 0; c < 256; ++c) {
    simple[static_cast<std::size_t>(c)] = hangs_together(c) && hangs_together(~c & 255);
  }
  return simple;
}

std::array<std::size_t, 8> corner_offsets(const VoxelGrid& grid) {
  std::array<std::size_t, 8> offsets{};
  for (int c = 0; c < 8; ++c) {
    offsets[static_cast<std::size_t>(c)] = grid.index(c & 1, c >> 1 & 1, c >> 2 & 1);
  }
  return offsets;
}

/// The field between grid points, in units of the grid.
class Interpolated {
 public:
  Interpolated(const std::vector<float>& field, const VoxelGrid& grid)
      : field_(field), grid_(grid), offsets_(corner_offsets(grid)) {}

  double value(const Eigen::Vector3d& p, Eigen::Vector3d* gradient) const {
    const Eigen::Array3i limit = grid_.dims.array() - 2;
    const Eigen::Array3i cell = p.array().floor().cast<int>().max(0).min(limit);
    const Eigen::Array3d t = p.array() - cell.cast<double>();
    const float* f = field_.data() + grid_.index(cell.x(), cell.y(), cell.z());
    std::array<double, 8> v{};
    for (std::size_t c = 0; c < 8; ++c) v[c] = static_cast<double>(f[offsets_[c]]);
    const auto mix = [](double a, double b, double s) { return a + s * (b - a); };
    const double y0z0 = mix(v[0], v[1], t.x()), y1z0 = mix(v[2], v[3], t.x());
    const double y0z1 = mix(v[4], v[5], t.x()), y1z1 = mix(v[6], v[7], t.x());
    gradient->x() =
        mix(mix(v[1] - v[0], v[3] - v[2], t.y()), mix(v[5] - v[4], v[7] - v[6], t.y()), t.z());
    gradient->y() = mix(y1z0 - y0z0, y1z1 - y0z1, t.z());
    gradient->z() = mix(y0z1, y1z1, t.y()) - mix(y0z0, y1z0, t.y());
    return mix(mix(y0z0, y1z0, t.y()), mix(y0z1, y1z1, t.y()), t.z());
  }

 private:
  const std::vector<float>& field_;
  const VoxelGrid& grid_;
  std::array<std::size_t, 8> offsets_;
};

struct Net {
  std::vector<Eigen::Vector3d> points;    // in units of the grid
  std::vector<std::array<int, 4>> quads;  // outward
};

/// Mean of the points where the surface crosses the cell's twelve edges.
Eigen::Vector3d mean_crossing(const float* f, const std::array<std::size_t, 8>& offsets,
                              float level) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (int c = 0; c < 8; ++c) {
    for (int axis = 0; axis < 3; ++axis) {
      if (c >> axis & 1) continue;
      const float a = f[offsets[static_cast<std::size_t>(c)]] - level;
      const float b = f[offsets[static_cast<std::size_t>(c | 1 << axis)]] - level;
      if ((a >= 0) == (b >= 0)) continue;
      Eigen::Vector3d p(c & 1, c >> 1 & 1, c >> 2 & 1);
      p[axis] += static_cast<double>(a) / static_cast<double>(a - b);
      sum += p;
      ++count;
    }
  }
  return sum / count;
}

void add_quads(const std::vector<float>& field, const VoxelGrid& grid, float level,
               const std::vector<int>& vertex_of_cell, const Eigen::Vector3i& p, Net& net) {
  const std::size_t here = grid.index(p.x(), p.y(), p.z());
  const bool inside = field[here] >= level;
  const std::array<std::size_t, 3> step = {1, static_cast<std::size_t>(grid.dims.x()),
                                           grid.index(0, 0, 1)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = step[(axis + 1) % 3], v = step[(axis + 2) % 3];
    if (inside == (field[here + step[axis]] >= level)) continue;
    const auto at = [&](std::size_t cell) { return vertex_of_cell[cell]; };
    // Counter-clockwise around +axis: outward when the inside lies below.
    std::array<int, 4> quad = {at(here - u - v), at(here - v), at(here), at(here - u)};
    if (!inside) std::swap(quad[1], quad[3]);
    net.quads.push_back(quad);
  }
}

Net build_net(const std::vector<float>& field, const VoxelGrid& grid, float level) {
  Net net;
  const std::array<std::size_t, 8> offsets = corner_offsets(grid);
  std::vector<int> vertex_of_cell(grid.size(), -1);
  for (int z = 0; z + 1 < grid.dims.z(); ++z) {
    for (int y = 0; y + 1 < grid.dims.y(); ++y) {
      for (int x = 0; x + 1 < grid.dims.x(); ++x) {
        const std::size_t cell = grid.index(x, y, z);
        int inside = 0;
        for (const std::size_t offset : offsets) inside += field[cell + offset] >= level;
        if (inside == 0 || inside == 8) continue;
        vertex_of_cell[cell] = static_cast<int>(net.points.size());
        net.points.push_back(Eigen::Vector3d(x, y, z) +
                             mean_crossing(field.data() + cell, offsets, level));
      }
    }
  }
  for (int z = 1; z + 1 < grid.dims.z(); ++z) {
    for (int y = 1; y + 1 < grid.dims.y(); ++y) {
      for (int x = 1; x + 1 < grid.dims.x(); ++x) {
        add_quads(field, grid, level, vertex_of_cell, {x, y, z}, net);
      }
    }
  }
  return net;
}

std::vector<std::vector<int>> quad_neighbours(const Net& net) {
  std::vector<std::vector<int>> neighbours(net.points.size());
  for (const auto& quad : net.quads) {
    for (std::size_t c = 0; c < 4; ++c) {
      neighbours[static_cast<std::size_t>(quad[c])].push_back(quad[(c + 1) % 4]);
    }
  }
  return neighbours;
}

/// Back onto the level along the gradient; a step is at most a quarter cell.
Eigen::Vector3d projected(const Interpolated& field, Eigen::Vector3d p, double level) {
  Eigen::Vector3d gradient;
  for (int step = 0; step < 3; ++step) {
    const double off = level - field.value(p, &gradient);
    const double steepness = gradient.squaredNorm();
    if (steepness < 1) break;  // HU² a cell: no direction worth following
    Eigen::Vector3d move = off / steepness * gradient;
    if (move.norm() > 0.25) move *= 0.25 / move.norm();
    p += move;
    if (move.squaredNorm() < 1e-8) break;
  }
  return p;
}

void relax(const std::vector<float>& field, const VoxelGrid& grid, float level, int sweeps,
           Net& net) {
  const Interpolated interpolated(field, grid);
  const auto neighbours = quad_neighbours(net);
  std::vector<Eigen::Vector3d> next(net.points.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t v = 0; v < net.points.size(); ++v) {
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      for (const int n : neighbours[v]) centre += net.points[static_cast<std::size_t>(n)];
      centre /= static_cast<double>(neighbours[v].size());
      next[v] = projected(interpolated, 0.5 * (net.points[v] + centre), static_cast<double>(level));
    }
    net.points.swap(next);
  }
}

/// Smallest angle's cosine: the largest of the triangle's three.
double sharpest(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d u = (b - a).normalized(), v = (c - b).normalized(),
                        w = (a - c).normalized();
  return std::max({-w.dot(u), -u.dot(v), -v.dot(w)});
}

}  // namespace

int make_well_composed(std::vector<float>& field, const VoxelGrid& grid, float level) {
  static const std::array<bool, 256> simple = simple_cells();
  const std::array<std::size_t, 8> offsets = corner_offsets(grid);
  const float filled = level + 20;  // a little inside, so that the surface moves little
  int changed = 0;
  for (bool again = true; again;) {
    again = false;
    for (int z = 0; z + 1 < grid.dims.z(); ++z) {
      for (int y = 0; y + 1 < grid.dims.y(); ++y) {
        for (int x = 0; x + 1 < grid.dims.x(); ++x) {
          const std::size_t cell = grid.index(x, y, z);
          std::size_t inside = 0;
          for (std::size_t c = 0; c < 8; ++c) {
            inside |= static_cast<std::size_t>(field[cell + offsets[c]] >= level) << c;
          }
          if (simple[inside]) continue;
          // Fill the outside corner that is nearest to being inside.
          std::size_t best = 8;
          for (std::size_t c = 0; c < 8; ++c) {
            if (inside >> c & 1) continue;
            if (best == 8 || field[cell + offsets[c]] > field[cell + offsets[best]]) best = c;
          }
          field[cell + offsets[best]] = filled;
          ++changed;
          again = true;
        }
      }
    }
  }
  return changed;
}

TriangleMesh surface_nets(const std::vector<float>& field, const VoxelGrid& grid, float level,
                          int sweeps) {
  Net net = build_net(field, grid, level);
  relax(field, grid, level, sweeps, net);
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(net.points.size()), 3);
  for (std::size_t v = 0; v < net.points.size(); ++v) {
    mesh.vertices.row(static_cast<Eigen::Index>(v)) = grid.lps(net.points[v]);
  }
  mesh.triangles.resize(2 * static_cast<Eigen::Index>(net.quads.size()), 3);
  for (std::size_t q = 0; q < net.quads.size(); ++q) {
    const auto& [a, b, c, d] = net.quads[q];
    const auto p = [&](int v) -> const Eigen::Vector3d& {
      return net.points[static_cast<std::size_t>(v)];
    };
    const double along_ac = std::max(sharpest(p(a), p(b), p(c)), sharpest(p(a), p(c), p(d)));
    const double along_bd = std::max(sharpest(p(a), p(b), p(d)), sharpest(p(b), p(c), p(d)));
    const auto row = 2 * static_cast<Eigen::Index>(q);
    if (along_ac <= along_bd) {
      mesh.triangles.row(row) << a, b, c;
      mesh.triangles.row(row + 1) << a, c, d;
    } else {
      mesh.triangles.row(row) << a, b, d;
      mesh.triangles.row(row + 1) << b, c, d;
    }
  }
  return mesh;
}

}  // namespace gnathion
