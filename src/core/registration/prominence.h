#pragma once

#include <vector>

#include "registration/surface_sample.h"

namespace gnathion {

/// A point that stands out, such as the tip of a nose, and the way the surface about it faces.
struct Prominence {
  Eigen::Vector3d at;
  Eigen::Vector3d facing;  ///< length 1
  double height = 0;       ///< over the mean of the surface within the ball, in radii of it
};

/// The points of a sample (mm) as prominences over a ball of 22 mm, about the size of a nose.
/// Points with too little surface about them are left out.
std::vector<Prominence> prominences(const SurfaceSample& sample);

/// The highest, no two within 15 mm of each other, highest first, at most `most`.
std::vector<Prominence> highest(std::vector<Prominence> all, std::size_t most);

}  // namespace gnathion
