#include "tissue/bone_normals.h"

#include <limits>
#include <vector>

namespace gnathion {
namespace {

/// Collects the triangles of a surface that are connected with one of them within a radius.
class Patches {
 public:
  explicit Patches(const TriangleMesh& surface)
      : surface_(surface),
        first_(static_cast<std::size_t>(surface.vertices.rows()) + 1, 0),
        around_(static_cast<std::size_t>(surface.triangles.size())),
        visit_(static_cast<std::size_t>(surface.triangles.rows()), -1) {
    const Triangles& triangles = surface.triangles;
    for (const int v : triangles.reshaped()) ++first_[static_cast<std::size_t>(v) + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    std::vector<int> end(first_.begin(), first_.end() - 1);
    for (int f = 0; f < triangles.rows(); ++f) {
      for (const int v : triangles.row(f)) around_[end[v]++] = f;
    }
  }

  /// `number` differs from call to call.
  std::vector<int> around(int triangle, const Eigen::Vector3d& centre, double radius, int number) {
    std::vector<int> patch{triangle};
    visit_[triangle] = number;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      for (const int v : surface_.triangles.row(patch[next])) {
        for (int i = first_[v]; i < first_[v + 1]; ++i) {
          const int f = around_[i];
          if (visit_[f] == number) continue;
          visit_[f] = number;
          if ((middle(f) - centre).squaredNorm() < radius * radius) patch.push_back(f);
        }
      }
    }
    return patch;
  }

  Eigen::Vector3d middle(int f) const { return (corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3; }
  /// Half the cross product of two edges: the area times the normal.
  Eigen::Vector3d vector_area(int f) const {
    return (corner(f, 1) - corner(f, 0)).cross(corner(f, 2) - corner(f, 0)) / 2;
  }

 private:
  Eigen::Vector3d corner(int f, int c) const {
    return surface_.vertices.row(surface_.triangles(f, c));
  }

  const TriangleMesh& surface_;
  std::vector<int> first_;   ///< per vertex, in around_; one more than vertices
  std::vector<int> around_;  ///< triangles of each vertex
  std::vector<int> visit_;   ///< per triangle: the number of the last patch that met it
};

}  // namespace

Points smooth_normals(const TriangleMesh& surface, const BspTree& tree, const Points& points,
                      double radius) {
  Patches patches(surface);
  Points normals = Points::Zero(points.rows(), 3);
  for (int i = 0; i < points.rows(); ++i) {
    const auto nearest = tree.nearest(points.row(i), std::numeric_limits<double>::max());
    if (!nearest) continue;
    const auto patch = patches.around(nearest->triangle, nearest->point, radius, i);
    const auto mean = [&](const Eigen::Vector3d& outward) -> Eigen::Vector3d {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const int f : patch) {
        const double part = (patches.middle(f) - nearest->point).squaredNorm() / (radius * radius);
        const Eigen::Vector3d area = patches.vector_area(f);
        // A triangle larger than the patch is only in it for being the nearest.
        if (part < 1 && area.dot(outward) >= 0) sum += (1 - part) * (1 - part) * area;
      }
      return sum.stableNormalized();
    };
    // Once more without what faces away: at the edge of a thin plate its far side is connected too.
    Eigen::Vector3d normal = mean(mean(Eigen::Vector3d::Zero()));
    if (normal.isZero()) normal = patches.vector_area(nearest->triangle).stableNormalized();
    normals.row(i) = normal;
  }
  return normals;
}

}  // namespace gnathion
