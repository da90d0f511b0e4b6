#pragma once

#include <array>

#include "fem/material.h"
#include "geometry/bsp_tree.h"
#include "imaging/ct_volume.h"

namespace gnathion {

/// What the face is taken to be made of.
enum class TissueKind : unsigned char { fat, muscle, skin };

/// Constants from the literature; docs/tissue-constants.md names the sources and the spread. Where
/// all motion is prescribed only the ratios of the moduli count.
struct TissueConstants {
  ElasticMaterial fat{0.00325, 0.46};
  ElasticMaterial muscle{0.0107, 0.46};
  ElasticMaterial skin{0.129, 0.46};
  double skin_mm = 1.5;  ///< epidermis and dermis
  double least_fat_hu = -190;
  double most_fat_hu = -30;     ///< what is above is muscle
  double most_muscle_hu = 150;  ///< what is above is partly bone
};

/// Materials of a mesh and what a report says of them.
struct TissueFromCt {
  struct Share {
    long tets = 0;          ///< tets of which it is the largest part
    double volume_mm3 = 0;  ///< of its parts of all tets
  };
  TissueMaterials materials;
  std::array<Share, 3> share{};  ///< in the order of TissueKind
  long unclear = 0;              ///< tets of no soft tissue in the CT, which are taken for muscle

  const Share& of(TissueKind kind) const { return share[static_cast<std::size_t>(kind)]; }
};

/// Distance of each point (n×3, mm, LPS) from the skin, mm. `skin`: tree of the outer surface.
/// Throws Error(anatomy) when the surface has no triangle.
Eigen::VectorXd depths_below(const Points& points, const BspTree& skin);

/// What each tet is made of. The part of it within the skin's thickness of the outer surface is
/// skin; the rest is fat or muscle, by its mean HU. Tets are thicker than skin, so a choice between
/// skin and not skin would lose most of the skin, or make it many times too thick; instead a tet
/// has the mean of the constants of its skin and of its rest, weighted by volume (Voigt's mean:
/// exact along the skin, where it counts, too stiff across it), in steps of a twentieth.
///
/// Twenty points a tet are sampled in the CT. Those that are no soft tissue (below least_fat_hu:
/// air takes part; above most_muscle_hu: bone takes part; outside the CT) are left out of the mean,
/// and so are those within a voxel of the skin, which blurs into them, where the tet has others.
/// node_depth: n, mm below the outer surface at the mesh's nodes, linear between.
/// Throws as validate(TissueMaterials).
TissueFromCt tissue_from_ct(const CtVolume& ct, const TetMesh& mesh,
                            const Eigen::VectorXd& node_depth,
                            const TissueConstants& constants = {});

}  // namespace gnathion
