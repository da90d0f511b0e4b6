#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// What each format of a face scan keeps, and what reading, looking at and writing one of 500 000
/// triangles with a picture of 8192² pixels costs.
void report_scans(const Report& report);

}  // namespace gnathion::bench
