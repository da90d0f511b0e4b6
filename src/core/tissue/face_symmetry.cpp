#include "tissue/face_symmetry.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

constexpr double kFront = 90;       // mm behind the foremost point: the face without the neck
constexpr double kSearch = 20;      // mm from a mirrored point to the face
constexpr int kSamples = 3000;      // points that are mirrored
constexpr double kBest = 0.8;       // part of them that is believed
constexpr double kImageReach = 15;  // mm: an asymmetric face is still the same face

/// Evenly taken from the front of the face.
std::vector<Eigen::Vector3d> samples_of(const TriangleMesh& face) {
  const double foremost = face.vertices.col(1).minCoeff();
  std::vector<Eigen::Vector3d> front;
  for (const auto& x : face.vertices.rowwise()) {
    if (x[1] < foremost + kFront) front.emplace_back(x.transpose());
  }
  const std::size_t stride = std::max<std::size_t>(1, front.size() / kSamples);
  std::vector<Eigen::Vector3d> samples;
  for (std::size_t i = 0; i < front.size(); i += stride) samples.push_back(front[i]);
  return samples;
}

/// A point, and the point of the face that its mirror image is nearest to.
struct Match {
  double distance;
  Eigen::Vector3d from, to;
  Eigen::Vector3d out;  ///< normal of the face there
};

/// The best of the matches, by distance.
std::vector<Match> best_matches(const std::vector<Eigen::Vector3d>& samples, const BspTree& tree,
                                const Points& normals, const SymmetryPlane& plane) {
  std::vector<Match> matches;
  for (const Eigen::Vector3d& x : samples) {
    const auto nearest = tree.nearest(plane.mirrored(x), kSearch);
    if (!nearest) continue;
    matches.push_back(
        {nearest->distance, x, nearest->point, normals.row(nearest->triangle).transpose()});
  }
  if (2 * matches.size() < samples.size() || matches.size() < 10) {
    throw Error(ErrorKind::anatomy, "region",
                "the two sides of the face are too different to be mirrored",
                "paint the other side by hand, or check that the photograph stands upright in the "
                "patient's frame");
  }
  const auto count = static_cast<std::ptrdiff_t>(kBest * static_cast<double>(matches.size()));
  std::nth_element(matches.begin(), matches.begin() + count, matches.end(),
                   [](const Match& a, const Match& b) { return a.distance < b.distance; });
  matches.resize(static_cast<std::size_t>(count));
  return matches;
}

/// One step of Gauss and Newton towards the plane that brings the mirrored points nearest to the
/// planes of the triangles that they are matched with; point to point it would take hundreds, since
/// a head slides over itself. Unknowns: the normal's two turns and the offset.
SymmetryPlane stepped(const SymmetryPlane& plane, const std::vector<Match>& matches) {
  const Eigen::Vector3d n = plane.normal;
  const Eigen::Vector3d t1 = n.unitOrthogonal(), t2 = n.cross(t1);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // about which the plane turns
  for (const Match& match : matches) middle += match.from / static_cast<double>(matches.size());
  const double offset = plane.offset - n.dot(middle);
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const Match& match : matches) {
    const Eigen::Vector3d p = match.from - middle;
    const double height = n.dot(p) - offset;
    const double miss = match.out.dot(p - 2 * height * n - (match.to - middle));
    const Eigen::Vector3d slope(-2 * match.out.dot(t1.dot(p) * n + height * t1),
                                -2 * match.out.dot(t2.dot(p) * n + height * t2),
                                2 * match.out.dot(n));
    squares += slope * slope.transpose();
    moment -= miss * slope;
  }
  const Eigen::Vector3d step = squares.ldlt().solve(moment);
  SymmetryPlane next;
  next.normal = (n + step[0] * t1 + step[1] * t2).normalized();
  next.offset = offset + step[2] + next.normal.dot(middle);
  return next;
}

}  // namespace

SymmetryPlane find_symmetry(const TriangleMesh& face, const BspTree& tree) {
  const std::vector<Eigen::Vector3d> samples = samples_of(face);
  const Points normals = triangle_normals(face);
  SymmetryPlane plane;
  double low = 1e30, high = -1e30;
  for (const Eigen::Vector3d& x : samples) {
    low = std::min(low, x.x());
    high = std::max(high, x.x());
  }
  plane.offset = (low + high) / 2;
  std::vector<Match> matches = best_matches(samples, tree, normals, plane);
  constexpr int kSteps = 40;
  for (int step = 0; step < kSteps; ++step) {
    const SymmetryPlane last = std::exchange(plane, stepped(plane, matches));
    matches = best_matches(samples, tree, normals, plane);
    if ((plane.normal - last.normal).norm() < 1e-5 && std::abs(plane.offset - last.offset) < 1e-3) {
      break;
    }
  }
  for (const Match& match : matches) {
    plane.error_mm += match.distance / static_cast<double>(matches.size());
  }
  return plane;
}

Selection with_mirror_image(const SurfaceBrush& brush, const BspTree& tree,
                            const SymmetryPlane& plane, const Selection& selection) {
  const TriangleMesh& face = brush.face();
  Eigen::AlignedBox3d box;  // of the image
  for (const int v : vertices_of(selection)) {
    box.extend(plane.mirrored(face.vertices.row(v).transpose()));
  }
  Selection both = selection;
  const Points normals = triangle_normals(face);
  const Points out = vertex_normals(face);
  for (Eigen::Index v = 0; v < face.vertices.rows(); ++v) {
    const Eigen::Vector3d x = face.vertices.row(v);
    if (both[v] || box.exteriorDistance(x) > kImageReach) continue;
    const auto nearest = tree.nearest(plane.mirrored(x), kImageReach);
    if (!nearest) continue;
    const Eigen::Vector3d n = out.row(v);
    const Eigen::Vector3d image = n - 2 * plane.normal.dot(n) * plane.normal;
    if (normals.row(nearest->triangle).dot(image.transpose()) <= 0) continue;
    const auto corners = face.triangles.row(nearest->triangle);
    int closest = corners[0];
    for (const int corner : corners) {
      const auto distance = [&](int w) {
        return (face.vertices.row(w).transpose() - nearest->point).squaredNorm();
      };
      if (distance(corner) < distance(closest)) closest = corner;
    }
    both[v] = selection[closest];
  }
  return both;
}

}  // namespace gnathion
