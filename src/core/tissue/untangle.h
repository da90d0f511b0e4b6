#pragma once

#include <vector>

#include "tissue/soft_tissue_mesh.h"

namespace gnathion {

/// Moves inner and centre nodes until no tet is smaller than it may be: each such node of a tet
/// that is goes where the worst shaped of all its tets is better (a search along the gradients of
/// their shapes), in sweeps over the nodes. The surface stays. Of a mesh of one layer; its depth
/// follows. Returns the tets that are still too small after `sweeps`. least: of the volumes of the
/// tets, mm³, > 0.
std::vector<int> untangle(const Eigen::VectorXd& least, int sweeps, SoftTissueMesh& tissue);

}  // namespace gnathion
