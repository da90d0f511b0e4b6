#include "bone/collision.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/bsp_tree.h"

namespace gnathion {
namespace {

constexpr double kFar = 1e5;  // mm
/// No motion of a jaw brings bone that is farther away at rest.
constexpr double kMostMoved = 45;  // mm

RigidMotion inverse(const RigidMotion& motion) {
  const Eigen::Matrix3d back = motion.rotation.transpose();
  return {back, -(back * motion.translation)};
}

RigidMotion after(const RigidMotion& second, const RigidMotion& first) {
  return {second.rotation * first.rotation, second(first.translation)};
}

Eigen::AlignedBox3d box_of(const Points& points) {
  Eigen::AlignedBox3d box;
  for (Eigen::Index v = 0; v < points.rows(); ++v) box.extend(points.row(v).transpose());
  return box;
}

}  // namespace

struct CollisionModel::Bone {
  Points vertices;
  Points centres;  ///< of the triangles
  Points normals;  ///< likewise, of any length, outward
  Eigen::AlignedBox3d box;
  BspTree tree;

  explicit Bone(const TriangleMesh& mesh)
      : vertices(mesh.vertices),
        centres(mesh.triangles.rows(), 3),
        normals(mesh.triangles.rows(), 3),
        box(box_of(mesh.vertices)),
        tree(mesh) {
    for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
      const Eigen::RowVector3d a = mesh.vertices.row(mesh.triangles(f, 0));
      const Eigen::RowVector3d b = mesh.vertices.row(mesh.triangles(f, 1));
      const Eigen::RowVector3d c = mesh.vertices.row(mesh.triangles(f, 2));
      centres.row(f) = (a + b + c) / 3;
      normals.row(f) = (b - a).cross(c - a);
    }
  }

  /// Whether a point off the surface is inside, given the surface's nearest triangle. A ray at the
  /// middle of that triangle first meets a side that faces the point or one that does not; unlike
  /// the nearest triangle's own normal that is right next to edges too.
  bool holds(const Eigen::Vector3d& point, int nearest_triangle) const {
    const Eigen::Vector3d to = centres.row(nearest_triangle).transpose() - point;
    const double distance = to.norm();
    if (distance == 0) return false;
    const auto hit = tree.first_hit(point, to / distance, distance * (1 + 1e-6));
    return hit && normals.row(hit->triangle).dot(to) > 0;
  }

  /// How deep a point is inside, mm; negative or nothing outside: nothing when farther than reach.
  std::optional<double> depth(const Eigen::Vector3d& point, double reach) const {
    const auto nearest = tree.nearest(point, reach);
    if (!nearest) return {};
    return holds(point, nearest->triangle) ? nearest->distance : -nearest->distance;
  }
};

/// Vertices of one bone that might come to lie inside another.
struct CollisionModel::Pair {
  struct Vertex {
    Eigen::Vector3d at_rest;
    double depth_at_rest;  ///< mm; negative: how far from the other bone
  };
  std::size_t from = 0;  ///< in bones_
  std::size_t into = 0;
  std::vector<Vertex> vertices;

  Pair(std::size_t of, std::size_t other, const Bone& bone, const Bone& into_bone, int most)
      : from(of), into(other) {
    Eigen::AlignedBox3d near = into_bone.box;
    near.min().array() -= kMostMoved;
    near.max().array() += kMostMoved;
    std::vector<Eigen::Index> candidates;
    for (Eigen::Index v = 0; v < bone.vertices.rows(); ++v) {
      if (near.contains(bone.vertices.row(v).transpose())) candidates.push_back(v);
    }
    const double step =
        most > 0 ? std::max(1.0, static_cast<double>(candidates.size()) / most) : 1.0;
    for (double i = 0; i < static_cast<double>(candidates.size()); i += step) {
      const Eigen::Vector3d p = bone.vertices.row(candidates[static_cast<std::size_t>(i)]);
      if (const auto depth = into_bone.depth(p, kMostMoved)) vertices.push_back({p, *depth});
    }
    // The frames of a drag stop at the first that is too far away.
    std::sort(vertices.begin(), vertices.end(),
              [](const Vertex& a, const Vertex& b) { return a.depth_at_rest > b.depth_at_rest; });
  }

