#pragma once

#include <vector>

#include "geometry/mesh_types.h"
#include "imaging/ct_volume.h"

namespace gnathion {

/// What counts as a tooth's crown in a CT. docs/tissue-constants.md has the sources.
struct CrownOptions {
  double hu = 2000;       ///< enamel, fillings and brackets; dentine and cortical bone are below
  double piece_mm3 = 10;  ///< a smaller bright piece is noise or a dense spot of bone
  double dentition_mm3 = 100;  ///< pieces that together are less are no teeth
  double gap_mm = 15;          ///< pieces farther apart do not belong together
};

/// The crowns of the teeth, with what is fixed to them: fillings, brackets, implants.
struct Crowns {
  Points border;        ///< k×3, mm, LPS: centres of the voxels at the border of the crowns
  int piece_count = 0;  ///< connected pieces; neighbouring teeth in contact are one
  double volume_mm3 = 0;
};

/// Finds crowns as connected pieces of voxels (through faces) at or above a level, in groups of
/// enough volume: single bright voxels and scattered dense bone are not teeth. None are found, and
/// that is no error, where a dentition has no enamel or metal (prostheses of resin, phantoms).
/// Plates and screws as large as teeth are found too: HU cannot tell them from fillings.
Crowns find_crowns(const CtVolume& ct, const CrownOptions& options = {});

/// What lies between a point of bone and the soft tissue over it.
enum class BoneCover : unsigned char {
  periosteum,  ///< the tissue is attached
  tooth,       ///< bare crown: mucosa of lip or cheek slides over it
  gum,         ///< gum and vestibule: likewise
};

struct CoverOptions {
  double tooth_mm = 3;  ///< from the bone's surface to the nearest crown voxel: partial volume
  double gum_mm = 8;    ///< from the crowns to the fornix, where the vestibule ends
};

/// Which points (n×3, mm, LPS, on or near bone) lie on teeth or on gums. The distance counts
/// straight to the nearest crown, not along the surface: bone that near to a crown is alveolar
/// bone.
std::vector<BoneCover> bone_cover(const Crowns& crowns, const Points& points,
                                  const CoverOptions& options = {});

}  // namespace gnathion
