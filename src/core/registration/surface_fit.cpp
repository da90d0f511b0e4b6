#include "registration/surface_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace gnathion {
namespace {

using Eigen::Vector3d;
using Vector8d = Eigen::Matrix<double, 8, 1>;
using Matrix8d = Eigen::Matrix<double, 8, 8>;

constexpr double kFacing = 0.7;        // cosine of 45°
constexpr double kTukey = 4.685;       // 95 % efficient for normal errors (Huber 1981)
constexpr double kLeastSpread = 0.15;  // mm; a CT's skin is not known better
constexpr double kMostScaling = 1.25;
// What the offset is held to 0 with, against 1 by which every pair tells of it: a part that faces
// one way only cannot tell it from a translation.
constexpr double kOffsetHold = 0.002;
constexpr double kMostOffset = 0.7;  // mm: half a voxel, by which a CT's level may be off

/// A point of the photograph, in LPS, and where it should lie.
struct Pair {
  Vector3d point;
  Vector3d normal;  ///< of the skin
  double distance;  ///< along the normal, signed
  double gap;       ///< to the nearest point
};

std::vector<Pair> pairs_of(const SurfaceSample& photograph, const Similarity& s,
                           const SkinTarget& skin, double reach) {
  std::vector<Pair> pairs;
  for (Eigen::Index i = 0; i < photograph.size(); ++i) {
    const Vector3d p = s(photograph.points.row(i));
    const auto place = skin.nearest(p, reach);
    if (!place) continue;
    const Vector3d normal = s.rotation * photograph.normals.row(i).transpose();
    if (normal.dot(place->normal) < kFacing) continue;
    pairs.push_back(
        {p, place->normal, place->normal.dot(p - place->point), (p - place->point).norm()});
  }
  return pairs;
}

/// Drops the worst pairs.
void trim(std::vector<Pair>& pairs, double fraction) {
  const auto keep = static_cast<std::ptrdiff_t>((1 - fraction) * static_cast<double>(pairs.size()));
  std::nth_element(pairs.begin(), pairs.begin() + keep, pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.gap < b.gap; });
  pairs.resize(static_cast<std::size_t>(keep));
}

double spread_of(const std::vector<Pair>& pairs, double offset) {
  std::vector<double> sizes;
  for (const Pair& pair : pairs) sizes.push_back(std::abs(pair.distance - offset));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return std::max(kLeastSpread, 1.4826 * *middle);
}

double weight(double distance, double spread) {
  const double t = distance / (kTukey * spread);
  return t * t < 1 ? (1 - t * t) * (1 - t * t) : 0;
}

/// The normal equations of one step, about the pairs' centre. Unknowns: turn (3) and translation,
/// scale, offset; turn and scale in units of the radius, so that all are mm.
struct Step {
  Matrix8d matrix = Matrix8d::Zero();  ///< mean of J Jᵀ
  Vector8d side = Vector8d::Zero();
  Vector3d centre = Vector3d::Zero();
  double radius = 1;  ///< RMS
};

Step step_of(const std::vector<Pair>& pairs, double offset, double spread) {
  Step step;
  double total = 0, squares = 0;
  for (const Pair& pair : pairs) {
    const double w = weight(pair.distance - offset, spread);
    step.centre += w * pair.point;
    total += w;
  }
  if (total <= 0) return step;
  step.centre /= total;
  for (const Pair& pair : pairs) {
    squares += weight(pair.distance - offset, spread) * (pair.point - step.centre).squaredNorm();
  }
  step.radius = std::max(1e-9, std::sqrt(squares / total));
  for (const Pair& pair : pairs) {
    const Vector3d arm = (pair.point - step.centre) / step.radius;
    Vector8d j;
    j << arm.cross(pair.normal), pair.normal, arm.dot(pair.normal), -1;
    const double w = weight(pair.distance - offset, spread) / total;
    step.matrix += w * j * j.transpose();
    step.side -= w * (pair.distance - offset) * j;
  }
  return step;
}

