#pragma once

#include <filesystem>

#include "base/progress.h"
#include "imaging/ct_volume.h"

namespace gnathion {

/// Reads a volume of Hounsfield units from MetaImage (.mha, .mhd), NRRD (.nrrd, .nhdr) or NIfTI-1
/// (.nii, .nii.gz). The grid's place and direction are kept and given in LPS mm:
/// MetaImage is LPS by definition; NRRD needs its `space` field (LPS, RAS or LAS by name); NIfTI
/// is RAS, sform before qform. Lengths in other declared units are converted. Fractions of HU are
/// rounded, values beyond 16 bits clamped, NaN becomes −1024 with a notice.
///
/// Throws Error(input): missing, unreadable or truncated file; unknown format or element type; a
/// file without a place in the patient (no `space`, no sform and no qform); not three-dimensional;
/// an extent that cannot be a head in mm (below 30 mm or above 3 m: wrong unit); values that
/// cannot be HU (no air: nothing below −500).
CtVolume read_volume_file(const std::filesystem::path& path, Progress& progress);

}  // namespace gnathion
