#include "scan/scan_frame.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
constexpr int kCells = 64;
constexpr int kSteps = 12;  // of the profile through the nose, on either side

/// Points on the surface and the normals there.
struct Spread {
  Points points, normals;

  /// Those whose surface looks along the axis rather than aside: the edge of an open scan is no
  /// peak when it is seen from behind.
  Points facing(int axis, int forward) const {
    std::vector<int> rows;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      if (forward * normals(i, axis) > 0.3) rows.push_back(static_cast<int>(i));
    }
    return points(rows, Eigen::all);
  }
};

/// Points spread over the surface, the surface's box scaled into 0..1 along its longest side.
Spread spread_points(const TriangleMesh& surface) {
  std::vector<double> numbers, normals;
  const Points of_triangle = triangle_normals(surface);
  Eigen::Index f = 0;
  const Eigen::RowVector3d low =
      surface.vertices(surface.triangles.reshaped(), Eigen::all).colwise().minCoeff();
  const double size =
      (surface.vertices(surface.triangles.reshaped(), Eigen::all).colwise().maxCoeff() - low)
          .maxCoeff();
  for (const auto& t : surface.triangles.rowwise()) {
    const Eigen::RowVector3d a = (surface.vertices.row(t[0]) - low) / size,
                             b = (surface.vertices.row(t[1]) - low) / size,
                             c = (surface.vertices.row(t[2]) - low) / size;
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int steps = std::clamp(static_cast<int>(std::ceil(2 * longest * kCells)), 1, 4 * kCells);
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        const Eigen::RowVector3d p =
            a + (b - a) * (double(i) / steps) + (c - a) * (double(j) / steps);
        numbers.insert(numbers.end(), p.begin(), p.end());
        normals.insert(normals.end(), of_triangle.row(f).begin(), of_triangle.row(f).end());
      }
    }
    ++f;
  }
  const auto count = static_cast<Eigen::Index>(numbers.size() / 3);
  return {Eigen::Map<const Points>(numbers.data(), count, 3),
          Eigen::Map<const Points>(normals.data(), count, 3)};
}

int cell_of(double x) {
  return std::clamp(static_cast<int>(x * kCells), 0, kCells - 1);
}

/// The share of the cells the surface runs through whose mirror image along the axis has surface in
/// it or beside it; the mirror stands where this is largest, near the middle.
double symmetry(const Points& points, int axis) {
  constexpr int n = kCells / 2;  // coarser: a face is not that symmetric
  std::array<std::vector<bool>, 2> filled{std::vector<bool>(n * n * n),
                                          std::vector<bool>(n * n * n)};
  const auto index = [](const std::array<int, 3>& c) { return (c[0] * n + c[1]) * n + c[2]; };
  std::vector<std::array<int, 3>> cells;
  int high = 0;
  for (const auto& p : points.rowwise()) {
    const std::array<int, 3> c{cell_of(p[0]) / 2, cell_of(p[1]) / 2, cell_of(p[2]) / 2};
    if (filled[0][index(c)]) continue;
    filled[0][index(c)] = true;
    cells.push_back(c);
    high = std::max(high, c[axis]);
    for (int d = -1; d <= 1; ++d) {
      std::array<int, 3> beside = c;
      beside[axis] = std::clamp(c[axis] + d, 0, n - 1);
      filled[1][index(beside)] = true;
    }
  }
  double best = 0;
  for (int sum = high - 4; sum <= high + 4; ++sum) {
    int matched = 0;
    for (std::array<int, 3> c : cells) {
      c[axis] = sum - c[axis];
      if (c[axis] >= 0 && c[axis] < n && filled[1][index(c)]) ++matched;
    }
    best = std::max(best, static_cast<double>(matched) / static_cast<double>(cells.size()));
  }
  return best;
}

/// How the surface falls away beside its point farthest out in one direction.
struct Peak {
  double width = 1;  ///< across the axis of symmetry, to where it is 0.06 lower: of a nose small
  /// Mean fall within 0.06 up and down the third axis: of a nose larger below.
  double above = 0, below = 0;
};

/// Mean fall from `top` along the line of symmetry, on one side (`sign`) of the tip.
double fall(const Points& points, const Eigen::RowVector3d& tip, int left, int up, int front,
            int forward, int sign) {
  constexpr double kReach = 0.06, kHalfBand = 0.02;
  std::array<double, kSteps> nearest;
  nearest.fill(1);
  for (const auto& p : points.rowwise()) {
    const double along = sign * (p[up] - tip[up]);
    if (along <= 0 || along >= kReach || std::abs(p[left] - tip[left]) > kHalfBand) continue;
    double& own = nearest[static_cast<std::size_t>(along / kReach * kSteps)];
    own = std::min(own, forward * (tip[front] - p[front]));
  }
  double sum = 0;
  for (const double step : nearest) sum += std::min(step, 0.1);
  return sum / kSteps;
}

