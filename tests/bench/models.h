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

/// How far CalculiX, on meshes finer and finer, is from p1's reference; minutes. Nothing where ccx
/// is not installed. Throws Error(input) where the reference is missing.
void report_calculix_reference(const Report& report);

}  // namespace gnathion::bench
