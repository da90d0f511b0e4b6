#include "registration/automatic_start.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "registration/nearest_sample.h"
#include "registration/parallel.h"
#include "registration/prominence.h"

namespace gnathion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kApart = 15;  // mm and degrees between places that count as different
constexpr double kReach = 14;  // mm

/// 1 where the point lies on the skin and faces as it does, 0 where it is `kernel` mm away.
double match(const Vector3d& p, const Vector3d& normal, const NearestSample& skin, double kernel) {
  const int i = skin.at(p);
  if (i < 0) return 0;
  const Vector3d n = skin.sample().normals.row(i);
  const double facing = n.dot(normal);
  if (facing < 0.5) return 0;
  const double d = n.dot(p - skin.sample().points.row(i).transpose()) / kernel;
  return std::max(0.0, 1 - d * d) * facing;
}

double matched_area(const SurfaceSample& scan, const RigidMotion& m, const NearestSample& skin,
                    double kernel) {
  double sum = 0;
  for (Eigen::Index i = 0; i < scan.size(); ++i) {
    sum += match(m(scan.points.row(i)), m.rotation * scan.normals.row(i).transpose(), skin, kernel);
  }
  return sum * scan.area;
}

struct Guess {
  RigidMotion motion;
  double score = 0;
};

/// Turns of the forward direction about itself and tilts of it, each as a rotation that follows one
/// that brings the prominences' directions together.
std::vector<Matrix3d> turns_about(const Vector3d& axis) {
  constexpr double kTilt = 18 * M_PI / 180;
  const Vector3d side = axis.unitOrthogonal(), up = axis.cross(side);
  std::vector<Matrix3d> turns;
  for (const double a : {0.0, -kTilt, kTilt}) {
    for (const double b : {0.0, -kTilt, kTilt}) {
      const Matrix3d tilt =
          (Eigen::AngleAxisd(a, side) * Eigen::AngleAxisd(b, up)).toRotationMatrix();
      for (int t = 0; t < 24; ++t) {
        turns.push_back(tilt * Eigen::AngleAxisd(t * M_PI / 12, axis).toRotationMatrix());
      }
    }
  }
  return turns;
}

/// The scan's points near a prominence: shoulders far from it do not vote.
SurfaceSample near(const SurfaceSample& scan, const Vector3d& centre) {
  constexpr double kFace = 110;  // mm
  SurfaceSample part{Points(scan.size(), 3), Points(scan.size(), 3), {}, scan.area, scan.spacing};
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < scan.size(); ++i) {
    if ((scan.points.row(i).transpose() - centre).norm() > kFace) continue;
    part.points.row(kept) = scan.points.row(i);
    part.normals.row(kept++) = scan.normals.row(i);
  }
  part.points.conservativeResize(kept, 3);
  part.normals.conservativeResize(kept, 3);
  return part;
}

bool alike(const RigidMotion& a, const RigidMotion& b, const Vector3d& at, double mm,
           double degrees) {
  const double angle = Eigen::AngleAxisd(a.rotation * b.rotation.transpose()).angle();
  return angle < degrees * M_PI / 180 && (a(at) - b(at)).norm() < mm;
}

/// The best, no two alike; `at` is a place in the scan where they are compared.
std::vector<Guess> best_of(std::vector<Guess> guesses, const Vector3d& at, std::size_t most,
                           double mm, double degrees) {
  std::sort(guesses.begin(), guesses.end(),
            [](const Guess& a, const Guess& b) { return a.score > b.score; });
  std::vector<Guess> best;
  for (const Guess& guess : guesses) {
    if (best.size() == most) break;
    const bool known = std::any_of(best.begin(), best.end(), [&](const Guess& other) {
      return alike(guess.motion, other.motion, at, mm, degrees);
    });
    if (!known) best.push_back(guess);
  }
  return best;
}

