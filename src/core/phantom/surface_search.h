#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace gnathion {

/// Negative inside, mm.
using DistanceFunction = std::function<double(const Eigen::Vector3d&)>;

/// Where the ray from `start` (outside) along `direction` (any length but 0) first meets the zero
/// level, to 1e-6 mm; nothing when it meets none within 600 mm.
std::optional<Eigen::Vector3d> first_hit(const DistanceFunction& f, const Eigen::Vector3d& start,
                                         const Eigen::Vector3d& direction);

/// The same where a miss would be an error of ours: throws std::logic_error.
Eigen::Vector3d surface_point(const DistanceFunction& f, const Eigen::Vector3d& start,
                              const Eigen::Vector3d& direction);

/// Rays run along −`outward` (length 1) from 150 mm outside the segment from–to. Of the points that
/// they meet: the one farthest along `outward`, or the least far.
Eigen::Vector3d most_prominent(const DistanceFunction& f, const Eigen::Vector3d& from,
                               const Eigen::Vector3d& to, const Eigen::Vector3d& outward);
Eigen::Vector3d most_recessed(const DistanceFunction& f, const Eigen::Vector3d& from,
                              const Eigen::Vector3d& to, const Eigen::Vector3d& outward);

}  // namespace gnathion
