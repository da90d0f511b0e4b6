#include "bone/jaw_anatomy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/error.h"
#include "bone/section_spans.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr double neck_depth = 40;       // mm that the neck's bones lie behind the face at least
constexpr double arch_depth = 45;       // mm from the front teeth to behind the second molars
constexpr double arch_half_width = 40;  // mm, more than any dental arch

[[noreturn]] void not_found(const std::string& what, const std::string& remedy) {
  throw Error(ErrorKind::anatomy, "preset", what + " was not found on the bone", remedy);
}

/// The most forward place of each layer of one millimetre, among the places within `half_width` of
/// the midline. Layer 0 begins at `bottom`.
struct Profile {
  double bottom;
  std::vector<double> front;  // y, or infinity

  Profile(const Points& points, double midline, double half_width)
      : bottom(points.col(2).minCoeff()) {
    const double height = points.col(2).maxCoeff() - bottom;
    front.assign(static_cast<std::size_t>(height) + 1, nowhere);
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
      if (std::abs(points(v, 0) - midline) > half_width) continue;
      double& y = front[static_cast<std::size_t>(points(v, 2) - bottom)];
      y = std::min(y, points(v, 1));
    }
  }
  double z(std::size_t layer) const { return bottom + static_cast<double>(layer) + 0.5; }
  std::size_t layer(double z) const {
    const double at = std::clamp(z - bottom, 0.0, static_cast<double>(front.size() - 1));
    return static_cast<std::size_t>(at);
  }
};

/// The lowest layer of the face: from its most forward one down to where the neck begins.
double chin_bottom(const Profile& profile) {
  const auto foremost = std::min_element(profile.front.begin(), profile.front.end());
  auto layer = static_cast<std::size_t>(foremost - profile.front.begin());
  const double limit = *foremost + neck_depth;
  int behind = 0;  // layers on end
  std::size_t lowest = layer;
  while (layer > 0 && behind < 6) {
    --layer;
    behind = profile.front[layer] > limit ? behind + 1 : 0;
    if (behind == 0) lowest = layer;
  }
  return profile.bottom + static_cast<double>(lowest);
}

/// Finds midline and pogonion above a menton at z.
void find_chin(const Points& points, JawAnatomy& jaw) {
  constexpr double chin_height = 22, chin_depth = 12;
  double front = nowhere, left = -nowhere, right = nowhere;
  const auto is_chin = [&](Eigen::Index v) {
    return points(v, 2) >= jaw.menton_z && points(v, 2) <= jaw.menton_z + chin_height;
  };
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if (is_chin(v)) front = std::min(front, points(v, 1));
  }
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if (!is_chin(v) || points(v, 1) > front + chin_depth) continue;
    left = std::max(left, points(v, 0));
    right = std::min(right, points(v, 0));
  }
  jaw.midline_x = 0.5 * (left + right);
  jaw.pogonion = {jaw.midline_x, nowhere, jaw.menton_z};
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if (!is_chin(v) || std::abs(points(v, 0) - jaw.midline_x) > 8) continue;
    if (points(v, 1) < jaw.pogonion.y()) jaw.pogonion.tail<2>() = points.row(v).tail<2>();
  }
  if (!std::isfinite(jaw.pogonion.y())) {
    not_found("the chin", "place a blade or a box by hand");
  }
}

/// The front of the bone between two heights, wide enough that every row of a section is whole.
TriangleMesh front_part(const TriangleMesh& bone, double low, double high, double back) {
  std::vector<bool> keep(static_cast<std::size_t>(bone.triangles.rows()));
  for (std::size_t t = 0; t < keep.size(); ++t) {
    const auto x = bone.vertices.row(bone.triangles(static_cast<Eigen::Index>(t), 0));
    keep[t] = x.z() >= low && x.z() <= high && x.y() <= back;
  }
  return sub_mesh(bone, keep).mesh;
}

/// A plane across the dental arch through (midline, front, z) that rises to the back.
Rectangle arch_plane(double midline, double front, double z, double rise) {
  const Eigen::Vector3d back = Eigen::Vector3d(0, 1, rise).normalized();
  const Eigen::Vector3d start(midline, front, z);
  return {start + 0.5 * arch_depth * back,      Eigen::Vector3d::UnitX(), back,
          Eigen::Vector3d::UnitX().cross(back), arch_half_width,          0.5 * arch_depth};
}

