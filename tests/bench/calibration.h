#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// The program's error estimates against true errors on p1: their ratio (effectivity) for
/// translations of 3 to 10 mm and turns of 5 and 10 degrees.
void report_calibration(const Report& report);

}  // namespace gnathion::bench
