#pragma once

#include <filesystem>

#include "plan/history.h"

namespace gnathion {

/// Reads a case file (docs/case-file.md). Paths in it are relative to its folder.
/// Throws Error(input) when a file cannot be read, Error(case_file) with the key's path for an
/// unknown key, a wrong type or a value out of range.
SurgicalCase read_case_file(const std::filesystem::path& path);

/// The case with the steps that led to it; of a file that keeps none, the case alone.
/// Throws as read_case_file().
PlanHistory read_case_history(const std::filesystem::path& path);

/// Writes the present plan as write_case_file() does, and the steps with it.
void write_case_history(const PlanHistory& history, const std::filesystem::path& path);

/// Writes a case file that read_case_file() reads back as the same case. Paths are written relative
/// to the file's folder where they lie within it. Throws Error(output), and Error(case_file) for a
/// box whose axes are turned.
void write_case_file(const SurgicalCase& plan, const std::filesystem::path& path);

}  // namespace gnathion
