#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// Time and memory of every stage on patches of 5 000 to `largest` tets, with the exponents of
/// their growth, and how near a drag frame comes to the machine's read bandwidth.
void report_scaling(const Report& report, long largest);

}  // namespace gnathion::bench
