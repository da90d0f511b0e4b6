#include "tissue/lip_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/bsp_tree.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNothing = -1;  // mm: the groove's depth where the face has no such place

/// The face seen from the front: how far back (y, mm) its first point lies at a place x, z.
class Relief {
 public:
  explicit Relief(const TriangleMesh& face)
      : front_(face.vertices.col(1).minCoeff() - 1), tree_(face) {}

  std::optional<double> back_at(double x, double z) const {
    constexpr double kReach = 120;  // mm behind the farthest forward point
    const auto hit = tree_.first_hit({x, front_, z}, Vector3d::UnitY(), kReach);
    if (!hit) return std::nullopt;
    return front_ + hit->distance;
  }

  /// By how much a place lies behind the middle of those 2.5 mm above and below it, mm.
  double groove_at(double x, double z) const {
    constexpr double kBeside = 2.5;
    const auto here = back_at(x, z), above = back_at(x, z + kBeside),
               below = back_at(x, z - kBeside);
    if (!here || !above || !below) return kNothing;
    return *here - (*above + *below) / 2;
  }

 private:
  double front_;
  BspTree tree_;
};

struct Mouth {
  Vector3d stomion = Vector3d::Zero();
  double right = 0, left = 0;  ///< x of the corners, mm
  double z_right = 0, z_left = 0;
  bool corners_known = false;
};

std::optional<Vector3d> landmark(const std::map<std::string, Vector3d>& landmarks,
                                 const std::string& name) {
  const auto found = landmarks.find(name);
  if (found == landmarks.end()) return std::nullopt;
  return found->second;
}

/// The part of the face within a box about a place.
TriangleMesh around(const TriangleMesh& face, const Vector3d& low, const Vector3d& high) {
  std::vector<bool> keep(static_cast<std::size_t>(face.triangles.rows()), false);
  for (Eigen::Index t = 0; t < face.triangles.rows(); ++t) {
    for (const int v : face.triangles.row(t)) {
      const Eigen::Array3d x = face.vertices.row(v);
      if ((x >= low.array()).all() && (x <= high.array()).all()) keep[t] = true;
    }
  }
  return sub_mesh(face, keep).mesh;
}

/// Where the profile below the nose tip turns from back to front again, from above, mm: below the
/// nose, between the lips, between lip and chin. Only where it comes forward by 0.1 mm on both
/// sides.
std::vector<double> grooves_below(const Relief& relief, const Vector3d& nose_tip) {
  constexpr double kFirst = 6, kLast = 80, kStep = 0.5;  // mm below the tip
  constexpr double kForward = 0.1;                       // mm
  std::vector<double> z, back;
  for (double below = kFirst; below <= kLast; below += kStep) {
    const auto here = relief.back_at(nose_tip[0], nose_tip[2] - below);
    if (!here) break;
    z.push_back(nose_tip[2] - below);
    back.push_back(*here);
  }
  std::vector<double> grooves;
  // A groove is left once the profile has come forward again from the farthest back since the last
  // time that it began to go back.
  std::size_t deepest = 0, foremost = 0;
  bool going_back = true;
  for (std::size_t k = 1; k < z.size(); ++k) {
    if (going_back) {
      if (back[k] > back[deepest]) deepest = k;
      if (back[deepest] - back[k] < kForward) continue;
      grooves.push_back(z[deepest]);
      going_back = false;
      foremost = k;
    } else {
      if (back[k] < back[foremost]) foremost = k;
      if (back[k] - back[foremost] < kForward) continue;
      going_back = true;
      deepest = k;
    }
  }
  return grooves;
}

/// The place between the lips on the profile below the nose tip: the second of its grooves.
std::optional<Vector3d> stomion_below(const Relief& relief, const Vector3d& nose_tip,
                                      std::vector<std::string>& doubts) {
  constexpr double kHighest = 18, kLowest = 62;  // mm below the tip
  std::vector<double> grooves = grooves_below(relief, nose_tip);
  const bool clear = grooves.size() >= 3;
  std::optional<double> z;
  if (clear) z = grooves[1];
  if (!clear || nose_tip[2] - *z < kHighest || nose_tip[2] - *z > kLowest) {
    doubts.emplace_back("The profile does not show nose, lips and chin clearly.");
    double sharpest = 0;
    z.reset();
    for (const double groove : grooves) {
      if (nose_tip[2] - groove < kHighest || nose_tip[2] - groove > kLowest) continue;
      const double depth = relief.groove_at(nose_tip[0], groove);
      if (depth <= sharpest) continue;
      sharpest = depth;
      z = groove;
    }
  }
  if (!z) return std::nullopt;
  return Vector3d(nose_tip[0], *relief.back_at(nose_tip[0], *z), *z);
}

