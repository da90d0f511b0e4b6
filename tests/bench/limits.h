#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// The table of hard cases (hard_cases.h), those that do not hold marked. Returns how many.
int report_hard_cases(const Report& report);

}  // namespace gnathion::bench
