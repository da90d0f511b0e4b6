#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion::bench {

/// A ray of the bone map.
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< unit
};

/// What a tree found: the triangle (−1: none) and the distance of each ray's first hit.
struct Hits {
  std::vector<int> triangle;
  std::vector<double> distance;
};

/// The same question to every tree that was considered for the bone map.
class RayTree {
 public:
  virtual ~RayTree() = default;
  virtual std::string name() const = 0;
  virtual void build(const TriangleMesh& mesh) = 0;
  virtual Hits ask(const std::vector<Ray>& rays, double reach) const = 0;
};

std::vector<std::unique_ptr<RayTree>> ray_trees();

}  // namespace gnathion::bench
