#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>

#include "base/progress.h"
#include "geometry/rigid_motion.h"

namespace gnathion {

/// What is written; the head itself is always the same.
struct PhantomOptions {
  unsigned seed = 1;              ///< noise, the texture's grain and the DICOM identifiers
  double pixel_mm = 1.0;          ///< of the CT, both directions, 0.4..3
  double slice_step_mm = 1.25;    ///< of the CT, 0.4..3
  double noise_hu = 8;            ///< standard deviation
  double photograph_edge_mm = 2;  ///< mean edge of the photograph's mesh, 1..6
  int texture_pixels = 1536;      ///< width and height of the photograph's texture, 64..8192
  unsigned threads = 0;           ///< 0: as many as there are cores; the bytes do not depend on it
};

/// What is known of the head because it was made. Points in LPS mm.
struct PhantomTruth {
  /// Hard tissue: nasion, a_point, b_point, pogonion, gnathion, menton, gonion_left/_right,
  /// condyle_left/_right, upper_incisor_edge, lower_incisor_edge. Skin: nasion_soft, nose_tip,
  /// subnasale, upper_lip, stomion, lower_lip, mentolabial_fold, pogonion_soft, menton_soft,
  /// mouth_corner_left/_right, mole (on the left cheek).
  std::map<std::string, Eigen::Vector3d> landmarks;
  /// From the mandible's own frame to LPS: its origin lies between the condyles, its axes are
  /// those of LPS (the occlusal plane is horizontal).
  RigidMotion mandible_frame;
  /// From the photograph's own frame (mm, y up, z forwards) to LPS.
  Similarity lps_from_photograph;
  /// A box for the usual osteotomy: it holds the mandible's body with chin and lower teeth, up to
  /// half the resting gap and back to behind the last molars, and no other bone. Rami and angles
  /// stay with the skull.
  Eigen::Vector3d mandible_box_min;
  Eigen::Vector3d mandible_box_max;
};

/// The truth that write_phantom_case writes; it does not depend on any option.
PhantomTruth phantom_truth();

/// Writes the head into `folder`, which must exist and be empty:
///   ct/slice_NNN.dcm                   a CT series, feet to head, signed by made-up identifiers
///   photograph/face.obj, .mtl, .png    the face in its own frame, quads and triangles
///   truth.json                         PhantomTruth and the options, LPS mm
/// The same options give the same bytes. Errors: usage (an option out of range, named), output
/// (folder missing, not empty, or not writable), cancelled.
PhantomTruth write_phantom_case(const std::filesystem::path& folder, const PhantomOptions& options,
                                Progress& progress);

}  // namespace gnathion
