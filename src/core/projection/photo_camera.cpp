#include "projection/photo_camera.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <set>
#include <sstream>

#include "base/error.h"

namespace gnathion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector7d = Eigen::Matrix<double, 7, 1>;
using Matrix7d = Eigen::Matrix<double, 7, 7>;
using Matrix27d = Eigen::Matrix<double, 2, 7>;

constexpr double kFilmDiagonal = 43.2666;  // mm, of 36 x 24
constexpr double kUsualFocal = 60;         // mm on such a film
constexpr double kUsualSpread = 0.47;      // of the focal length's logarithm: a factor of 1.6
constexpr double kKnownSpread = 0.02;
constexpr double kPickedMm = 1;        // how well a landmark is picked
constexpr double kHiddenMm = 15;       // skin this far before a landmark hides it
constexpr double kLargestRms = 6;      // mm
constexpr double kLargestSpread = 8;   // mm
constexpr double kLeastThickness = 2;  // mm, RMS distance of the landmarks from their plane

[[noreturn]] void refuse(const std::string& subject, const std::string& problem,
                         const std::string& remedy) {
  throw Error(ErrorKind::input, subject, problem, remedy);
}

std::string in_mm(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << value << " mm";
  return text.str();
}

void check_one(const PhotoLandmark& landmark, int width, int height) {
  const std::string subject = "landmark " + landmark.name;
  if (!landmark.lps.allFinite() || !landmark.pixel.allFinite()) {
    refuse(subject, "has a coordinate that is no finite number", "pick it again");
  }
  const Vector2d& p = landmark.pixel;
  if (p.x() < -0.5 || p.y() < -0.5 || p.x() > width - 0.5 || p.y() > height - 0.5) {
    std::ostringstream place;
    place << "lies outside the picture, at " << p.x() << ", " << p.y() << " of " << width << " x "
          << height << " pixels";
    refuse(subject, place.str(), "pick it in the picture as it is shown upright");
  }
}

void check_pairs(std::span<const PhotoLandmark> landmarks) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const PhotoLandmark& a = landmarks[i];
    if (!names.insert(a.name).second) {
      refuse("landmark " + a.name, "is given twice", "give it once in a photograph");
    }
    for (std::size_t j = 0; j < i; ++j) {
      const PhotoLandmark& b = landmarks[j];
      if ((a.lps - b.lps).norm() > 1 && (a.pixel - b.pixel).norm() > 0.5) continue;
      refuse("landmarks " + b.name + " and " + a.name, "are at one place",
             "pick one of them again");
    }
  }
}

/// Standard deviations along the main axes of points, one a column, the largest first.
Eigen::VectorXd spreads(const Eigen::MatrixXd& points) {
  const Eigen::MatrixXd centred = points.colwise() - points.rowwise().mean();
  return Eigen::JacobiSVD<Eigen::MatrixXd>(centred).singularValues() /
         std::sqrt(static_cast<double>(points.cols()));
}

/// Returns how many pixels there are for a millimetre, about.
double checked_shape(std::span<const PhotoLandmark> landmarks) {
  const auto count = static_cast<Eigen::Index>(landmarks.size());
  Eigen::MatrixXd places(3, count), pixels(2, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    places.col(i) = landmarks[static_cast<std::size_t>(i)].lps;
    pixels.col(i) = landmarks[static_cast<std::size_t>(i)].pixel;
  }
  const Eigen::VectorXd in_space = spreads(places), in_picture = spreads(pixels);
  if (in_space[1] < 0.05 * in_space[0] || in_picture[1] < 0.05 * in_picture[0]) {
    refuse("landmarks", "lie on a line, about which the camera could turn",
           "add one to the side, such as a mouth corner or a corner of the eye");
  }
  if (in_space[2] < kLeastThickness) {
    refuse("landmarks", "lie on a plane, so that the camera's tilt is left to chance",
           "add one off it, such as the tip of the nose, a corner of the eye or the ear");
  }
  return in_picture[0] / in_space[0];
}

double focal_pixels(double focal_35mm, int width, int height) {
  return focal_35mm * std::hypot(width, height) / kFilmDiagonal;
}

/// Landmarks in a picture, and what is believed of the focal length.
struct Problem {
  std::vector<PhotoLandmark> landmarks;
  Vector2d centre;
  double usual_focal;  ///< pixels
  double spread;       ///< of its logarithm
  double scale;        ///< pixels for a millimetre of the face, about
};

PhotoCamera stepped(const PhotoCamera& camera, const Vector7d& step) {
  PhotoCamera next = camera;
  const Vector3d turn = step.head<3>();
  const double angle = turn.norm();
  if (angle > 0) {
    next.camera_from_lps.rotation =
        Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * camera.camera_from_lps.rotation;
  }
  next.camera_from_lps.translation += step.segment<3>(3);
  next.focal *= std::exp(step[6]);
  return next;
}

