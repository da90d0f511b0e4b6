#include "registration/surface_sample.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <unordered_set>

#include "geometry/triangle_mesh.h"
#include "registration/point_grid.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;

/// Neighbours of the vertices, each as often as triangles tell of it, in one block.
struct Rings {
  std::vector<int> begin;  ///< n+1
  std::vector<int> neighbour;
};

Rings rings_of(const TriangleMesh& mesh) {
  Rings rings;
  rings.begin.assign(static_cast<std::size_t>(mesh.vertices.rows()) + 1, 0);
  for (const int v : mesh.triangles.reshaped()) rings.begin[static_cast<std::size_t>(v) + 1] += 2;
  std::partial_sum(rings.begin.begin(), rings.begin.end(), rings.begin.begin());
  rings.neighbour.resize(static_cast<std::size_t>(rings.begin.back()));
  std::vector<int> at(rings.begin.begin(), rings.begin.end() - 1);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    for (int c = 0; c < 3; ++c) {
      int& place = at[static_cast<std::size_t>(mesh.triangles(f, c))];
      rings.neighbour[static_cast<std::size_t>(place++)] = mesh.triangles(f, (c + 1) % 3);
      rings.neighbour[static_cast<std::size_t>(place++)] = mesh.triangles(f, (c + 2) % 3);
    }
  }
  return rings;
}

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

namespace {

/// Whether the vertex stands off from those of its neighbours that are left. values: room to work.
bool is_spike(const TriangleMesh& mesh, const Rings& rings, std::size_t v,
              const std::vector<bool>& left, std::vector<int>& ring, std::vector<double>& values) {
  ring.clear();
  for (int n = rings.begin[v]; n < rings.begin[v + 1]; ++n) {
    const int neighbour = rings.neighbour[static_cast<std::size_t>(n)];
    if (left[static_cast<std::size_t>(neighbour)]) ring.push_back(neighbour);
  }
  if (ring.size() < 4) return true;  // each is told of twice: fewer than two neighbours or so
  Vector3d middle;
  for (int axis = 0; axis < 3; ++axis) {
    values.clear();
    for (const int n : ring) values.push_back(mesh.vertices(n, axis));
    middle[axis] = median_of(values);
  }
  values.clear();
  for (const int n : ring) values.push_back((mesh.vertices.row(n).transpose() - middle).norm());
  const double away = (mesh.vertices.row(static_cast<Eigen::Index>(v)).transpose() - middle).norm();
  return away > 2 * median_of(values);
}

}  // namespace

std::vector<bool> without_spikes(const TriangleMesh& mesh) {
  constexpr int kPasses = 3;  // spikes side by side hide each other
  const Rings rings = rings_of(mesh);
  std::vector<bool> left(static_cast<std::size_t>(mesh.vertices.rows()), true);
  std::vector<double> values;
  std::vector<int> ring;
  for (int pass = 0; pass < kPasses; ++pass) {
    std::vector<bool> next = left;
    for (std::size_t v = 0; v < left.size(); ++v) {
      next[v] = left[v] && !is_spike(mesh, rings, v, left, ring, values);
    }
    left.swap(next);
  }
  return left;
}

SampledSurface::SampledSurface(const TriangleMesh& mesh, const std::vector<bool>& use) {
  const std::vector<bool> keep = without_spikes(mesh);
  std::vector<int> row(keep.size(), -1);
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (!keep[v]) continue;
    row[v] = static_cast<int>(vertex_.size());
    vertex_.push_back(static_cast<int>(v));
    if (use.empty() || use[v]) usable_.push_back(row[v]);
  }
  points_.resize(static_cast<Eigen::Index>(vertex_.size()), 3);
  for (std::size_t i = 0; i < vertex_.size(); ++i) {
    points_.row(static_cast<Eigen::Index>(i)) = mesh.vertices.row(vertex_[i]);
  }
  normals_ = Points::Zero(points_.rows(), 3);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Eigen::Vector3i t(row[static_cast<std::size_t>(mesh.triangles(f, 0))],
                            row[static_cast<std::size_t>(mesh.triangles(f, 1))],
                            row[static_cast<std::size_t>(mesh.triangles(f, 2))]);
    if (t.minCoeff() < 0) continue;
    const Vector3d a = points_.row(t[0]), b = points_.row(t[1]), c = points_.row(t[2]);
    const Vector3d twice = (b - a).cross(c - a);
    area_ += twice.norm() / 2;
    for (const int v : t) normals_.row(v) += twice.transpose();
  }
  for (Eigen::Index i = 0; i < normals_.rows(); ++i) normals_.row(i).stableNormalize();
  std::shuffle(usable_.begin(), usable_.end(), std::mt19937(1));
}

std::vector<int> SampledSurface::thinned(double spacing) const {
  std::unordered_set<std::uint64_t> taken;
  std::vector<int> rows;
  for (const int i : usable_) {
    const Eigen::Array3d cell = (points_.row(i).transpose().array() / spacing).floor();
    std::uint64_t key = 0;
    for (const double along : cell) {
      key = (key << 21) | (static_cast<std::uint64_t>(static_cast<std::int64_t>(along)) & 0x1fffff);
    }
    if (taken.insert(key).second) rows.push_back(i);
  }
  return rows;
}

SurfaceSample SampledSurface::sample(double spacing, double smoothing) const {
  const std::vector<int> rows = thinned(spacing);
  const PointGrid near(points_, smoothing);
  SurfaceSample s;
  s.spacing = spacing;
  s.points.resize(static_cast<Eigen::Index>(rows.size()), 3);
  s.normals.resize(s.points.rows(), 3);
  Eigen::Index kept = 0;
  for (const int i : rows) {
    Vector3d sum = Vector3d::Zero();
    int count = 0;
    near.for_each_within(points_.row(i), smoothing, [&](int j) {
      sum += normals_.row(j).transpose();
      ++count;
    });
    // Where the normals about a point do not agree, it lies on no surface.
    if (sum.norm() < 0.4 * count || count < 2) continue;
    s.points.row(kept) = points_.row(i);
    s.normals.row(kept++) = sum.normalized().transpose();
    s.vertex.push_back(vertex_[static_cast<std::size_t>(i)]);
  }
  s.points.conservativeResize(kept, 3);
  s.normals.conservativeResize(kept, 3);
  if (kept > 0) {
    s.area = area_ * static_cast<double>(usable_.size()) / static_cast<double>(points_.rows()) /
             static_cast<double>(kept);
  }
  return s;
}

SurfaceSample SampledSurface::sample_of(Eigen::Index most, double smoothing) const {
  double spacing = std::sqrt(area_ / static_cast<double>(most)) / 2;
  while (static_cast<Eigen::Index>(thinned(spacing).size()) > most) spacing *= 1.15;
  return sample(spacing, smoothing);
}

}  // namespace gnathion
