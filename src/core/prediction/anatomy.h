#pragma once

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

/// What a plan is made on: bone, the segment cut from it, and the face, in LPS mm.
struct Anatomy {
  TriangleMesh bone;
  SegmentResult cut;
  Face face;
  Eigen::Vector3d pivot;  ///< about which the segment turns: the plan's, or its centre of volume
  std::string ct_sha256;  ///< of the file or folder that was read
};

/// The face alone. Throws Error(input) as ObjDocument::read, and when the face in LPS is smaller
/// than 60 mm or larger than 1500 mm: then its unit is another.
Face photograph_face(const PhotographSource& source);

/// Reads the CT and the photograph of a case, extracts the surfaces and cuts the segment.
/// Throws Error of kind input or anatomy as the steps do, and Error(cancelled).
Anatomy build_anatomy(const SurgicalCase& plan, Progress& progress);

}  // namespace gnathion