/// One point-to-plane step with pairs from the table.
void improve(const SurfaceSample& scan, const NearestSample& skin, double kernel, RigidMotion& m) {
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6d side = Vector6d::Zero();
  const Vector3d centre = m(scan.points.colwise().mean().transpose());
  constexpr double kArm = 80;  // mm, so that turns and translations weigh alike
  for (Eigen::Index i = 0; i < scan.size(); ++i) {
    const Vector3d p = m(scan.points.row(i));
    const int k = skin.at(p);
    if (k < 0) continue;
    const Vector3d n = skin.sample().normals.row(k);
    if (n.dot(m.rotation * scan.normals.row(i).transpose()) < 0.5) continue;
    const double d = n.dot(p - skin.sample().points.row(k).transpose());
    const double t = d / kernel;
    if (t * t >= 1) continue;
    Vector6d j;
    j << ((p - centre) / kArm).cross(n), n;
    const double w = (1 - t * t) * (1 - t * t);
    matrix += w * j * j.transpose();
    side -= w * d * j;
  }
  matrix.diagonal().array() += 1e-3 * (1 + matrix.trace());
  const Vector6d x = matrix.ldlt().solve(side);
  const Vector3d turn = x.head<3>() / kArm;
  const double angle = turn.norm();
  if (angle > 0) {
    const Matrix3d rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    m.translation = rotation * (m.translation - centre) + centre;
    m.rotation = rotation * m.rotation;
  }
  m.translation += x.tail<3>();
}

std::vector<Guess> guesses_from(const Prominence& nose, const SurfaceSample& scan,
                                const std::vector<Prominence>& places, const NearestSample& skin) {
  constexpr std::size_t kEach = 12;
  const SurfaceSample face = near(scan, nose.at);
  std::vector<Guess> guesses;
  for (const Prominence& place : places) {
    const Matrix3d together =
        Eigen::Quaterniond::FromTwoVectors(nose.facing, place.facing).toRotationMatrix();
    for (const Matrix3d& turn : turns_about(place.facing)) {
      Guess guess;
      guess.motion.rotation = turn * together;
      guess.motion.translation = place.at - guess.motion.rotation * nose.at;
      guess.score = matched_area(face, guess.motion, skin, 10);
      guesses.push_back(guess);
    }
  }
  return best_of(std::move(guesses), nose.at, kEach, 10, 12);
}

}  // namespace

std::vector<PossibleStart> automatic_starts(const SampledSurface& photograph, double mm_per_unit,
                                            const SkinTarget& target, const StartEffort& effort,
                                            std::size_t most, const Progress& progress) {
  const auto in_mm = [&](double spacing) {
    SurfaceSample s = photograph.sample(spacing / mm_per_unit, 6 / mm_per_unit);
    s.points *= mm_per_unit;
    s.area *= mm_per_unit * mm_per_unit;
    return s;
  };
  const SurfaceSample fine = in_mm(5), coarse = in_mm(10);
  const NearestSample skin(target.sample(), kReach);
  const std::vector<Prominence> noses = highest(prominences(fine), effort.prominences);
  std::vector<std::vector<Guess>> from(noses.size());
  for_each_in_parallel(noses.size(), [&](std::size_t i) {
    progress.check();
    from[i] = guesses_from(noses[i], coarse, target.forward(), skin);
  });
  std::vector<Guess> guesses;
  for (const std::vector<Guess>& some : from)
    guesses.insert(guesses.end(), some.begin(), some.end());
  if (guesses.empty()) return {};
  const Vector3d middle = coarse.points.colwise().mean();
  guesses = best_of(std::move(guesses), middle, effort.improved, 10, 10);
  for_each_in_parallel(guesses.size(), [&](std::size_t g) {
    progress.check();
    Guess& guess = guesses[g];
    for (int i = 0; i < 24; ++i) improve(coarse, skin, std::max(5.0, kReach - i), guess.motion);
    guess.score = matched_area(coarse, guess.motion, skin, 4);
  });
  std::vector<PossibleStart> starts;
  for (const Guess& guess : best_of(std::move(guesses), middle, most, kApart, kApart)) {
    starts.push_back({{mm_per_unit, guess.motion.rotation, guess.motion.translation}, guess.score});
  }
  return starts;
}

}  // namespace gnathion
