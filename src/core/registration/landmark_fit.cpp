#include "registration/landmark_fit.h"

#include <Eigen/Dense>
#include <cmath>
#include <optional>

#include "base/error.h"

namespace gnathion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kThin = 0.05;  // width over length below which landmarks count as on a line

[[noreturn]] void refuse(const std::string& subject, const std::string& problem,
                         const std::string& remedy) {
  throw Error(ErrorKind::input, subject, problem, remedy);
}

void check_pair(const LandmarkPair& pair, std::span<const LandmarkPair> before, double nearest) {
  const std::string subject = "landmark " + pair.name;
  if (!pair.photograph.allFinite() || !pair.lps.allFinite()) {
    refuse(subject, "has a coordinate that is no finite number", "pick it again");
  }
  for (const LandmarkPair& other : before) {
    if (other.name == pair.name) refuse(subject, "is given twice", "give each landmark one name");
    const bool same_in_photograph = (other.photograph - pair.photograph).norm() <= nearest;
    if (same_in_photograph || (other.lps - pair.lps).norm() < 1e-3) {
      refuse(subject,
             "lies where " + other.name + " does " +
                 (same_in_photograph ? "in the photograph" : "on the CT"),
             "pick two different places");
    }
  }
}

/// n×3, centred; and the centre.
struct Centred {
  Points points;
  Vector3d centre;
};

Centred centred(std::span<const LandmarkPair> pairs, Vector3d LandmarkPair::*side) {
  Centred c{Points(static_cast<Eigen::Index>(pairs.size()), 3), {}};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    c.points.row(static_cast<Eigen::Index>(i)) = (pairs[i].*side).transpose();
  }
  c.centre = c.points.colwise().mean();
  c.points.rowwise() -= c.centre.transpose();
  return c;
}

void check_not_on_a_line(const Points& points, const std::string& where) {
  const Vector3d sizes = Eigen::JacobiSVD<Eigen::MatrixXd>(points).singularValues();
  if (sizes[1] >= kThin * sizes[0]) return;
  refuse("landmarks", "lie on a line " + where + ", so the turn about it is not determined",
         "add one to the side, such as a corner of an eye or of the mouth");
}

Similarity best_transform(const Centred& from, const Centred& to, std::optional<double> scale) {
  const Matrix3d covariance = to.points.transpose() * from.points;
  const Eigen::JacobiSVD<Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector3d& d = svd.singularValues();
  Vector3d sign = Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) {
    // Three points lie in a plane, and then either sign fits as well.
    if (d[2] > 0.02 * d[0]) {
      refuse("landmarks", "fit the face's mirror image better than the face",
             "look for a left and a right that are exchanged");
    }
    sign[2] = -1;
  }
  Similarity s;
  s.rotation = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  s.scale = scale.value_or(d.dot(sign) / from.points.squaredNorm());
  s.translation = to.centre - s.scale * (s.rotation * from.centre);
  return s;
}

LandmarkFit fitted(std::span<const LandmarkPair> pairs, std::optional<double> scale) {
  if (pairs.size() < 3) {
    refuse("landmarks", "are " + std::to_string(pairs.size()) + ", too few to place a photograph",
           "pick at least three that are not on a line");
  }
  double extent = 0;
  for (const LandmarkPair& pair : pairs) {
    extent = std::max(extent, (pair.photograph - pairs[0].photograph).norm());
  }
  for (std::size_t i = 0; i < pairs.size(); ++i)
    check_pair(pairs[i], pairs.first(i), 1e-5 * extent);
  const Centred from = centred(pairs, &LandmarkPair::photograph);
  const Centred to = centred(pairs, &LandmarkPair::lps);
  check_not_on_a_line(from.points, "in the photograph");
  check_not_on_a_line(to.points, "on the CT");
  LandmarkFit fit{best_transform(from, to, scale), {}, 0};
  fit.residual_mm = landmark_residuals(pairs, fit.lps_from_photograph);
  for (const auto& [name, residual] : fit.residual_mm) fit.rms_mm += residual * residual;
  fit.rms_mm = std::sqrt(fit.rms_mm / static_cast<double>(pairs.size()));
  return fit;
}

}  // namespace

std::map<std::string, double> landmark_residuals(std::span<const LandmarkPair> pairs,
                                                 const Similarity& lps_from_photograph) {
  std::map<std::string, double> residuals;
  for (const LandmarkPair& pair : pairs) {
    residuals[pair.name] = (lps_from_photograph(pair.photograph) - pair.lps).norm();
  }
  return residuals;
}

LandmarkFit fit_landmarks(std::span<const LandmarkPair> pairs) {
  return fitted(pairs, std::nullopt);
}

LandmarkFit fit_landmarks(std::span<const LandmarkPair> pairs, double mm_per_unit) {
  if (!(mm_per_unit > 0) || !std::isfinite(mm_per_unit)) {
    refuse("scale", "is not above 0 mm a unit, which would mirror or flatten the photograph",
           "give the millimetres in a unit of the photograph (1000 for metres)");
  }
  return fitted(pairs, mm_per_unit);
}

}  // namespace gnathion
