#pragma once

#include <memory>
#include <string>
#include <vector>

#include "imaging/ct_volume.h"
#include "io/obj_document.h"
#include "plan/surgical_case.h"

namespace gnathion {

/// The face that is predicted: a photograph, or the CT's skin in its place.
struct Face {
  TexturedMesh mesh;         ///< mm, LPS; rows are the document's vertices
  ObjDocument document;      ///< as it is in the file
  Similarity lps_from_file;  ///< from the document's frame to LPS
  bool is_photograph = false;

  /// The document's vertices for a face moved to `points` (n×3, mm, LPS). Where a point has not
  /// moved the document's own number comes back, to the bit.
  Points file_vertices(const Points& points) const;
};

/// A piece of bone that was cut off and moves.
struct BoneSegment {
  std::string name;
  TriangleMesh mesh;  ///< closed, outward
  double volume_mm3 = 0;
  Eigen::Vector3d pivot;  ///< about which it turns: the plan's, or its centre of volume
};

/// What a plan is made on: bone, the segments cut from it, and the face, in LPS mm.
struct Anatomy {
  std::shared_ptr<const CtVolume> ct;
  TriangleMesh bone;                  ///< before any cut
  std::vector<BoneSegment> segments;  ///< in the plan's order
  TriangleMesh remainder;             ///< bone that does not move
  /// What each segment's cut left of the bone, but for the last one's: that is the remainder.
  /// For another anatomy that has the first cuts in common; empty where none is made from this.
  std::vector<std::shared_ptr<const TriangleMesh>> left_by_cut;
  Face face;
  std::string ct_sha256;  ///< of the file or folder that was read

  std::vector<Eigen::Vector3d> pivots() const;
};

/// The plan's motions of the segments, LPS mm.
std::vector<RigidMotion> planned_motions(const SurgicalCase& plan, const Anatomy& anatomy);

/// The face alone. Throws Error(input) as read_scan(), Error(cancelled), and Error(input) when the
/// face in LPS is smaller than 60 mm or larger than 1500 mm: then its unit is another.
Face photograph_face(const PhotographSource& source, Progress& progress);

/// An anatomy that stands, and the plan that it was made from.
struct KnownAnatomy {
  const SurgicalCase& plan;
  const Anatomy& anatomy;
};

/// Reads the CT and the photograph of a case, extracts the surfaces and cuts the segments. Without
/// segments the remainder is the bone.
///
/// What the plan has in common with the known one is taken from there, so that no step runs twice
/// on the same input, and the result is that of a build from nothing, to the bit (but for the order
/// of vertices where a saw passes exactly through some: CGAL's depends on addresses): the CT and
/// its hash by its source; bone and skin by the CT and their options; the photograph by its file;
/// segments and remainders up to the first cut that differs. Files count as the same by their
/// paths: one that was changed on disk since is not read again. `known` may go once this returns.
/// Throws Error of kind input or anatomy as the steps do, and Error(cancelled).
Anatomy build_anatomy(const SurgicalCase& plan, Progress& progress,
                      const KnownAnatomy* known = nullptr);

}  // namespace gnathion
