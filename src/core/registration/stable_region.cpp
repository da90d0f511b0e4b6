#include "registration/stable_region.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace gnathion {
namespace {

using Eigen::Vector3d;

// mm, of an adult's face.
constexpr double kNasionAboveTip = 40;
constexpr double kNasionBehindTip = 25;
constexpr double kBelow = 25, kAbove = 75;  // of the nasion
constexpr double kAside = 75, kBehind = 80;

std::optional<Vector3d> nasion(const SkinTarget& skin, std::span<const LandmarkPair> landmarks) {
  const Vector3d above_tip(0, kNasionBehindTip, kNasionAboveTip);
  const auto named = [&](const std::string& name) {
    return std::find_if(landmarks.begin(), landmarks.end(),
                        [&](const LandmarkPair& pair) { return pair.name == name; });
  };
  if (const auto found = named(nasion_name); found != landmarks.end()) return found->lps;
  if (const auto found = named(nose_tip_name); found != landmarks.end())
    return found->lps + above_tip;
  if (skin.forward().empty()) return {};
  return skin.forward().front().at + above_tip;
}

}  // namespace

std::vector<bool> upper_face(const Points& points, const Similarity& lps_from_photograph,
                             const SkinTarget& skin, std::span<const LandmarkPair> landmarks) {
  const std::optional<Vector3d> centre = nasion(skin, landmarks);
  if (!centre) return {};
  std::vector<bool> flags(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const Vector3d off = lps_from_photograph(points.row(v)) - *centre;
    flags[static_cast<std::size_t>(v)] =
        std::abs(off.x()) < kAside && off.y() < kBehind && off.z() > -kBelow && off.z() < kAbove;
  }
  return flags;
}

}  // namespace gnathion
