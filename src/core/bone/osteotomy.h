#pragma once

#include <Eigen/Core>
#include <variant>

#include "base/progress.h"
#include "geometry/mesh_types.h"

namespace gnathion {

/// Cuts in this project are bounded: a plane without bounds also cuts the spine and the condyles.

/// Takes what lies inside an oriented box.
struct BoxCut {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();             ///< mm, LPS
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();           ///< columns: orthonormal, LPS
  Eigen::Vector3d half_extents = Eigen::Vector3d::Constant(1);  ///< mm along the axes, positive

  bool operator==(const BoxCut&) const = default;
};

/// The axis-parallel box between two corners, mm, LPS.
BoxCut box_between(const Eigen::Vector3d& min, const Eigen::Vector3d& max);

/// Saws with a finite blade: what lies within the kerf is lost, and the piece at the seed is taken.
struct PlateCut {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();     ///< mm, LPS, in the middle of the kerf
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();    ///< need not be of unit length
  Eigen::Vector3d in_plane = Eigen::Vector3d::UnitX();  ///< the width's direction; made orthogonal
  double half_width = 50;                               ///< mm along in_plane
  double half_height = 50;                              ///< mm along normal × in_plane
  double kerf = 0.5;                                    ///< mm, the whole width of the saw cut
  Eigen::Vector3d seed = Eigen::Vector3d::Zero();       ///< mm, LPS, in or near the piece to take

  bool operator==(const PlateCut&) const = default;
};

using BoundedCut = std::variant<BoxCut, PlateCut>;

struct CutOptions {
  double minimum_volume = 100;  ///< mm³; less is an empty segment
};

struct SegmentResult {
  TriangleMesh segment;      ///< closed, outward, one piece
  TriangleMesh remainder;    ///< closed, outward: all other bone
  double volume_mm3 = 0;     ///< of the segment
  double remainder_mm3 = 0;  ///< of the remainder
  double kerf_mm3 = 0;       ///< lost to the saw (0 for a box)
};

/// Separates a bone segment from the bone. bone: closed, outward, LPS mm; unchanged.
/// A box gives the largest piece inside it (other pieces inside go back to the remainder), a plate
/// the piece nearest to its seed. Volumes add up: bone = segment + remainder + kerf.
/// Throws Error(anatomy) when the bone is open or cuts itself, when the segment is empty, when the
/// blade separates nothing, or when the geometry kernel gives up (the message says why).
SegmentResult cut_segment(const TriangleMesh& bone, const BoundedCut& cut,
                          const CutOptions& options, Progress& progress);

}  // namespace gnathion
