#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// CalculiX beside this program on p1 and p2, linear and large strain (left out where ccx is not
/// installed), and the targets for speed: reached or not.
void report_targets(const Report& report);

}  // namespace gnathion::bench
