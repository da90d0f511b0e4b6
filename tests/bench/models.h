#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// Speed against error of every model offered × meshes, on p1, p2 and the cases' heads. The
/// patches' reference is read from the report's folder: report_reference() makes it. Throws
/// Error(input) where it is missing.
void report_models(const Report& report, const std::vector<std::string>& cases);

/// Computes the reference of the patches, minutes and gigabytes, into reference-*.csv, and says how
/// sure it is.
void report_reference(const Report& report);

}  // namespace gnathion::bench
