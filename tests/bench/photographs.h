#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// Ordinary photographs of the analytic head from known cameras, projected onto its CT's skin: the
/// cameras found from picked landmarks, where the texture lands, its colours, and a picture.
void report_photographs(const Report& report);

}  // namespace gnathion::bench