double section_area(const TriangleMesh& bone, const Rectangle& plane) {
  std::vector<std::uint8_t> codes(static_cast<std::size_t>(bone.vertices.rows()));
  for (std::size_t v = 0; v < codes.size(); ++v) {
    const Eigen::Vector3d x = bone.vertices.row(static_cast<Eigen::Index>(v));
    codes[v] = (x - plane.centre).dot(plane.normal) >= 0 ? 1 : 0;
  }
  std::vector<int> crossing;
  for (Eigen::Index t = 0; t < bone.triangles.rows(); ++t) {
    const auto code = [&](int k) { return codes[static_cast<std::size_t>(bone.triangles(t, k))]; };
    if (code(0) != code(1) || code(1) != code(2)) crossing.push_back(static_cast<int>(t));
  }
  const RectangleSection section = section_of(bone, plane, crossing, codes, 1, 0.5);
  double area = 0;
  for (const Span& span : section.spans) area += (span.end - span.begin) * section.row_height;
  return area;
}

/// Heights between which the bite is looked for.
std::pair<double, double> bite_range(const JawAnatomy& jaw,
                                     const std::map<std::string, Eigen::Vector3d>& landmarks) {
  const auto at = [&](const char* name) -> std::optional<double> {
    const auto found = landmarks.find(name);
    return found == landmarks.end() ? std::nullopt : std::optional(found->second.z());
  };
  if (const auto stomion = at("stomion")) return {*stomion - 8, *stomion + 5};
  const auto upper = at("upper_lip"), lower = at("lower_lip");
  if (upper && lower) return {*lower - 6, *upper + 2};
  // An adult's lower front teeth end 35 to 50 mm above the menton (Farkas 1994).
  return {jaw.menton_z + 28, jaw.menton_z + 55};
}

/// The bite is where a plane through the arches meets least bone.
void find_bite(const TriangleMesh& bone, const std::pair<double, double>& range, JawAnatomy& jaw) {
  const Profile whole(bone.vertices, jaw.midline_x, arch_half_width);
  double front = nowhere;
  for (std::size_t l = whole.layer(range.first); l <= whole.layer(range.second); ++l) {
    front = std::min(front, whole.front[l]);
  }
  const TriangleMesh part =
      front_part(bone, range.first - 15, range.second + 15, front + arch_depth + 15);
  const auto area = [&](double z, double rise) {
    return section_area(part, arch_plane(jaw.midline_x, front, z, rise));
  };
  double least = nowhere;
  for (double rise = -0.18; rise < 0.19; rise += 0.06) {
    for (double z = range.first; z <= range.second; z += 1) {
      const double here = area(z, rise);
      if (here >= least) continue;
      least = here;
      jaw.bite = {jaw.midline_x, front, z};
      jaw.bite_rise = rise;
    }
  }
  // Teeth and their roots on both sides.
  for (const double beside : {-8.0, 8.0}) {
    if (area(jaw.bite.z() + beside, jaw.bite_rise) > std::max(200.0, 1.02 * least)) continue;
    not_found("the bite", "give the landmark \"stomion\" on the skin, or place a box by hand");
  }
}

/// Above the upper teeth the midline goes back where the opening of the nose begins.
void find_nasal_floor(const TriangleMesh& bone, JawAnatomy& jaw) {
  const Profile middle(bone.vertices, jaw.midline_x, 3);
  const std::size_t start = middle.layer(jaw.bite.z() + 12), end = middle.layer(jaw.bite.z() + 40);
  double front = nowhere;
  for (std::size_t l = start; l <= end; ++l) {
    if (middle.front[l] > front + 7) {
      jaw.nasal_floor_z = middle.z(l) - 0.5;
      return;
    }
    front = std::min(front, middle.front[l]);
  }
  jaw.nasal_floor_z = jaw.bite.z() + 24;  // the mean of adults; a cleft or a crop hides the floor
}

void find_width(const Points& points, JawAnatomy& jaw) {
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const bool lower_jaw = points(v, 2) < jaw.bite.z() && points(v, 2) > jaw.menton_z &&
                           points(v, 1) < jaw.bite.y() + 60;
    if (!lower_jaw) continue;
    jaw.half_width = std::max(jaw.half_width, std::abs(points(v, 0) - jaw.midline_x));
  }
}

}  // namespace

JawAnatomy find_jaw(const TriangleMesh& bone,
                    const std::map<std::string, Eigen::Vector3d>& landmarks) {
  if (bone.vertices.rows() == 0) not_found("a jaw", "choose another HU level");
  JawAnatomy jaw;
  const Profile all(bone.vertices, 0, nowhere);
  jaw.menton_z = chin_bottom(all);
  find_chin(bone.vertices, jaw);
  find_bite(bone, bite_range(jaw, landmarks), jaw);
  find_nasal_floor(bone, jaw);
  find_width(bone.vertices, jaw);
  return jaw;
}

}  // namespace gnathion
