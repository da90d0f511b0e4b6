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

/// m×6 dihedral angles in degrees, of the edges 01, 02, 03, 12, 13, 23 of each tet (between the two
/// faces that meet there, inside the tet).
Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor> dihedral_angles(const TetMesh& mesh);

/// m×12 angles of the triangles of each tet in degrees: three of the face opposite to corner 0,
/// then of those opposite to 1, 2 and 3, each at its corners in ascending order.
Eigen::Matrix<double, Eigen::Dynamic, 12, Eigen::RowMajor> face_angles(const TetMesh& mesh);

/// m aspect ratios: longest edge over shortest height, scaled to 1 for a regular tet; infinite
/// without volume.
Eigen::VectorXd aspect_ratios(const TetMesh& mesh);

}  // namespace gnathion
