#pragma once

#include <filesystem>

#include "plan/history.h"

namespace gnathion {

/// Whether the path names something below the folder. Nothing is looked up on disk.
bool lies_within(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Copies the CT and the photograph of every step, where they lie within `folder`, into the new
/// folder `target`, which appears whole or not at all. An input is copied with all that lies beside
/// it, up to `folder`: a photograph needs its textures.
/// Throws Error(output) as NewFolder, Error(input) for what is not there to be copied.
void copy_inputs(const PlanHistory& history, const std::filesystem::path& folder,
                 const std::filesystem::path& target);

/// The same plan, naming the copies that copy_inputs() makes.
SurgicalCase with_copied_inputs(SurgicalCase plan, const std::filesystem::path& folder,
                                const std::filesystem::path& target);
/// Likewise in every step.
PlanHistory with_copied_inputs(const PlanHistory& history, const std::filesystem::path& folder,
                               const std::filesystem::path& target);

}  // namespace gnathion