double grip_of(const Step& step, int unknowns) {
  const Eigen::MatrixXd matrix = step.matrix.topLeftCorner(unknowns, unknowns);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

/// What the step changes, with zeros for what stays as it is.
Vector8d solved(const Step& step, double offset, const SurfaceFitOptions& options) {
  std::vector<int> unknown{0, 1, 2, 3, 4, 5};
  if (options.fit_scale) unknown.push_back(6);
  // At its limit, and pushed beyond it, the offset is no unknown.
  const bool at_limit = std::abs(offset) >= kMostOffset && step.side[7] * offset > 0;
  if (options.fit_offset && !at_limit) unknown.push_back(7);
  Matrix8d matrix = step.matrix;
  Vector8d side = step.side;
  matrix(7, 7) += kOffsetHold;
  side[7] -= kOffsetHold * offset;
  // A direction that the shape does not hold at all must not run away: it stays where it is.
  matrix.diagonal().array() += 1e-6;
  Vector8d x = Vector8d::Zero();
  const Eigen::MatrixXd part = matrix(unknown, unknown);
  const Eigen::VectorXd right = side(unknown);
  x(unknown) = part.ldlt().solve(right).eval();
  return x;
}

Similarity stepped(const Similarity& s, const Step& step, const Vector8d& x) {
  const Vector3d turn = x.head<3>() / step.radius;
  const double angle = turn.norm();
  const Eigen::Matrix3d rotation = angle > 0
                                       ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                       : Eigen::Matrix3d::Identity();
  const double factor = 1 + x[6] / step.radius;
  Similarity next;
  next.scale = s.scale * factor;
  next.rotation = Eigen::Quaterniond(rotation * s.rotation).normalized().toRotationMatrix();
  next.translation =
      factor * (rotation * (s.translation - step.centre)) + step.centre + x.segment<3>(3);
  return next;
}

}  // namespace

SurfaceFit fit_surface(const SurfaceSample& photograph, const Similarity& start,
                       const SkinTarget& skin, const SurfaceFitOptions& options,
                       const Progress& progress) {
  constexpr std::size_t kFewest = 20;
  SurfaceFit fit;
  fit.lps_from_photograph = start;
  fit.spread_mm = options.reach_mm;
  double reach = options.reach_mm;
  while (fit.iterations < options.most_iterations) {
    progress.check();
    std::vector<Pair> pairs = pairs_of(photograph, fit.lps_from_photograph, skin, reach);
    trim(pairs, options.trimmed);
    fit.pairs = static_cast<Eigen::Index>(pairs.size());
    if (pairs.size() < kFewest) {
      fit.grip = 0;
      return fit;
    }
    fit.spread_mm = std::min(fit.spread_mm, spread_of(pairs, fit.offset_mm));
    const Step step = step_of(pairs, fit.offset_mm, fit.spread_mm);
    fit.grip = grip_of(step, options.fit_scale ? 7 : 6);
    const Vector8d x = solved(step, fit.offset_mm, options);
    const Similarity next = stepped(fit.lps_from_photograph, step, x);
    if (std::abs(std::log(next.scale / start.scale)) > std::log(kMostScaling)) return fit;
    fit.lps_from_photograph = next;
    fit.offset_mm = std::clamp(fit.offset_mm + x[7], -kMostOffset, kMostOffset);
    ++fit.iterations;
    const double wanted = std::max(options.least_reach_mm, 4 * fit.spread_mm);
    const bool reach_settled = reach <= wanted;
    if (reach_settled && x.norm() < std::max(options.settled_mm, 0.01 * fit.spread_mm)) {
      fit.converged = true;
      return fit;
    }
    reach = std::max(std::min(reach, wanted), 0.7 * reach);
  }
  return fit;
}

SurfaceAgreement agreement(const SurfaceSample& photograph, const Similarity& s,
                           const SkinTarget& skin, double reach_mm) {
  SurfaceAgreement found;
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < photograph.size(); ++i) {
    const Vector3d p = s(photograph.points.row(i));
    const auto place = skin.nearest(p, reach_mm);
    if (!place) continue;
    if ((s.rotation * photograph.normals.row(i).transpose()).dot(place->normal) < kFacing) continue;
    distances.push_back(
        std::copysign((p - place->point).norm(), place->normal.dot(p - place->point)));
    found.row.push_back(i);
  }
  found.distance =
      Eigen::Map<Eigen::VectorXd>(distances.data(), static_cast<Eigen::Index>(distances.size()));
  return found;
}

}  // namespace gnathion
