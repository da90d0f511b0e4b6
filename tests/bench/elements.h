#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// The elements that were compared, at the same mesh: linear, linear with the volume averaged at
/// the nodes, quadratic with full integration, and the program's quadratic ones. Error and time on
/// p1 with the chin driven 5 mm and on Cook's membrane.
void report_elements(const Report& report);

}  // namespace gnathion::bench