/// Where the mouth is looked for: columns a millimetre wide from right to left, rows about a curve
/// through its landmarks.
struct GrooveGrid {
  static constexpr double kStep = 0.5;  // mm in z from row to row
  const Mouth& mouth;
  int columns = 1 + static_cast<int>(std::lround(mouth.left - mouth.right));
  int half = mouth.corners_known ? 10 : 14;
  int rows = 2 * half + 1;

  double off(int row) const { return kStep * (row - half); }  ///< mm above the curve
  double middle(int column) const {
    const double x = mouth.right + column;
    const bool right = x < mouth.stomion[0];
    const double end = right ? mouth.right : mouth.left, z = right ? mouth.z_right : mouth.z_left;
    const double part = (x - mouth.stomion[0]) / (end - mouth.stomion[0]);
    return mouth.stomion[2] + part * part * (z - mouth.stomion[2]);
  }
  /// Whether the line must pass near the curve here: at a landmark.
  bool is_tied(int column) const {
    const int at_stomion = static_cast<int>(std::lround(mouth.stomion[0] - mouth.right));
    return column == at_stomion || (mouth.corners_known && (column == 0 || column == columns - 1));
  }
  /// What it costs to pass here.
  double cost(const Relief& relief, int row, int column) const {
    constexpr double kNarrow = 0.002;  // mm of groove for a millimetre off the curve, squared
    if (is_tied(column) && std::abs(off(row)) > 1) return kInfinity;
    const double groove =
        std::clamp(relief.groove_at(mouth.right + column, middle(column) + off(row)), -1.0, 2.0);
    return kNarrow * off(row) * off(row) - groove;
  }
};

/// Heights along the groove, one a millimetre from right to left: the way that stays in the groove
/// and near the line through the mouth's landmarks, with little up and down (dynamic programming).
std::vector<double> groove_heights(const Relief& relief, const Mouth& mouth) {
  constexpr double kSteep = 0.06;  // mm of groove for a step of one millimetre up or down, squared
  const GrooveGrid grid{mouth};
  Eigen::MatrixXd cost(grid.rows, grid.columns);
  Eigen::MatrixXi before = Eigen::MatrixXi::Zero(grid.rows, grid.columns);
  for (int c = 0; c < grid.columns; ++c) {
    for (int r = 0; r < grid.rows; ++r) {
      cost(r, c) = grid.cost(relief, r, c);
      if (c == 0) continue;
      double least = kInfinity;
      for (int from = std::max(0, r - 3); from <= std::min(grid.rows - 1, r + 3); ++from) {
        const double up = grid.off(r) - grid.off(from) + grid.middle(c) - grid.middle(c - 1);
        const double there = cost(from, c - 1) + kSteep * up * up;
        if (there >= least) continue;
        least = there;
        before(r, c) = from;
      }
      cost(r, c) += least;
    }
  }
  std::vector<double> heights(static_cast<std::size_t>(grid.columns));
  Eigen::Index row = 0;
  cost.col(grid.columns - 1).minCoeff(&row);
  for (int c = grid.columns - 1; c >= 0; --c) {
    heights[static_cast<std::size_t>(c)] = grid.middle(c) + grid.off(static_cast<int>(row));
    row = before(static_cast<int>(row), c);
  }
  return heights;
}

struct Groove {
  std::vector<Vector3d> line;  ///< a point a millimetre
  std::vector<double> depth;   ///< mm, mean over 5 mm
};

Groove groove_along(const Relief& relief, const Mouth& mouth) {
  Groove groove;
  const std::vector<double> heights = groove_heights(relief, mouth);
  std::vector<double> depth;
  for (std::size_t c = 0; c < heights.size(); ++c) {
    const double x = mouth.right + static_cast<double>(c);
    const auto back = relief.back_at(x, heights[c]);
    groove.line.emplace_back(x, back.value_or(mouth.stomion[1]), heights[c]);
    depth.push_back(back ? relief.groove_at(x, heights[c]) : kNothing);
  }
  const int count = static_cast<int>(depth.size());
  for (int c = 0; c < count; ++c) {
    const int first = std::max(0, c - 2), last = std::min(count - 1, c + 2);
    double sum = 0;
    for (int k = first; k <= last; ++k) sum += depth[static_cast<std::size_t>(k)];
    groove.depth.push_back(sum / (last - first + 1));
  }
  return groove;
}

