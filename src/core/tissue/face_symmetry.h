#pragma once

#include "geometry/bsp_tree.h"
#include "geometry/mesh_types.h"
#include "tissue/region_shape.h"

namespace gnathion {

/// The plane normal · x = offset that best mirrors a face onto itself.
struct SymmetryPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< unit, LPS, to the patient's left
  double offset = 0;                                  ///< mm
  double error_mm = 0;  ///< mean distance of the mirrored face from the face, of the best 80 %

  Eigen::Vector3d mirrored(const Eigen::Vector3d& x) const {
    return x - 2 * (normal.dot(x) - offset) * normal;
  }
};

/// Found by mirroring the front 90 mm of the face and laying the mirrored face on the face (to
/// the planes of the nearest triangles, the worse fifth left out, until nothing moves), starting
/// from the sagittal plane through the middle of that front. `tree`: of the face's surface. LPS mm.
/// Throws Error(anatomy) when there is no symmetry to be found: less than half of the mirrored
/// points are within 20 mm of the face.
SymmetryPlane find_symmetry(const TriangleMesh& face, const BspTree& tree);

/// A selection together with its mirror image: a vertex is in the image when the point of the face
/// nearest to where it is mirrored to, at most 15 mm away and with the same side out, is in the
/// selection. `tree`: of the brush's face.
Selection with_mirror_image(const SurfaceBrush& brush, const BspTree& tree,
                            const SymmetryPlane& plane, const Selection& selection);

}  // namespace gnathion
