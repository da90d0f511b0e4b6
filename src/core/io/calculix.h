#pragma once

#include <filesystem>

#include "fem/static_solver.h"

namespace gnathion {

/// Writes the same problem as a CalculiX (ccx) input deck: linear tets (C3D4), fixed nodes held,
/// attached nodes moved by `prescribed` (n×3, mm), N–mm–MPa. ccx prints all displacements into the
/// .dat file. Throws Error(output).
void write_calculix_deck(const TetMesh& mesh, const ElasticMaterial& material,
                         const Supports& supports, const Points& prescribed,
                         const std::filesystem::path& deck);

/// Displacements (n×3, mm) from ccx's .dat file: printed with seven digits; 0 for nodes that it
/// does not name, since nodes of no element are not in the deck. Throws Error(input) when the file
/// is missing or names no node.
Points read_calculix_displacements(const std::filesystem::path& dat, Eigen::Index node_count);

}  // namespace gnathion
