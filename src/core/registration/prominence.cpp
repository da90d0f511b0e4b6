#include "registration/prominence.h"

#include <algorithm>

#include "registration/point_grid.h"

namespace gnathion {

using Eigen::Vector3d;

namespace {

constexpr double kBall = 22;   // mm
constexpr double kApart = 15;  // mm

}  // namespace

std::vector<Prominence> prominences(const SurfaceSample& s) {
  const PointGrid grid(s.points, kBall);
  std::vector<Prominence> all;
  for (Eigen::Index i = 0; i < s.size(); ++i) {
    const Vector3d p = s.points.row(i);
    Vector3d normals = Vector3d::Zero(), mean = Vector3d::Zero();
    int count = 0;
    grid.for_each_within(p, kBall, [&](int j) {
      normals += s.normals.row(j).transpose();
      mean += s.points.row(j).transpose();
      ++count;
    });
    if (count < 8 || normals.norm() < 1e-6) continue;
    const Vector3d facing = normals.normalized();
    all.push_back({p, facing, facing.dot(p - mean / count) / kBall});
  }
  return all;
}

std::vector<Prominence> highest(std::vector<Prominence> all, std::size_t most) {
  std::sort(all.begin(), all.end(),
            [](const Prominence& a, const Prominence& b) { return a.height > b.height; });
  std::vector<Prominence> chosen;
  for (const Prominence& p : all) {
    if (chosen.size() == most) break;
    const bool near = std::any_of(chosen.begin(), chosen.end(), [&](const Prominence& other) {
      return (other.at - p.at).norm() < kApart;
    });
    if (!near) chosen.push_back(p);
  }
  return chosen;
}

}  // namespace gnathion
