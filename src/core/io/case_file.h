#pragma once

#include <filesystem>

#include "plan/history.h"

namespace gnathion {

/// Reads the plan of a case file (docs/case-file.md); the steps that led to it are not looked at.
/// Paths in it are relative to its folder.
/// Throws Error(input) when a file cannot be read, Error(case_file) with the key's path for an
/// unknown key, a wrong type or a value out of range.
SurgicalCase read_case_file(const std::filesystem::path& path);

/// The case with the steps that led to it; of a file that keeps none, the case alone as the step
/// "Open". The present plan is that of read_case_file(); the other steps are told by how they
/// differ from it. Throws as read_case_file(), and Error(case_file) with the step for one that
/// cannot be made from its neighbour ("case.json: history.steps[3].region").
PlanHistory read_case_history(const std::filesystem::path& path);

/// Writes a case file that read_case_history() reads back as the same steps, to the bit, and
/// read_case_file() as the present plan. All is in the one file, which changes whole or not at all.
/// Paths are written relative to the file's folder where they lie within it, otherwise absolute.
/// Throws Error(output), also for a name that is not UTF-8.
void write_case_history(const PlanHistory& history, const std::filesystem::path& path);

/// The same for a plan without steps.
void write_case_file(const SurgicalCase& plan, const std::filesystem::path& path);

}  // namespace gnathion
