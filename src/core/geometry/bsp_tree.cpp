#include "geometry/bsp_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace gnathion {
namespace {

constexpr int kLeafSize = 4;
constexpr int kMaxDepth = 64;  // medians halve the triangles: 2^31 of them need 31 levels
constexpr double kBorder = 1e-9;

/// Distance at which the ray enters the box, or infinity when it misses it within `reach`.
double entry(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& origin,
             const Eigen::Vector3d& direction, const Eigen::Vector3d& inverse, double reach) {
  constexpr double kMissed = std::numeric_limits<double>::infinity();
  const double slack = kBorder * (1 + reach);
  double near = 0;
  double far = reach;
  for (int axis = 0; axis < 3; ++axis) {
    const double to_min = box.min()[axis] - slack - origin[axis];
    const double to_max = box.max()[axis] + slack - origin[axis];
    if (direction[axis] == 0) {  // parallel to the faces: 0 · inf would be no number
      if (to_min > 0 || to_max < 0) return kMissed;
      continue;
    }
    const double t0 = to_min * inverse[axis], t1 = to_max * inverse[axis];
    near = std::max(near, std::min(t0, t1));
    far = std::min(far, std::max(t0, t1));
  }
  return near <= far ? near : kMissed;
}

/// Ericson, Real-Time Collision Detection (2005), 5.1.5: the regions of the point's projection.
/// An edge without length is passed over, so that a triangle without area is its longest edge.
Eigen::Vector3d nearest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) return a + d1 / (d1 - d3) * ab;
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const double scale = 1 / (va + vb + vc);
  return a + ab * (vb * scale) + ac * (vc * scale);
}

}  // namespace

BspTree::BspTree(const TriangleMesh& mesh) {
  const auto count = static_cast<int>(mesh.triangles.rows());
  std::vector<Corners> all(static_cast<std::size_t>(count));
  for (int f = 0; f < count; ++f) {
    all[f] = {mesh.vertices.row(mesh.triangles(f, 0)), mesh.vertices.row(mesh.triangles(f, 1)),
              mesh.vertices.row(mesh.triangles(f, 2))};
  }
  triangle_.resize(static_cast<std::size_t>(count));
  std::iota(triangle_.begin(), triangle_.end(), 0);
  nodes_.reserve(static_cast<std::size_t>(count));
  if (count > 0) build(0, count, all);
  corners_.reserve(triangle_.size());
  for (const int f : triangle_) corners_.push_back(all[f]);
}

int BspTree::build(int begin, int end, const std::vector<Corners>& all) {
  const auto index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Eigen::AlignedBox3d box;
  Eigen::AlignedBox3d centres;
  const auto centre = [&](int f) -> Eigen::Vector3d { return all[f].a + all[f].b + all[f].c; };
  for (int i = begin; i < end; ++i) {
    const Corners& t = all[triangle_[i]];
    box.extend(t.a).extend(t.b).extend(t.c);
    centres.extend(centre(triangle_[i]));
  }
  nodes_[index].box = box;
  nodes_[index].begin = begin;
  nodes_[index].end = end;
  if (end - begin <= kLeafSize) return index;
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  std::nth_element(triangle_.begin() + begin, triangle_.begin() + middle, triangle_.begin() + end,
                   [&](int f, int g) {
                     const double cf = centre(f)[axis], cg = centre(g)[axis];
                     return cf != cg ? cf < cg : f < g;
                   });
  build(begin, middle, all);
  const int right = build(middle, end, all);
  nodes_[index].right = right;
  return index;
}

std::optional<RayHit> BspTree::first_hit(const Eigen::Vector3d& origin,
                                         const Eigen::Vector3d& direction, double reach) const {
  if (nodes_.empty()) return {};
  const Eigen::Vector3d inverse = direction.cwiseInverse();
  std::optional<RayHit> best;
  double limit = reach;
  std::array<int, kMaxDepth> stack;
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[stack[--top]];
    if (entry(node.box, origin, direction, inverse, limit) > limit) continue;
    if (node.right != -1) {
      const int left = static_cast<int>(&node - nodes_.data()) + 1;
      const bool left_first = entry(nodes_[left].box, origin, direction, inverse, limit) <=
                              entry(nodes_[node.right].box, origin, direction, inverse, limit);
      stack[top++] = left_first ? node.right : left;
      stack[top++] = left_first ? left : node.right;
      continue;
    }
    // Möller and Trumbore 1997.
    for (int i = node.begin; i < node.end; ++i) {
      const Corners& t = corners_[i];
      const Eigen::Vector3d e1 = t.b - t.a, e2 = t.c - t.a;
      const Eigen::Vector3d p = direction.cross(e2);
      const double determinant = e1.dot(p);
      if (determinant == 0) continue;
      const Eigen::Vector3d s = origin - t.a;
      const double u = s.dot(p) / determinant;
      if (u < -kBorder || u > 1 + kBorder) continue;
      const Eigen::Vector3d q = s.cross(e1);
      const double v = direction.dot(q) / determinant;
      if (v < -kBorder || u + v > 1 + kBorder) continue;
      const double distance = e2.dot(q) / determinant;
      if (distance < 0 || distance > limit) continue;
      if (best && distance == best->distance && triangle_[i] > best->triangle) continue;
      limit = distance;
      best = RayHit{triangle_[i], distance, {1 - u - v, u, v}};
    }
  }
  return best;
}

std::optional<NearestPoint> BspTree::nearest(const Eigen::Vector3d& point, double reach) const {
  if (nodes_.empty()) return {};
  std::optional<NearestPoint> best;
  double limit = reach * reach;
  std::array<int, kMaxDepth> stack;
  int top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[stack[--top]];
    if (node.box.squaredExteriorDistance(point) > limit) continue;
    if (node.right != -1) {
      const int left = static_cast<int>(&node - nodes_.data()) + 1;
      const bool left_first = nodes_[left].box.squaredExteriorDistance(point) <=
                              nodes_[node.right].box.squaredExteriorDistance(point);
      stack[top++] = left_first ? node.right : left;
      stack[top++] = left_first ? left : node.right;
      continue;
    }
    for (int i = node.begin; i < node.end; ++i) {
      const Eigen::Vector3d q =
          nearest_on_triangle(point, corners_[i].a, corners_[i].b, corners_[i].c);
      const double squared = (q - point).squaredNorm();
      // The negation also passes over a triangle with an edge of no length, which gives no number.
      if (!(squared <= limit)) continue;
      if (best && squared == limit && triangle_[i] > best->triangle) continue;
      limit = squared;
      best = NearestPoint{triangle_[i], std::sqrt(squared), q};
    }
  }
  return best;
}

}  // namespace gnathion