Peak peak_of(const Points& points, int left, int up, int front, int forward) {
  Eigen::VectorXd depth = Eigen::VectorXd::Constant(kCells, -2);
  Eigen::Index best = 0;
  (forward * points.col(front)).maxCoeff(&best);
  const Eigen::RowVector3d tip = points.row(best);
  for (const auto& p : points.rowwise()) {
    if (std::abs(p[up] - tip[up]) > 1.0 / kCells) continue;
    double& deepest = depth[cell_of(p[left])];
    deepest = std::max(deepest, forward * p[front]);
  }
  int width = 0;
  for (const int step : {1, -1}) {
    for (int i = cell_of(tip[left]); i >= 0 && i < kCells; i += step, ++width) {
      if (depth[i] > -2 && depth[i] < forward * tip[front] - 0.06) break;
    }
  }
  return {static_cast<double>(width) / kCells, fall(points, tip, left, up, front, forward, 1),
          fall(points, tip, left, up, front, forward, -1)};
}

std::string axis_name(int axis, double sign) {
  return std::string(sign > 0 ? "+" : "-") + "xyz"[axis];
}

/// A way that the patient may look, and the peak that would be his nose then.
struct Way {
  int up, front, sign;
  Peak peak;
};

/// The four ways across the axis of symmetry, that with the narrowest peak first.
std::vector<Way> ways_across(const Spread& spread, int left) {
  const int u = (left + 1) % 3, v = (left + 2) % 3;
  std::vector<Way> ways;
  for (const auto& [up, front] : {std::pair{u, v}, {v, u}}) {
    for (const int sign : {1, -1}) {
      const Points facing = spread.facing(front, sign);
      // A peak that nothing of the surface looks at is as wide as can be.
      const Peak peak = facing.rows() == 0 ? Peak() : peak_of(facing, left, up, front, sign);
      ways.push_back({up, front, sign, peak});
    }
  }
  std::stable_sort(ways.begin(), ways.end(),
                   [](const Way& a, const Way& b) { return a.peak.width < b.peak.width; });
  return ways;
}

/// Whether one axis is more symmetric than the others, one peak narrower, and one side of it
/// steeper.
bool is_clear(std::array<double, 3> mirror, const std::vector<Way>& ways) {
  std::sort(mirror.begin(), mirror.end());
  const Peak& nose = ways[0].peak;
  return mirror[2] - mirror[1] > 0.1 && nose.width < 0.75 * ways[1].peak.width &&
         std::abs(nose.above - nose.below) > 0.15 * (nose.above + nose.below);
}

}  // namespace

ProposedAxes scan_axes(const TriangleMesh& surface) {
  if (surface_area(surface) <= 0) {
    return {Eigen::Matrix3d::Identity(), Confidence::low, "the scan has no area to look at"};
  }
  const Spread spread = spread_points(surface);
  std::array<double, 3> mirror{};
  for (int axis = 0; axis < 3; ++axis) mirror[axis] = symmetry(spread.points, axis);
  const int left =
      static_cast<int>(std::max_element(mirror.begin(), mirror.end()) - mirror.begin());
  const std::vector<Way> ways = ways_across(spread, left);
  const Way& nose = ways.front();
  const double up_sign = nose.peak.above <= nose.peak.below ? 1 : -1;
  ProposedAxes axes;
  axes.lps_from_scan.setZero();
  axes.lps_from_scan(1, nose.front) = -nose.sign;  // the front is anterior, LPS's −y
  axes.lps_from_scan(2, nose.up) = up_sign;
  axes.lps_from_scan.row(0) = axes.lps_from_scan.row(1).cross(axes.lps_from_scan.row(2));
  axes.confidence = is_clear(mirror, ways) ? Confidence::fair : Confidence::low;
  axes.reason = std::string("it is most symmetric along ") + "xyz"[left] +
                ", has its narrowest peak, which may be the nose, towards " +
                axis_name(nose.front, nose.sign) + ", and that falls off less steeply towards " +
                axis_name(nose.up, up_sign);
  return axes;
}

Similarity checked_similarity(const Eigen::Matrix4d& lps_from_scan, const std::string& subject) {
  const auto refuse = [&subject](const char* problem, const char* remedy) {
    throw Error(ErrorKind::input, subject, problem, remedy);
  };
  const Eigen::Matrix3d a = lps_from_scan.topLeftCorner<3, 3>();
  if (!lps_from_scan.allFinite())
    refuse("the transform has a number that is not finite", "give 16 numbers");
  if (lps_from_scan.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    refuse("the transform's last row is not 0 0 0 1", "give rotation, scale and translation only");
  }
  const double volume = a.determinant();
  if (volume < 0) {
    refuse("the transform mirrors the patient: left would be right",
           "turn the axes instead, with an even number of them reversed");
  }
  const double scale = std::cbrt(volume);
  if (!(scale > 0) || !(a.transpose() * a / (scale * scale)).isIdentity(1e-6)) {
    refuse("the transform shears the scan or scales its axes differently",
           "give one scale for all axes and a rotation");
  }
  return {scale, a / scale, lps_from_scan.topRightCorner<3, 1>()};
}

}  // namespace gnathion
