#pragma once

#include <filesystem>

#include "base/progress.h"

namespace gnathion {

/// Writes the embedded default case into the new folder `target`: ct/, photograph/, truth.json (see
/// phantom/head_phantom.h) and case.json, a mandible 6 mm forward. The folder appears whole or not
/// at all; the same seed gives the same bytes.
/// Throws Error(output) when `target` exists or cannot be written, Error(cancelled).
void write_demo_case(unsigned seed, const std::filesystem::path& target, Progress& progress);

}  // namespace gnathion
