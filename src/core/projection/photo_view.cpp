#include "projection/photo_view.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <queue>

#include "base/error.h"
#include "registration/parallel.h"

namespace gnathion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLeastFacing = 0.2;  // cosine: what is seen more flatly is smeared
constexpr double kFeatherMm = 8;      // over which a photograph fades in from the edge of its sight
constexpr double kBroadMm = 1.5;      // of the photograph's own blur
constexpr int kBroadRounds = 6;       // over neighbours, after that
constexpr double kLeastRim = 1.5, kMostRim = 6;  // mm beside an outline that are not taken
constexpr double kStepMm = 15;   // nearer than the skin beside: something stands before it
constexpr double kOpenMm = 100;  // farther: there is nothing behind
constexpr double kBorder = 2;    // pixels: a photograph's edge is not taken

/// Whether a picture that lies a little beside its place would show something else here: what is
/// behind the head, or a part of it that stands before this one.
bool at_outline(const PlacedPhoto& photo, const SkinSight& skin, const Vector3d& x) {
  const PhotoCamera& camera = photo.camera;
  const double distance = (x - camera.eye()).norm();
  const double rim =
      std::clamp(photo.uncertainty_mm, kLeastRim, kMostRim) * camera.focal / camera.depth(x);
  const Vector2d middle = camera.pixel(x);
  for (int k = 0; k < 8; ++k) {
    const Vector2d beside = middle + rim * Vector2d(std::cos(k * M_PI / 4), std::sin(k * M_PI / 4));
    const auto hit =
        skin.tree().first_hit(camera.eye(), camera.direction(beside), distance + kOpenMm);
    if (!hit || hit->distance < distance - kStepMm) return true;
  }
  return false;
}

/// The cosine at which a vertex is seen; 0 when it is not.
double facing_of(const PlacedPhoto& photo, const SkinSight& skin, Eigen::Index v) {
  const PhotoCamera& camera = photo.camera;
  const Vector3d x = skin.mesh().vertices.row(v), normal = skin.normals().row(v);
  if (camera.depth(x) <= 1) return 0;
  const Vector3d eye = camera.eye();
  const double facing = normal.dot((eye - x).normalized());
  if (facing < kLeastFacing) return 0;
  const Vector2d p = camera.pixel(x);
  if (p.x() < kBorder || p.y() < kBorder || p.x() > photo.photo->width - 1 - kBorder ||
      p.y() > photo.photo->height - 1 - kBorder) {
    return 0;
  }
  return skin.hides(x + 0.5 * normal, eye, 0.2) || at_outline(photo, skin, x) ? 0 : facing;
}

std::vector<double> facings(const PlacedPhoto& photo, const SkinSight& skin, Progress& progress) {
  const auto count = static_cast<std::size_t>(skin.mesh().vertices.rows());
  std::vector<double> facing(count);
  constexpr std::size_t kBlock = 1024;
  for_each_in_parallel((count + kBlock - 1) / kBlock, [&](std::size_t block) {
    progress.check();
    for (std::size_t v = kBlock * block; v < std::min(count, kBlock * (block + 1)); ++v) {
      facing[v] = facing_of(photo, skin, static_cast<Eigen::Index>(v));
    }
  });
  return facing;
}

double median_mm_per_pixel(const PlacedPhoto& photo, const Points& vertices,
                           const std::vector<double>& facing) {
  std::vector<double> mm;
  for (std::size_t v = 0; v < facing.size(); ++v) {
    if (facing[v] <= 0) continue;
    const Vector3d x = vertices.row(static_cast<Eigen::Index>(v));
    mm.push_back(photo.camera.depth(x) / photo.camera.focal);
  }
  if (mm.empty()) {
    throw Error(ErrorKind::input, photo.name, "shows nothing of the skin from where it was taken",
                "look at its landmarks: they must lie on the skin that it shows");
  }
  const auto middle = mm.begin() + static_cast<std::ptrdiff_t>(mm.size() / 2);
  std::nth_element(mm.begin(), middle, mm.end());
  return *middle;
}

