#pragma once

#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// n signed volumes in mm³, positive for a tet that is not inverted.
Eigen::VectorXd tet_volumes(const TetMesh& mesh);

/// How well shaped the elements of a mesh are: the measures of the paper's Fig. 5.
struct TetQuality {
  long count = 0;
  long inverted = 0;             ///< tets with a volume of zero or less
  double total_volume = 0;       ///< mm³
  double smallest_volume = 0;    ///< mm³
  double smallest_dihedral = 0;  ///< degrees
  double largest_dihedral = 0;   ///< degrees
  double median_aspect = 0;      ///< longest edge over shortest height, scaled to 1 for regular
  double largest_aspect = 0;
};

TetQuality tet_quality(const TetMesh& mesh);

}  // namespace gnathion
