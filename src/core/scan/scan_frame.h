#pragma once

#include <string>
#include <vector>

#include "geometry/mesh_types.h"
#include "geometry/rigid_motion.h"

namespace gnathion {

/// How sure a proposal is, for words beside it; it is asked for all the same.
enum class Confidence { low, fair, high };

/// A unit that a scan may be in.
struct ProposedUnit {
  std::string name;  ///< "m", "cm", "mm", "inch"; empty: no usual one
  double mm_per_unit = 1;
  Confidence confidence = Confidence::low;
  std::string reason;  ///< a sentence for the user
};

/// The units that would make the scan as large as a face or a head with shoulders, the likeliest
/// first, each with its reason, inches last and never sure; where none does, one without a name
/// that makes the longest side 260 mm. vertices: n×3 in the scan's unit, finite, at least one.
/// Strays are not counted (robust_size()).
std::vector<ProposedUnit> scan_units(const Points& vertices);

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
