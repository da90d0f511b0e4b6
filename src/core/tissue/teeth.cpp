#include "tissue/teeth.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/bsp_tree.h"

namespace gnathion {
namespace {

/// The voxels of a CT at or above a level, ascending: few against the whole volume.
class BrightVoxels {
 public:
  BrightVoxels(const CtVolume& ct, double level) : ct_(ct) {
    const std::vector<std::int16_t>& hu = ct.hu();
    for (std::size_t v = 0; v < hu.size(); ++v) {
      if (hu[v] >= level) voxels_.push_back(v);
    }
  }

  std::size_t size() const { return voxels_.size(); }

  Eigen::Vector3d lps(int n) const { return ct_.lps(ijk(n).cast<double>()); }

  /// Of the n-th voxel, through its faces: numbers of the bright ones among them, −1 for others.
  std::array<int, 6> neighbours(int n) const {
    std::array<int, 6> result;
    const Eigen::Vector3i at = ijk(n);
    for (int side = 0; side < 6; ++side) {
      Eigen::Vector3i next = at;
      next[side / 2] += side % 2 == 0 ? -1 : 1;
      const bool inside = (next.array() >= 0).all() && (next.array() < ct_.dims().array()).all();
      result[side] = inside ? number(ct_.index(next.x(), next.y(), next.z())) : -1;
    }
    return result;
  }

 private:
  Eigen::Vector3i ijk(int n) const {
    const std::size_t row = voxels_[n] / static_cast<std::size_t>(ct_.dims().x());
    return {static_cast<int>(voxels_[n] % static_cast<std::size_t>(ct_.dims().x())),
            static_cast<int>(row % static_cast<std::size_t>(ct_.dims().y())),
            static_cast<int>(row / static_cast<std::size_t>(ct_.dims().y()))};
  }

  int number(std::size_t voxel) const {
    const auto found = std::lower_bound(voxels_.begin(), voxels_.end(), voxel);
    if (found == voxels_.end() || *found != voxel) return -1;
    return static_cast<int>(found - voxels_.begin());
  }

  const CtVolume& ct_;
  std::vector<std::size_t> voxels_;
};

/// Voxels connected through faces.
struct Piece {
  std::vector<int> voxels;
  std::vector<int> border;  ///< those with a neighbour that is not bright
  Eigen::AlignedBox3d box;  ///< of the voxels' centres, mm, LPS
};

std::vector<Piece> pieces_of(const BrightVoxels& bright) {
  std::vector<Piece> pieces;
  std::vector<bool> seen(bright.size(), false);
  for (int first = 0; first < static_cast<int>(bright.size()); ++first) {
    if (seen[first]) continue;
    Piece piece{{first}, {}, {}};
    seen[first] = true;
    for (std::size_t next = 0; next < piece.voxels.size(); ++next) {
      const int n = piece.voxels[next];
      piece.box.extend(bright.lps(n));
      const auto neighbours = bright.neighbours(n);
      if (std::count(neighbours.begin(), neighbours.end(), -1) > 0) piece.border.push_back(n);
      for (const int m : neighbours) {
        if (m == -1 || seen[m]) continue;
        seen[m] = true;
        piece.voxels.push_back(m);
      }
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Groups of pieces that are chained by gaps of at most `gap` mm between their boxes.
std::vector<std::vector<int>> groups_of(const std::vector<Piece>& pieces, double gap) {
  std::vector<std::vector<int>> groups;
  std::vector<bool> seen(pieces.size(), false);
  for (int first = 0; first < static_cast<int>(pieces.size()); ++first) {
    if (seen[first]) continue;
    std::vector<int> group{first};
    seen[first] = true;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (int p = 0; p < static_cast<int>(pieces.size()); ++p) {
        if (seen[p] || pieces[group[next]].box.exteriorDistance(pieces[p].box) > gap) continue;
        seen[p] = true;
        group.push_back(p);
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace

Crowns find_crowns(const CtVolume& ct, const CrownOptions& options) {
  const BrightVoxels bright(ct, options.hu);
  const double voxel_mm3 = std::abs(ct.lps_from_ijk().topLeftCorner<3, 3>().determinant());
  std::vector<Piece> pieces = pieces_of(bright);
  std::erase_if(pieces, [&](const Piece& piece) {
    return voxel_mm3 * static_cast<double>(piece.voxels.size()) < options.piece_mm3;
  });
  Crowns crowns;
  std::vector<Eigen::Vector3d> border;
  for (const std::vector<int>& group : groups_of(pieces, options.gap_mm)) {
    std::size_t count = 0;
    for (const int p : group) count += pieces[p].voxels.size();
    const double volume = voxel_mm3 * static_cast<double>(count);
    if (volume < options.dentition_mm3) continue;
    crowns.volume_mm3 += volume;
    crowns.piece_count += static_cast<int>(group.size());
    for (const int p : group) {
      for (const int n : pieces[p].border) border.push_back(bright.lps(n));
    }
  }
  crowns.border.resize(static_cast<Eigen::Index>(border.size()), 3);
  for (std::size_t k = 0; k < border.size(); ++k) {
    crowns.border.row(static_cast<Eigen::Index>(k)) = border[k];
  }
  return crowns;
}

std::vector<BoneCover> bone_cover(const Crowns& crowns, const Points& points,
                                  const CoverOptions& options) {
  // Triangles of one corner: the tree then finds the nearest of a set of points.
  TriangleMesh dots{crowns.border, Triangles(crowns.border.rows(), 3)};
  for (int k = 0; k < dots.triangles.rows(); ++k) dots.triangles.row(k).setConstant(k);
  const BspTree tree(dots);
  std::vector<BoneCover> cover(static_cast<std::size_t>(points.rows()), BoneCover::periosteum);
  const double reach = std::max(options.tooth_mm, options.gum_mm);
  for (std::size_t i = 0; i < cover.size(); ++i) {
    const auto nearest = tree.nearest(points.row(static_cast<Eigen::Index>(i)), reach);
    if (!nearest) continue;
    cover[i] = nearest->distance <= options.tooth_mm ? BoneCover::tooth : BoneCover::gum;
  }
  return cover;
}

}  // namespace gnathion