/// How a pixel moves with the parameters of stepped().
Matrix27d derivative(const PhotoCamera& camera, const Vector3d& lps) {
  const Vector3d turned = camera.camera_from_lps.rotation * lps;
  const Vector3d q = turned + camera.camera_from_lps.translation;
  Eigen::Matrix<double, 2, 3> by_place;
  by_place << 1 / q.z(), 0, -q.x() / (q.z() * q.z()), 0, 1 / q.z(), -q.y() / (q.z() * q.z());
  by_place *= camera.focal;
  Matrix3d by_turn;  // −[turned]×
  by_turn << 0, turned.z(), -turned.y(), -turned.z(), 0, turned.x(), turned.y(), -turned.x(), 0;
  Matrix27d d;
  d << by_place * by_turn, by_place, camera.focal * q.head<2>() / q.z();
  return d;
}

/// Gauss and Newton's normal equations of the landmarks, picked to `sigma` pixels, and of the
/// belief in the focal length.
struct Normal {
  Matrix7d matrix = Matrix7d::Zero();
  Vector7d right = Vector7d::Zero();
  double cost = 0;  ///< infinite when a landmark lies behind the camera
};

Normal normal_equations(const Problem& problem, const PhotoCamera& camera, double sigma) {
  Normal normal;
  for (const PhotoLandmark& landmark : problem.landmarks) {
    if (camera.depth(landmark.lps) < 1) {
      normal.cost = std::numeric_limits<double>::infinity();
      return normal;
    }
    const Vector2d r = (camera.pixel(landmark.lps) - landmark.pixel) / sigma;
    const Matrix27d d = derivative(camera, landmark.lps) / sigma;
    normal.matrix += d.transpose() * d;
    normal.right -= d.transpose() * r;
    normal.cost += r.squaredNorm();
  }
  const double r = std::log(camera.focal / problem.usual_focal) / problem.spread;
  normal.matrix(6, 6) += 1 / (problem.spread * problem.spread);
  normal.right[6] -= r / problem.spread;
  normal.cost += r * r;
  return normal;
}

struct Solution {
  PhotoCamera camera;
  double cost = std::numeric_limits<double>::infinity();
};

/// Levenberg and Marquardt (Marquardt 1963: the diagonal is raised).
Solution refined(const Problem& problem, PhotoCamera camera, double sigma) {
  Normal normal = normal_equations(problem, camera, sigma);
  double damping = 1e-3;
  for (int step = 0; step < 100 && std::isfinite(normal.cost) && damping < 1e12; ++step) {
    Matrix7d matrix = normal.matrix;
    matrix.diagonal() *= 1 + damping;
    const Vector7d move = matrix.ldlt().solve(normal.right);
    const PhotoCamera next = stepped(camera, move);
    const Normal there = normal_equations(problem, next, sigma);
    if (!(there.cost < normal.cost)) {
      damping *= 10;
      continue;
    }
    const bool rests = normal.cost - there.cost < 1e-10 * (1 + normal.cost);
    camera = next;
    normal = there;
    damping = std::max(damping / 10, 1e-9);
    if (rests) break;
  }
  return {camera, normal.cost};
}

/// The pose that a nearly flat set of landmarks takes for the same one when seen from afar: turned
/// inside out at its plane (Necker's reversal).
PhotoCamera reversed(const PhotoCamera& camera, const Problem& problem) {
  Eigen::MatrixXd places(3, static_cast<Eigen::Index>(problem.landmarks.size()));
  for (std::size_t i = 0; i < problem.landmarks.size(); ++i) {
    places.col(static_cast<Eigen::Index>(i)) = problem.landmarks[i].lps;
  }
  const Vector3d middle = places.rowwise().mean();
  const Eigen::MatrixXd centred = places.colwise() - middle;
  const Vector3d normal =
      Eigen::JacobiSVD<Eigen::MatrixXd>(centred, Eigen::ComputeThinU).matrixU().col(2);
  const Vector3d at = camera.camera_from_lps(middle);
  PhotoCamera other = camera;
  other.camera_from_lps.rotation = Vector3d(1, 1, -1).asDiagonal() *
                                   camera.camera_from_lps.rotation *
                                   (Matrix3d::Identity() - 2 * normal * normal.transpose());
  other.camera_from_lps.translation = at - other.camera_from_lps.rotation * middle;
  return other;
}