  /// Adds what is deeper than at rest by more than `tolerance`. relative: from the bone's rest to
  /// the other's rest frame, poses undone. Depths and places in that frame.
  void find(const Bone& other, const RigidMotion& relative, double tolerance,
            std::vector<std::pair<Eigen::Vector3d, double>>& found, double farthest) const {
    for (const Vertex& vertex : vertices) {
      // A point that moves by m gets deeper by no more than m.
      if (farthest + vertex.depth_at_rest <= tolerance) break;
      const Eigen::Vector3d p = relative(vertex.at_rest);
      const double reach = (p - vertex.at_rest).norm() + vertex.depth_at_rest;
      if (reach <= tolerance || !other.box.contains(p)) continue;
      const auto nearest = other.tree.nearest(p, reach + 1e-9);
      const double least = tolerance + std::max(vertex.depth_at_rest, 0.0);
      if (!nearest || nearest->distance <= least || !other.holds(p, nearest->triangle)) continue;
      found.emplace_back(p, nearest->distance);
    }
  }
};

CollisionModel::CollisionModel(const std::vector<const TriangleMesh*>& segments,
                               const TriangleMesh& remainder, const CollisionOptions& options)
    : options_(options) {
  for (const TriangleMesh* segment : segments) {
    bones_.push_back(std::make_unique<const Bone>(*segment));
  }
  bones_.push_back(std::make_unique<const Bone>(remainder));
  for (std::size_t a = 0; a < segments.size(); ++a) {
    for (std::size_t b = a + 1; b < bones_.size(); ++b) {
      pairs_.emplace_back(a, b, *bones_[a], *bones_[b], options.most_vertices);
      pairs_.emplace_back(b, a, *bones_[b], *bones_[a], options.most_vertices);
    }
  }
}

CollisionModel::~CollisionModel() = default;
CollisionModel::CollisionModel(CollisionModel&&) noexcept = default;

namespace {

/// The farthest that a rigid motion moves a point of a box, mm: of its corners.
double farthest_moved(const RigidMotion& motion, const Eigen::AlignedBox3d& box) {
  double most = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    most = std::max(most, (motion(p) - p).norm());
  }
  return most;
}

Collision collision_of(const std::vector<std::pair<Eigen::Vector3d, double>>& found) {
  Collision collision;
  const auto count = static_cast<Eigen::Index>(found.size());
  collision.places.resize(count, 3);
  collision.depths.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [place, depth] = found[static_cast<std::size_t>(i)];
    collision.places.row(i) = place;
    collision.depths[i] = depth;
    if (depth <= collision.depth) continue;
    collision.depth = depth;
    collision.deepest = place;
  }
  return collision;
}

}  // namespace

std::vector<Collision> CollisionModel::collisions(std::span<const RigidMotion> poses) const {
  std::vector<Collision> all;
  const std::size_t fixed = bones_.size() - 1;
  const auto pose = [&](std::size_t bone) { return bone == fixed ? RigidMotion{} : poses[bone]; };
  for (std::size_t p = 0; p < pairs_.size(); p += 2) {  // a pair and its reverse
    std::vector<std::pair<Eigen::Vector3d, double>> found;
    for (const Pair& pair : std::span(pairs_).subspan(p, 2)) {
      const RigidMotion relative = after(inverse(pose(pair.into)), pose(pair.from));
      if (relative == RigidMotion{}) continue;
      const std::size_t before = found.size();
      pair.find(*bones_[pair.into], relative, options_.tolerance, found,
                farthest_moved(relative, bones_[pair.from]->box));
      for (std::size_t i = before; i < found.size(); ++i) {
        found[i].first = pose(pair.into)(found[i].first);
      }
    }
    if (found.empty()) continue;
    all.push_back(collision_of(found));
    all.back().segment = static_cast<int>(pairs_[p].from);
    all.back().other = pairs_[p].into == fixed ? -1 : static_cast<int>(pairs_[p].into);
  }
  std::sort(all.begin(), all.end(),
            [](const Collision& a, const Collision& b) { return a.depth > b.depth; });
  return all;
}

int CollisionModel::segment_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
                               std::span<const RigidMotion> poses) const {
  int first = -1;
  double reach = kFar;
  for (std::size_t bone = 0; bone < bones_.size(); ++bone) {
    const bool moves = bone + 1 < bones_.size();
    const RigidMotion back = moves ? inverse(poses[bone]) : RigidMotion{};
    const auto hit = bones_[bone]->tree.first_hit(back(eye), back.rotation * direction, reach);
    if (!hit) continue;
    reach = hit->distance;
    first = moves ? static_cast<int>(bone) : -1;
  }
  return first;
}

}  // namespace gnathion
