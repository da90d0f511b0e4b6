#pragma once

#include <array>

#include "fem/material.h"
#include "geometry/bsp_tree.h"
#include "imaging/ct_volume.h"

namespace gnathion {

/// What a tetrahedron of the face is taken to be made of.
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
    long tets = 0;
    double volume_mm3 = 0;
  };
  TissueMaterials materials;     ///< kinds in the order of TissueKind
  std::array<Share, 3> share{};  ///< in the order of TissueKind
  long unclear = 0;  ///< tets that meet no soft tissue in the CT; they are counted as muscle

  const Share& of(TissueKind kind) const { return share[static_cast<std::size_t>(kind)]; }
};

/// Distance of each point (n×3, mm, LPS) from the skin, mm. `skin`: tree of the outer surface.
/// Throws Error(anatomy) when the surface has no triangle.
Eigen::VectorXd depths_below(const Points& points, const BspTree& skin);

/// Skin, fat or muscle for each tet: skin where at least half of the tet lies within the skin's
/// thickness of the outer surface; else by the mean HU of its part below the skin. Twenty points a
/// tet are sampled. Points that are no soft tissue (below least_fat_hu: air takes part; above
/// most_muscle_hu: bone takes part; outside the CT) are left out of the mean; a tet of nothing else
/// becomes muscle and is counted as unclear.
/// node_depth: n, mm below the outer surface at the mesh's nodes, linear between.
/// Throws as validate(TissueMaterials).
TissueFromCt tissue_from_ct(const CtVolume& ct, const TetMesh& mesh,
                            const Eigen::VectorXd& node_depth,
                            const TissueConstants& constants = {});

}  // namespace gnathion
