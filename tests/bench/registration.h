#pragma once

#include <string>
#include <vector>

#include "bench/report.h"

namespace gnathion::bench {

/// Registration: 100 random starts of the analytic head's scan with every fault, easier and harder
/// ones, scans that have no place on the skin, the time for 500 000 triangles, and the photographs
/// of the case files. Returns how many wrong places were not announced; there must be none.
int report_registration(const Report& report, const std::vector<std::string>& cases);

}  // namespace gnathion::bench
