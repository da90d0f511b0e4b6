#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "io/json_reader.h"
#include "plan/surgical_case.h"

namespace gnathion {

/// A plan as the JSON object of a case file and back (docs/case-file.md). For .cpp files of this
/// folder. case_file: to whose folder paths are relative.

/// All of a plan but the lists of vertices: region.vertices, tissue.sliding_vertices and
/// photograph.stable_vertices.
/// Doubles come back to the bit.
nlohmann::json plan_json(const SurgicalCase& plan, const std::filesystem::path& case_file);

/// The plan of an object, its lists of vertices included. Throws Error(input) when a file of
/// vertices cannot be read, Error(case_file) with the key's path for an unknown key, a wrong type
/// or a value out of range.
SurgicalCase read_plan(JsonReader& root, const std::filesystem::path& case_file);

}  // namespace gnathion
