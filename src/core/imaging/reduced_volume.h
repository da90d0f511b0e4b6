#pragma once

#include "imaging/ct_volume.h"

namespace gnathion {

/// The volume with blocks of voxels in place of voxels, each their mean HU, so that no step is
/// finer than about `step_mm`: for a look at a level while it is chosen. Voxels at the far ends
/// that fill no block are left out. Itself (sharing its voxels) where it is that coarse already.
CtVolume reduced(const CtVolume& volume, double step_mm);

}  // namespace gnathion