PhotoCamera camera_of(const cv::Mat& turn, const cv::Mat& translation, double focal,
                      const Vector2d& centre) {
  cv::Matx33d rotation;
  cv::Rodrigues(turn, rotation);
  PhotoCamera camera{{}, focal, centre};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) camera.camera_from_lps.rotation(r, c) = rotation(r, c);
    camera.camera_from_lps.translation[r] = translation.at<double>(r);
  }
  return camera;
}

/// Poses for a focal length, by SQPnP (Terzakis and Lourakis 2020) and their reversals.
std::vector<PhotoCamera> poses(const Problem& problem, double focal) {
  std::vector<cv::Point3d> places;
  std::vector<cv::Point2d> pixels;
  for (const PhotoLandmark& landmark : problem.landmarks) {
    places.emplace_back(landmark.lps.x(), landmark.lps.y(), landmark.lps.z());
    pixels.emplace_back(landmark.pixel.x(), landmark.pixel.y());
  }
  const cv::Matx33d inner(focal, 0, problem.centre.x(), 0, focal, problem.centre.y(), 0, 0, 1);
  std::vector<cv::Mat> turns, translations;
  try {
    cv::solvePnPGeneric(places, pixels, inner, cv::noArray(), turns, translations, false,
                        cv::SOLVEPNP_SQPNP);
  } catch (const cv::Exception&) {
    return {};  // no pose for this focal length; another's may do
  }
  std::vector<PhotoCamera> cameras;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    cameras.push_back(camera_of(turns[i], translations[i], focal, problem.centre));
    cameras.push_back(reversed(cameras.back(), problem));
  }
  return cameras;
}

/// Whether the camera looks at the landmarks' outer side: most of them are not hidden.
bool sees(const PhotoCamera& camera, const Problem& problem, const SkinSight& skin) {
  const Vector3d eye = camera.eye();
  const auto hidden = std::count_if(
      problem.landmarks.begin(), problem.landmarks.end(),
      [&](const PhotoLandmark& landmark) { return skin.hides(landmark.lps, eye, kHiddenMm); });
  return 3 * static_cast<std::size_t>(hidden) <= problem.landmarks.size();
}

/// The best camera among those that see the landmarks; infinite cost when none does.
Solution solved(const Problem& problem, const SkinSight& skin) {
  Solution best;
  for (const double factor : {0.4, 0.6, 0.8, 1.0, 1.5, 2.5, 4.0}) {
    if (problem.spread == kKnownSpread && factor != 1.0) continue;
    for (const PhotoCamera& start : poses(problem, factor * problem.usual_focal)) {
      const bool before =
          std::all_of(problem.landmarks.begin(), problem.landmarks.end(),
                      [&](const PhotoLandmark& landmark) { return start.depth(landmark.lps) > 1; });
      if (!before) continue;
      const Solution solution = refined(problem, start, kPickedMm * problem.scale);
      if (solution.cost < best.cost && sees(solution.camera, problem, skin)) best = solution;
    }
  }
  return best;
}

CameraFit fit_of(const Problem& problem, const PhotoCamera& camera) {
  CameraFit fit;
  fit.camera = camera;
  double pixels = 0, mm = 0;
  for (const PhotoLandmark& landmark : problem.landmarks) {
    CameraFit::Residual residual;
    residual.pixels = (camera.pixel(landmark.lps) - landmark.pixel).norm();
    residual.mm = residual.pixels * camera.depth(landmark.lps) / camera.focal;
    pixels += residual.pixels * residual.pixels;
    mm += residual.mm * residual.mm;
    fit.residuals[landmark.name] = residual;
  }
  const auto count = static_cast<double>(problem.landmarks.size());
  fit.rms_pixels = std::sqrt(pixels / count);
  fit.rms_mm = std::sqrt(mm / count);
  fit.focal_35mm =
      camera.focal * kFilmDiagonal / (2 * (problem.centre.array() + 0.5).matrix().norm());
  return fit;
}

Problem mirrored(Problem problem) {
  for (PhotoLandmark& landmark : problem.landmarks) {
    landmark.pixel.x() = 2 * problem.centre.x() - landmark.pixel.x();
  }
  return problem;
}

std::string worst_of(const CameraFit& fit) {
  const auto worst =
      std::max_element(fit.residuals.begin(), fit.residuals.end(),
                       [](const auto& a, const auto& b) { return a.second.mm < b.second.mm; });
  return worst->first + " by " + in_mm(worst->second.mm);
}