/// Ends the groove where it fades on either side of the stomion.
void end_at_corners(double stomion_x, Groove& groove, std::vector<std::string>& doubts) {
  constexpr double kFades = 0.25;                 // of the depth within 10 mm of the stomion
  constexpr double kNarrowest = 18, kUnlike = 6;  // mm from the stomion; between the sides
  doubts.emplace_back(
      "The corners of the mouth are not marked as landmarks; the line ends where the groove "
      "between the lips fades.");
  double middle = 0;
  int count = 0;
  for (std::size_t c = 0; c < groove.line.size(); ++c) {
    if (std::abs(groove.line[c][0] - stomion_x) > 10) continue;
    middle += groove.depth[c];
    ++count;
  }
  middle /= count;
  const auto fades = [&](std::size_t c) {
    return groove.depth[c] < kFades * middle &&
           std::abs(groove.line[c][0] - stomion_x) > kNarrowest;
  };
  std::size_t first = 0, last = groove.line.size() - 1;
  const auto at = static_cast<std::size_t>(std::lround(stomion_x - groove.line.front()[0]));
  for (std::size_t c = at; c > 0 && first == 0; --c) first = fades(c) ? c : 0;
  for (std::size_t c = at; c < last; ++c) last = fades(c) ? c : last;
  const double right = stomion_x - groove.line[first][0], left = groove.line[last][0] - stomion_x;
  if (std::abs(right - left) > kUnlike) {
    doubts.emplace_back("Its two halves are not equally long.");
  }
  groove = {{groove.line.begin() + static_cast<std::ptrdiff_t>(first),
             groove.line.begin() + static_cast<std::ptrdiff_t>(last) + 1},
            {groove.depth.begin() + static_cast<std::ptrdiff_t>(first),
             groove.depth.begin() + static_cast<std::ptrdiff_t>(last) + 1}};
}

/// Every third point, and both ends.
std::vector<Vector3d> thinned(const std::vector<Vector3d>& line) {
  std::vector<Vector3d> some;
  for (std::size_t k = 0; k + 2 < line.size(); k += 3) some.push_back(line[k]);
  some.push_back(line.back());
  return some;
}

std::optional<Mouth> find_mouth(const TriangleMesh& face,
                                const std::map<std::string, Vector3d>& landmarks,
                                std::vector<std::string>& doubts) {
  Mouth mouth;
  const auto right = landmark(landmarks, "mouth_corner_right");
  const auto left = landmark(landmarks, "mouth_corner_left");
  mouth.corners_known = right && left && (*left)[0] - (*right)[0] > 10;
  std::optional<Vector3d> stomion = landmark(landmarks, "stomion");
  if (!stomion && mouth.corners_known) stomion = (*right + *left) / 2;
  if (!stomion) {
    Eigen::Index tip = 0;
    face.vertices.col(1).minCoeff(&tip);
    const Vector3d nose = face.vertices.row(tip);
    const Relief relief(around(face, nose - Vector3d(8, 10, 90), nose + Vector3d(8, 90, 10)));
    stomion = stomion_below(relief, nose, doubts);
  }
  if (!stomion) return std::nullopt;
  constexpr double kWidest = 34;  // mm from stomion to a corner
  mouth.stomion = *stomion;
  mouth.right = mouth.corners_known ? (*right)[0] : mouth.stomion[0] - kWidest;
  mouth.left = mouth.corners_known ? (*left)[0] : mouth.stomion[0] + kWidest;
  mouth.z_right = mouth.corners_known ? (*right)[2] : mouth.stomion[2];
  mouth.z_left = mouth.corners_known ? (*left)[2] : mouth.stomion[2];
  return mouth;
}

}  // namespace

LipLineProposal propose_lip_line(const TriangleMesh& face,
                                 const std::map<std::string, Vector3d>& landmarks) {
  LipLineProposal proposal;
  if (face.vertices.rows() == 0) return {{}, {"There is no face."}};
  const std::optional<Mouth> mouth = find_mouth(face, landmarks, proposal.doubts);
  if (!mouth || mouth->stomion[0] <= mouth->right || mouth->stomion[0] >= mouth->left) {
    proposal.doubts = {"No mouth was found below the tip of the nose."};
    return proposal;
  }
  const TriangleMesh part =
      around(face, mouth->stomion - Vector3d(45, 30, 20), mouth->stomion + Vector3d(45, 60, 20));
  if (part.vertices.rows() == 0) return {{}, {"There is no face at the mouth's landmarks."}};
  Groove groove = groove_along(Relief(part), *mouth);
  if (!mouth->corners_known) end_at_corners(mouth->stomion[0], groove, proposal.doubts);
  constexpr double kSeen = 0.15;  // mm
  double mean = 0;
  for (const double depth : groove.depth) mean += depth / static_cast<double>(groove.depth.size());
  if (mean < kSeen) {
    proposal.doubts.emplace_back("The groove between the lips hardly shows in the shape.");
  }
  proposal.line = thinned(groove.line);
  return proposal;
}

}  // namespace gnathion
