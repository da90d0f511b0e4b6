#pragma once

#include <string>

#include "geometry/mesh_types.h"
#include "geometry/rigid_motion.h"
#include "registration/units.h"

namespace gnathion {

/// Which way a scan's axes run.
struct ProposedAxes {
  Eigen::Matrix3d
      lps_from_scan;  ///< a rotation by right angles: rows are left, posterior, superior
  Confidence confidence = Confidence::low;
  std::string reason;  ///< a sentence for the user
};

/// Of the 24 rotations by right angles the one under which the surface is most like a head that
/// looks forward: the same left and right, faces outward to the front, longer than wide. A
/// proposal: of a scan that was turned by any angle it is only the nearest, which is enough to
/// begin with. surface: faces outward, any unit.
ProposedAxes scan_axes(const TriangleMesh& surface);

/// Throws Error(input) with this subject for a 3×3 or the upper left of a 4×4 that would mirror the
/// patient (determinant below 0), shear or scale its axes differently, or is not finite. Returns it
/// as scale and rotation.
Similarity checked_similarity(const Eigen::Matrix4d& lps_from_scan, const std::string& subject);

}  // namespace gnathion