/// Why landmarks that fit badly do so, where it can be told.
void check_fit(const Problem& problem, const SkinSight& skin, const Solution& found,
               const CameraFit& fit) {
  const bool any = std::isfinite(found.cost);
  if (any && fit.rms_mm < kLargestRms / 2) return;
  const Solution other = solved(mirrored(problem), skin);
  if (std::isfinite(other.cost) && (!any || other.cost < found.cost / 4)) {
    refuse("landmarks", "fit the photograph's mirror image better than the photograph",
           "the patient's left is on the right of a picture from the front: exchange the names of "
           "left and right, or give the photograph as the camera took it");
  }
  if (!any) {
    refuse("landmarks", "cannot be seen from any camera that would take such a picture",
           "pick only landmarks that the photograph shows, each on the side it is named for");
  }
  if (fit.rms_mm <= kLargestRms) return;
  refuse("landmarks",
         "do not fit the skin: " + in_mm(fit.rms_mm) + " RMS, worst is " + worst_of(fit),
         "pick that landmark again in the photograph and on the skin");
}

/// CameraFit::uncertainty_mm.
double uncertainty(const Problem& problem, const SkinSight& skin, const CameraFit& fit) {
  const PhotoCamera& camera = fit.camera;
  const auto count = static_cast<double>(problem.landmarks.size());
  const double free = std::max(1.0, 2 * count - 6);
  const double sigma = problem.scale * std::max(kPickedMm, fit.rms_mm * std::sqrt(count / free));
  const Matrix7d covariance = normal_equations(problem, camera, sigma).matrix.inverse();
  std::vector<double> mm;
  const Vector3d eye = camera.eye();
  const Points& vertices = skin.mesh().vertices;
  for (Eigen::Index v = 0; v < vertices.rows(); v += 7) {
    const Vector3d x = vertices.row(v);
    const bool near = std::any_of(problem.landmarks.begin(), problem.landmarks.end(),
                                  [&](const auto& l) { return (l.lps - x).norm() < 50; });
    if (!near || skin.normals().row(v).dot((eye - x).normalized()) < 0.3) continue;
    const Matrix27d d = derivative(camera, x) * camera.depth(x) / camera.focal;
    mm.push_back(std::sqrt((d * covariance * d.transpose()).trace()));
  }
  if (mm.empty()) return 0;
  const auto at = mm.begin() + static_cast<std::ptrdiff_t>(0.95 * double(mm.size() - 1));
  std::nth_element(mm.begin(), at, mm.end());
  return *at;
}

Problem checked_problem(std::span<const PhotoLandmark> landmarks, int width, int height,
                        const CameraOptions& options) {
  const auto least = static_cast<std::size_t>(least_landmarks(options));
  if (landmarks.size() < least) {
    refuse("landmarks", "are " + std::to_string(landmarks.size()) + ", too few to find the camera",
           "pick at least " + std::to_string(least));
  }
  if (options.focal_35mm && !(*options.focal_35mm >= 8 && *options.focal_35mm <= 2000)) {
    refuse("focal_35mm", "is no camera's focal length", "give 8 to 2000 mm, or leave it out");
  }
  for (const PhotoLandmark& landmark : landmarks) check_one(landmark, width, height);
  check_pairs(landmarks);
  const double scale = checked_shape(landmarks);
  return {{landmarks.begin(), landmarks.end()},
          {(width - 1) / 2.0, (height - 1) / 2.0},
          focal_pixels(options.focal_35mm.value_or(kUsualFocal), width, height),
          options.focal_35mm ? kKnownSpread : kUsualSpread,
          scale};
}

}  // namespace

Vector3d PhotoCamera::eye() const {
  return -camera_from_lps.rotation.transpose() * camera_from_lps.translation;
}

double PhotoCamera::depth(const Vector3d& lps) const {
  return camera_from_lps(lps).z();
}

Vector2d PhotoCamera::pixel(const Vector3d& lps) const {
  const Vector3d q = camera_from_lps(lps);
  return centre + focal * q.head<2>() / q.z();
}

Vector3d PhotoCamera::direction(const Vector2d& pixel) const {
  const Vector2d across = (pixel - centre) / focal;
  const Vector3d in_camera(across.x(), across.y(), 1);
  return (camera_from_lps.rotation.transpose() * in_camera).normalized();
}

int least_landmarks(const CameraOptions& options) {
  return options.focal_35mm ? 5 : 6;
}

CameraFit fit_camera(std::span<const PhotoLandmark> landmarks, int width, int height,
                     const SkinSight& skin, const CameraOptions& options) {
  const Problem problem = checked_problem(landmarks, width, height, options);
  const Solution found = solved(problem, skin);
  CameraFit fit;
  if (std::isfinite(found.cost)) fit = fit_of(problem, found.camera);
  check_fit(problem, skin, found, fit);
  fit.uncertainty_mm = uncertainty(problem, skin, fit);
  if (fit.uncertainty_mm > kLargestSpread) {
    refuse("landmarks", "hold the picture on the skin to " + in_mm(fit.uncertainty_mm) + " only",
           "add landmarks far from the others: eyes, ears, chin");
  }
  return fit;
}

}  // namespace gnathion
