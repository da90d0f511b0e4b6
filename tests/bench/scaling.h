#pragma once

#include "bench/report.h"
#include "geometry/mesh_types.h"

namespace gnathion::bench {

/// A lower face of p1's edge length and about so many tets; larger ones are larger faces, so that
/// elements keep their shape. `size`: set to its size as a multiple of the lower face's own.
TriangleMesh patch_of(long tets, double& size);

/// Time and memory of every stage on patches of 5 000 to `largest` tets, with the exponents of
/// their growth, and how near a drag frame comes to the machine's read bandwidth.
void report_scaling(const Report& report, long largest);

}  // namespace gnathion::bench
