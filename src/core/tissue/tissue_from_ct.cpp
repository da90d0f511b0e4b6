#include "tissue/tissue_from_ct.h"

#include <algorithm>
#include <cmath>
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

/// Of the part of a tet below the skin; nothing when no sampled point of it is soft tissue.
std::optional<TissueKind> kind_below_skin(const CtVolume& ct,
                                          const Eigen::Matrix<double, 3, 4>& corners,
                                          const Eigen::Vector4d& depths,
                                          const TissueConstants& constants) {
  static const std::vector<Eigen::Vector4d> kPoints = lattice();
  struct Sum {
    long count = 0;
    double hu = 0;
  };
  Sum deep, near_skin;
  const double blurred = constants.skin_mm + ct.steps().maxCoeff();
  for (const Eigen::Vector4d& weights : kPoints) {
    const double depth = depths.dot(weights);
    if (depth < constants.skin_mm) continue;
    const double hu = ct.sample(corners * weights);
    if (hu < constants.least_fat_hu || hu > constants.most_muscle_hu) continue;
    Sum& sum = depth < blurred ? near_skin : deep;
    sum.hu += hu;
    ++sum.count;
  }
  const Sum& sum = deep.count > 0 ? deep : near_skin;
  if (sum.count == 0) return {};
  const double mean = sum.hu / static_cast<double>(sum.count);
  return mean <= constants.most_fat_hu ? TissueKind::fat : TissueKind::muscle;
}

constexpr int kSkinSteps = 20;

/// Fat with 0, 1 … 20 twentieths of skin, then muscle with as many.
std::vector<ElasticMaterial> mixtures(const TissueConstants& constants) {
  std::vector<ElasticMaterial> kinds;
  for (const ElasticMaterial& rest : {constants.fat, constants.muscle}) {
    for (int step = 0; step <= kSkinSteps; ++step) {
      const double skin = static_cast<double>(step) / kSkinSteps;
      kinds.push_back({skin * constants.skin.young_MPa + (1 - skin) * rest.young_MPa,
                       skin * constants.skin.poisson + (1 - skin) * rest.poisson});
    }
  }
  return kinds;
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
  TissueFromCt result;
  result.materials.kinds = mixtures(constants);
  validate(result.materials, mesh.tets.rows());
  const auto share = [&](TissueKind kind) -> TissueFromCt::Share& {
    return result.share[static_cast<std::size_t>(kind)];
  };
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    Eigen::Matrix<double, 3, 4> corners;
    Eigen::Vector4d depths;
    for (int c = 0; c < 4; ++c) {
      corners.col(c) = mesh.vertices.row(mesh.tets(t, c));
      depths[c] = node_depth[mesh.tets(t, c)];
    }
    const double skin = part_below(depths, constants.skin_mm);
    const std::optional<TissueKind> found = kind_below_skin(ct, corners, depths, constants);
    const TissueKind rest = found.value_or(TissueKind::muscle);
    if (!found && skin < 0.5) ++result.unclear;
    ++share(skin >= 0.5 ? TissueKind::skin : rest).tets;
    share(TissueKind::skin).volume_mm3 += skin * volumes[t];
    share(rest).volume_mm3 += (1 - skin) * volumes[t];
    const auto step = static_cast<int>(std::lround(skin * kSkinSteps));
    result.materials.of_tet.push_back(
        static_cast<unsigned char>((rest == TissueKind::fat ? 0 : kSkinSteps + 1) + step));
  }
  return result;
}

}  // namespace gnathion
