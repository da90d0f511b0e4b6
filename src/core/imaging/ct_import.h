#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/progress.h"
#include "imaging/ct_volume.h"

namespace gnathion {

/// Reads a CT: a folder is a DICOM series (read_series), a file is a volume file
/// (read_volume_file). uid chooses the series of a folder; with a file it must be absent.
/// Throws Error(input) as these do, and when the path does not exist.
CtVolume read_ct(const std::filesystem::path& path, const std::optional<std::string>& uid,
                 Progress& progress);

}  // namespace gnathion
