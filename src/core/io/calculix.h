#pragma once

#include <filesystem>

#include "fem/elements.h"
#include "fem/material.h"

namespace gnathion {

/// The same problem as the solvers of fem/ are asked.
struct CalculixProblem {
  ElementMesh elements;
  TissueMaterials materials;
  Supports supports;  ///< one a node of `elements`
  Points prescribed;  ///< n×3, mm, read where a support prescribes
  /// Neo-Hookean tissue and large displacements (NLGEOM) instead of Hooke and Cauchy:
  ///   W = μ/2 (J^(−2/3) tr FᵀF − 3) + κ/2 (J − 1)²,
  /// ccx's C10 = μ/2, D1 = 2/κ, with increments and tolerances small enough to compare with.
  bool neo_hookean = false;
  /// n×3, mm, or empty. What ccx prints is then its displacements less these, so that its seven
  /// digits are digits of the difference.
  Points compared_with = {};
};

/// Writes an input deck for CalculiX (ccx): C3D4 or C3D10, N–mm–MPa. A sliding node gets one linear
/// equation (*EQUATION) on its component along the normal. ccx prints the displacements into the
/// .dat file.
/// Throws Error(output).
void write_calculix_deck(const CalculixProblem& problem, const std::filesystem::path& deck);

/// Displacements (n×3, mm) at the end of the last increment from ccx's .dat file, or their
/// difference from `compared_with`: printed with seven digits; 0 for nodes that it does not name,
/// since nodes of no element are not in the deck. Throws Error(input) when the file is missing or
/// names no node.
Points read_calculix_displacements(const std::filesystem::path& dat, Eigen::Index node_count);

}  // namespace gnathion
