#pragma once

#include <string>
#include <vector>

#include "bench/report.h"

namespace gnathion::bench {

/// The ST Generator beside TetGen on the same tissue: number of elements, time, and the paper's
/// Fig. 5: how aspect ratio, face angle and dihedral angle spread. On p1, p2 and the tissue of
/// these case files.
void report_mesh_peers(const Report& report, const std::vector<std::string>& cases);

}  // namespace gnathion::bench
