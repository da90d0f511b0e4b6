#include "render/slice_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gnathion {
namespace {

constexpr double margin_mm = 10;  // of the air around a patient

}  // namespace

HuWindow limited(HuWindow window) {
  return {std::clamp(window.level, -2000.0, 6000.0), std::clamp(window.width, 2.0, 8000.0)};
}

std::uint8_t grey_of(double hu, const HuWindow& window) {
  const double share = (hu - (window.level - 0.5)) / (window.width - 1) + 0.5;
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

void grey_slice(const CtSlice& slice, const HuWindow& window, std::vector<std::uint8_t>& greys) {
  using Limits = std::numeric_limits<std::int16_t>;
  constexpr int values = 1 + Limits::max() - Limits::min();
  std::vector<std::uint8_t> table(values);
  for (int v = 1; v < values; ++v) table[v] = grey_of(v + Limits::min(), window);
  table[outside_volume - Limits::min()] = 0;
  greys.resize(slice.hu.size());
  std::transform(slice.hu.begin(), slice.hu.end(), greys.begin(),
                 [&](std::int16_t hu) { return table[hu - Limits::min()]; });
}

void SliceScene::set_volume(std::shared_ptr<const CtVolume> volume) {
  remove_surfaces();
  volume_ = std::move(volume);
  lattice_ = slice_lattice(*volume_);
}

SliceScene::Surface* SliceScene::find(const std::string& name) {
  const auto found = std::find_if(surfaces_.begin(), surfaces_.end(),
                                  [&](const Surface& surface) { return surface.name == name; });
  return found == surfaces_.end() ? nullptr : &*found;
}

void SliceScene::set_surface(const std::string& name, std::shared_ptr<const PlaneSection> surface,
                             const Eigen::Vector3d& colour) {
  const Points& vertices = surface->surface().vertices;
  around_.extend(vertices.colwise().minCoeff().transpose());
  around_.extend(vertices.colwise().maxCoeff().transpose());
  Surface added{name, std::move(surface), colour, {}, true};
  if (Surface* known = find(name)) {
    *known = std::move(added);
  } else {
    surfaces_.push_back(std::move(added));
  }
}

void SliceScene::remove_surfaces() {
  surfaces_.clear();
  around_.setEmpty();
}

LpsBox SliceScene::subject() const {
  const Eigen::Vector3d half = lattice_.step / 2;
  const Eigen::AlignedBox3d all(lattice_.origin - half, lattice_.last() + half);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(margin_mm);
  const Eigen::AlignedBox3d seen =
      around_.isEmpty()
          ? all
          : all.intersection(Eigen::AlignedBox3d(around_.min() - margin, around_.max() + margin));
  return seen.isEmpty() ? LpsBox{all.min(), all.max()} : LpsBox{seen.min(), seen.max()};
}

void SliceScene::set_surface_points(const std::string& name, const Points& points) {
  Surface* surface = find(name);
  if (surface == nullptr) return;
  auto moved = std::make_shared<PlaneSection>(*surface->section);
  moved->set_points(points);
  surface->section = std::move(moved);
}

void SliceScene::set_surface_pose(const std::string& name, const RigidMotion& pose) {
  if (Surface* surface = find(name)) surface->pose = pose;
}

void SliceScene::set_surface_visible(const std::string& name, bool visible) {
  if (Surface* surface = find(name)) surface->visible = visible;
}

void SliceScene::cut(SlicePlane plane, const Eigen::Vector3d& lps, CtSlice& slice) const {
  cut_slice(*volume_, lattice_, plane, lps, slice);
}

std::vector<SliceContour> SliceScene::contours(SlicePlane plane, const Eigen::Vector3d& lps) const {
  std::vector<SliceContour> contours;
  const Eigen::Vector3d normal = axes_of(plane).onward;
  for (const Surface& surface : surfaces_) {
    if (!surface.visible) continue;
    // The plane where the surface rests: normal · (R x + t) = offset.
    const double offset = normal.dot(lps - surface.pose.translation);
    SliceContour contour{surface.name, surface.colour, {}};
    for (const SectionLine& line :
         surface.section->cut(surface.pose.rotation.transpose() * normal, offset)) {
      contour.lines.push_back({picture_from_lps(plane, surface.pose(line[0])),
                               picture_from_lps(plane, surface.pose(line[1]))});
    }
    if (!contour.lines.empty()) contours.push_back(std::move(contour));
  }
  return contours;
}

}  // namespace gnathion
