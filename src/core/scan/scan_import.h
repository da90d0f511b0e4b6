#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>

#include "base/progress.h"
#include "io/obj_document.h"

namespace gnathion {

/// What the reading of one file may take before it is given up.
struct ScanLimits {
  std::uint64_t memory_bytes = 6ULL << 30U;  ///< of the reading program at most
  std::uint64_t output_bytes = 2ULL << 30U;  ///< that it may hand over
  std::chrono::seconds time{60};
};

/// Reads a face scan in its own frame and unit, whatever its format. OBJ is read here, to the
/// letter (ObjDocument::read). The others are read by the program gnathion-scan-reader, which lies
/// beside this one (or where GNATHION_SCAN_READER says), so that a malicious file breaks that
/// program and not a surgeon's session. What of the file is not kept is told as notices.
/// Throws Error(input) naming the file, Error(cancelled) within a tenth of a second.
ObjDocument read_scan(const std::filesystem::path& path, Progress& progress,
                      const ScanLimits& limits = {});

}  // namespace gnathion
