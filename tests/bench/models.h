#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// Speed against error of every model offered × meshes, on p1, p2 and the cases' heads. The
/// references are read from the report's folder: report_reference() makes them. Scenes without one
/// are left out, and named.
void report_models(const Report& report, const std::vector<std::string>& cases);

/// Computes the references, minutes and gigabytes, into reference-*.csv, and says how sure they
/// are.
void report_reference(const Report& report, const std::vector<std::string>& cases);

}  // namespace gnathion::bench
