#include "registration/skin_target.h"

#include <algorithm>

#include "base/error.h"
#include "registration/point_grid.h"

namespace gnathion {
namespace {

const TriangleMesh& checked(const TriangleMesh& skin) {
  if (skin.triangles.rows() > 0) return skin;
  throw Error(ErrorKind::anatomy, "skin of the CT", "has no triangle to fit a photograph to",
              "choose another HU level for the skin");
}

std::vector<Prominence> forward_ones(const SurfaceSample& skin) {
  std::vector<Prominence> all = prominences(skin);
  std::erase_if(all, [](const Prominence& p) { return p.facing.y() > -0.5; });
  return highest(std::move(all), 4);
}

/// Rows of the skin's sample that are the face.
std::vector<Eigen::Index> face_of(const SurfaceSample& skin,
                                  const std::vector<Prominence>& forward) {
  constexpr double kFace = 90;  // mm
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < skin.size(); ++i) {
    const bool near = std::any_of(forward.begin(), forward.end(), [&](const Prominence& p) {
      return (skin.points.row(i).transpose() - p.at).norm() < kFace;
    });
    if (near && skin.normals(i, 1) < -0.2) rows.push_back(i);
  }
  return rows;
}

}  // namespace

SkinTarget::SkinTarget(const TriangleMesh& skin)
    : tree_(checked(skin)),
      normals_(triangle_normals(skin)),
      sample_(SampledSurface(skin).sample(5, 5)),
      forward_(forward_ones(sample_)),
      face_(face_of(sample_, forward_)) {}

std::optional<SkinTarget::Place> SkinTarget::nearest(const Eigen::Vector3d& lps,
                                                     double reach) const {
  const std::optional<NearestPoint> found = tree_.nearest(lps, reach);
  if (!found) return {};
  return Place{found->point, normals_.row(found->triangle)};
}

double SkinTarget::covered_face(const SurfaceSample& photograph, const Similarity& s,
                                double kernel) const {
  constexpr double kReach = 12;  // mm, between points of a thin sample
  const Points points = moved(photograph.points, s);
  const Points normals = photograph.normals * s.rotation.transpose();
  const PointGrid grid(points, kReach);
  double covered = 0;
  for (const Eigen::Index i : face_) {
    const Eigen::Vector3d p = sample_.points.row(i);
    double nearest = kReach * kReach, away = kernel;
    grid.for_each_within(p, kReach, [&](int j) {
      if (normals.row(j).dot(sample_.normals.row(i)) < 0.7) return;
      const Eigen::Vector3d between = p - points.row(j).transpose();
      if (between.squaredNorm() >= nearest) return;
      nearest = between.squaredNorm();
      away = normals.row(j).dot(between);
    });
    covered += std::max(0.0, 1 - away * away / (kernel * kernel));
  }
  return face_.empty() ? 0 : covered / static_cast<double>(face_.size());
}

}  // namespace gnathion
