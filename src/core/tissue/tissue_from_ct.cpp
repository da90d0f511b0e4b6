#include "tissue/tissue_from_ct.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "base/error.h"
#include "geometry/tet_quality.h"

namespace gnathion {
namespace {

/// Barycentric coordinates of 20 points spread evenly over a tet: the centres of a lattice.
std::vector<Eigen::Vector4d> lattice() {
  constexpr int kSteps = 3;
  std::vector<Eigen::Vector4d> points;
  for (int a = 0; a <= kSteps; ++a) {
    for (int b = 0; a + b <= kSteps; ++b) {
      for (int c = 0; a + b + c <= kSteps; ++c) {
        points.push_back((Eigen::Vector4d(a, b, c, kSteps - a - b - c).array() + 0.25) /
                         (kSteps + 1));
      }
    }
  }
  return points;
}

/// Part of a tet's volume in which a quantity that is linear in it, given at the corners, is below
/// `level`, 0..1. The cut tetrahedron of Blöchl, Jepsen and Andersen (1994), Physical Review B 49,
/// 16223, appendix A.
double part_below(Eigen::Vector4d e, double level) {
  std::sort(e.begin(), e.end());
  if (level <= e[0]) return 0;
  if (level >= e[3]) return 1;
  const auto cube = [](double x) { return x * x * x; };
  if (level <= e[1]) return cube(level - e[0]) / ((e[1] - e[0]) * (e[2] - e[0]) * (e[3] - e[0]));
  if (level >= e[2]) {
    return 1 - cube(e[3] - level) / ((e[3] - e[0]) * (e[3] - e[1]) * (e[3] - e[2]));
  }
  const double first = e[1] - e[0];
  const double above = level - e[1];
  const double bend = (e[2] - e[0] + e[3] - e[1]) / ((e[2] - e[1]) * (e[3] - e[1]));
  return (first * first + 3 * first * above + 3 * above * above - bend * cube(above)) /
         ((e[2] - e[0]) * (e[3] - e[0]));
}

/// Nothing when no sampled point is soft tissue.
std::optional<TissueKind> kind_of(const CtVolume& ct, const Eigen::Matrix<double, 3, 4>& corners,
                                  const Eigen::Vector4d& depths, const TissueConstants& constants) {
  static const std::vector<Eigen::Vector4d> kPoints = lattice();
  if (part_below(depths, constants.skin_mm) >= 0.5) return TissueKind::skin;
  std::size_t soft = 0;
  double sum = 0;
  for (const Eigen::Vector4d& weights : kPoints) {
    if (depths.dot(weights) < constants.skin_mm) continue;
    const double hu = ct.sample(corners * weights);
    if (hu < constants.least_fat_hu || hu > constants.most_muscle_hu) continue;
    sum += hu;
    ++soft;
  }
  if (soft == 0) return {};
  return sum <= constants.most_fat_hu * static_cast<double>(soft) ? TissueKind::fat
                                                                  : TissueKind::muscle;
}

}  // namespace

Eigen::VectorXd depths_below(const Points& points, const BspTree& skin) {
  Eigen::VectorXd depths(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto nearest = skin.nearest(points.row(i), std::numeric_limits<double>::max());
    if (!nearest) {
      throw Error(ErrorKind::anatomy, "skin", "its surface has no triangle",
                  "choose a region of the face that has an area");
    }
    depths[i] = nearest->distance;
  }
  return depths;
}

TissueFromCt tissue_from_ct(const CtVolume& ct, const TetMesh& mesh,
                            const Eigen::VectorXd& node_depth, const TissueConstants& constants) {
  const Eigen::VectorXd volumes = tet_volumes(mesh);
  std::vector<unsigned char> of_tet;
  of_tet.reserve(static_cast<std::size_t>(mesh.tets.rows()));
  TissueFromCt result;
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    Eigen::Matrix<double, 3, 4> corners;
    Eigen::Vector4d depths;
    for (int c = 0; c < 4; ++c) {
      corners.col(c) = mesh.vertices.row(mesh.tets(t, c));
      depths[c] = node_depth[mesh.tets(t, c)];
    }
    const std::optional<TissueKind> found = kind_of(ct, corners, depths, constants);
    if (!found) ++result.unclear;
    const TissueKind kind = found.value_or(TissueKind::muscle);
    of_tet.push_back(static_cast<unsigned char>(kind));
    TissueFromCt::Share& share = result.share[static_cast<std::size_t>(kind)];
    ++share.tets;
    share.volume_mm3 += volumes[t];
  }
  result.materials = TissueMaterials({constants.fat, constants.muscle, constants.skin}, of_tet);
  validate(result.materials, mesh.tets.rows());
  return result;
}

}  // namespace gnathion