/// Colours of the photograph blurred, at the vertices that it sees.
void sample_broadly(const PlacedPhoto& photo, const Points& vertices, PhotoView& view) {
  const Photo& own = *photo.photo;
  // Read only. Small first: a broad blur of many pixels is dear.
  const cv::Mat full(own.height, own.width, CV_8UC3, const_cast<std::uint8_t*>(own.rgb.data()));
  const double scale = std::min(1.0, view.mm_per_pixel / (kBroadMm / 2));
  cv::Mat small;
  cv::resize(full, small, {}, scale, scale, cv::INTER_AREA);
  cv::GaussianBlur(small, small, {}, std::max(0.5, kBroadMm * scale / view.mm_per_pixel));
  for (std::size_t v = 0; v < view.weight.size(); ++v) {
    if (view.weight[v] <= 0) continue;
    const auto row = static_cast<Eigen::Index>(v);
    const Vector2d p = photo.camera.pixel(vertices.row(row)) * scale;
    const auto& c = small.at<cv::Vec3b>(std::clamp(static_cast<int>(p.y()), 0, small.rows - 1),
                                        std::clamp(static_cast<int>(p.x()), 0, small.cols - 1));
    view.broad.row(row) << c[0] / 255.0, c[1] / 255.0, c[2] / 255.0;
  }
}

/// Evens the colours out over neighbours that are seen, and carries them to the next ones.
void spread_broadly(const std::vector<std::vector<int>>& neighbours, PhotoView& view) {
  for (int round = 0; round < kBroadRounds; ++round) {
    const Points before = view.broad;
    for (std::size_t v = 0; v < neighbours.size(); ++v) {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      int count = 0;
      const auto add = [&](std::size_t u) {
        if (view.weight[u] <= 0) return;
        sum += before.row(static_cast<Eigen::Index>(u));
        ++count;
      };
      add(v);
      for (const int u : neighbours[v]) add(static_cast<std::size_t>(u));
      if (count > 0) view.broad.row(static_cast<Eigen::Index>(v)) = sum / count;
    }
  }
}

}  // namespace

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

std::vector<double> edge_distances(const Points& vertices,
                                   const std::vector<std::vector<int>>& neighbours,
                                   const std::vector<bool>& from, double reach) {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<double> distance(from.size(), reach);
  for (std::size_t v = 0; v < from.size(); ++v) {
    if (!from[v]) continue;
    distance[v] = 0;
    queue.emplace(0, static_cast<int>(v));
  }
  while (!queue.empty()) {
    const auto [so_far, v] = queue.top();
    queue.pop();
    if (so_far > distance[static_cast<std::size_t>(v)]) continue;
    for (const int u : neighbours[static_cast<std::size_t>(v)]) {
      const double there = so_far + (vertices.row(u) - vertices.row(v)).norm();
      if (there >= distance[static_cast<std::size_t>(u)]) continue;
      distance[static_cast<std::size_t>(u)] = there;
      queue.emplace(there, u);
    }
  }
  return distance;
}

PhotoView view_of(const PlacedPhoto& photo, const SkinSight& skin,
                  const std::vector<std::vector<int>>& neighbours, Progress& progress) {
  const Points& vertices = skin.mesh().vertices;
  const std::vector<double> facing = facings(photo, skin, progress);
  PhotoView view;
  view.mm_per_pixel = median_mm_per_pixel(photo, vertices, facing);
  std::vector<bool> unseen(facing.size());
  for (std::size_t v = 0; v < facing.size(); ++v) unseen[v] = facing[v] <= 0;
  unseen = widened(unseen, neighbours);
  const std::vector<double> inside = edge_distances(vertices, neighbours, unseen, kFeatherMm);
  view.weight.assign(facing.size(), 0);
  for (std::size_t v = 0; v < facing.size(); ++v) {
    if (unseen[v]) continue;
    view.weight[v] = std::max(1e-3, facing[v] * facing[v] * smooth_step(0, kFeatherMm, inside[v]));
  }
  view.broad = Points::Zero(vertices.rows(), 3);
  sample_broadly(photo, vertices, view);
  spread_broadly(neighbours, view);
  return view;
}

}  // namespace gnathion
