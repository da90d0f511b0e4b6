#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "imaging/ct_volume.h"

namespace gnathion {

/// A plane of the patient, held in its picture as radiologists hold it: axial as seen from the
/// feet, coronal from the front, sagittal from the patient's left.
enum class SlicePlane { axial, coronal, sagittal };
inline constexpr std::array<SlicePlane, 3> all_slice_planes{SlicePlane::axial, SlicePlane::coronal,
                                                            SlicePlane::sagittal};

/// Unit vectors in LPS, each along an axis of the patient.
struct SliceAxes {
  Eigen::Vector3d right;   ///< of the picture
  Eigen::Vector3d down;    ///< of the picture
  Eigen::Vector3d onward;  ///< from slice to slice: up, forward, to the patient's left
};
SliceAxes axes_of(SlicePlane plane);
/// The LPS coordinate that is one number for the whole slice: 2 axial, 1 coronal, 0 sagittal.
int normal_axis(SlicePlane plane);

/// The side of the patient that an edge of the picture shows: one of "RLAPSI".
struct SliceLetters {
  char left, right, top, bottom;
};
SliceLetters letters_of(SlicePlane plane);

/// A place of a slice's picture in mm: x to the right, y down; the picture of LPS zero is zero.
Eigen::Vector2d picture_from_lps(SlicePlane plane, const Eigen::Vector3d& lps);
/// lps: a place in the slice, whose position is kept. Mm.
Eigen::Vector3d lps_from_picture(SlicePlane plane, const Eigen::Vector2d& picture,
                                 const Eigen::Vector3d& lps);

/// Places along the patient's axes at which a volume is shown: the voxels' own where the volume
/// lies straight in the patient, else as fine as its shortest step, over all of it.
struct SliceLattice {
  Eigen::Vector3d origin;  ///< least LPS coordinates, mm
  Eigen::Vector3d step;    ///< mm, positive
  Eigen::Vector3i count;   ///< places along x, y, z

  Eigen::Vector3d last() const;
  /// The place of the lattice nearest to a point, mm, LPS.
  Eigen::Vector3d nearest(const Eigen::Vector3d& lps) const;
};
SliceLattice slice_lattice(const CtVolume& volume);

/// What a slice has where the volume is not: no scanner writes it.
inline constexpr std::int16_t outside_volume = -32768;

/// Hounsfield units of a slice, rows from the picture's top.
struct CtSlice {
  int width = 0, height = 0;
  std::vector<std::int16_t> hu;  ///< width · height; outside_volume beyond the voxels
  Eigen::Vector2d corner{0, 0};  ///< of the upper left pixel (its outer corner), picture mm
  Eigen::Vector2d pixel{1, 1};   ///< size, mm

  std::int16_t at(int x, int y) const { return hu[static_cast<std::size_t>(y) * width + x]; }
};

/// The volume in the plane through `lps` (mm), trilinear between voxel centres and rounded, a pixel
/// for every place of the lattice; half a voxel beyond the outermost centres still belongs to them.
/// The affine may be oblique, sheared or left-handed. `slice` is reused where it has room.
void cut_slice(const CtVolume& volume, const SliceLattice& lattice, SlicePlane plane,
               const Eigen::Vector3d& lps, CtSlice& slice);

}  // namespace gnathion
