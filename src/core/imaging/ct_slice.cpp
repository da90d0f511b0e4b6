#include "imaging/ct_slice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gnathion {
namespace {

/// \pre direction is along an axis of the patient.
char letter_of(const Eigen::Vector3d& direction) {
  const char* const letters[3] = {"LR", "PA", "SI"};
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return letters[axis][direction(axis) > 0 ? 0 : 1];
}

/// Trilinear between the centres of voxels, with indices given as floats: a thousandth of a voxel
/// is left of them in a volume of 4096 voxels a side.
class Interpolator {
 public:
  explicit Interpolator(const CtVolume& volume)
      : hu_(volume.hu().data()),
        row_(volume.dims().x()),
        slab_(static_cast<std::ptrdiff_t>(volume.dims().x()) * volume.dims().y()),
        second_last_(volume.dims().array() - 2) {}

  std::int16_t at(float i, float j, float k) const {
    int ci, cj, ck;
    if (!locate(0, i, ci) || !locate(1, j, cj) || !locate(2, k, ck)) return outside_volume;
    const std::int16_t* v = hu_ + ck * slab_ + cj * row_ + ci;
    const auto along_i = [i](const std::int16_t* at) {
      return static_cast<float>(at[0]) + i * static_cast<float>(at[1] - at[0]);
    };
    const float front = along_i(v) + j * (along_i(v + row_) - along_i(v));
    const std::int16_t* w = v + slab_;
    const float back = along_i(w) + j * (along_i(w + row_) - along_i(w));
    return static_cast<std::int16_t>(std::lrintf(front + k * (back - front)));
  }

 private:
  /// index: becomes the fraction within the cell. False beyond the voxels.
  bool locate(int axis, float& index, int& cell) const {
    const int most = second_last_(axis);
    if (!(index > -0.5F && index < static_cast<float>(most) + 1.5F)) return false;
    cell = std::clamp(static_cast<int>(index), 0, most);
    index = std::clamp(index - static_cast<float>(cell), 0.0F, 1.0F);
    return true;
  }

  const std::int16_t* hu_;
  std::ptrdiff_t row_, slab_;
  Eigen::Array3i second_last_;
};

}  // namespace

SliceAxes axes_of(SlicePlane plane) {
  const Eigen::Vector3d left = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d posterior = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d superior = Eigen::Vector3d::UnitZ();
  switch (plane) {
    case SlicePlane::axial:
      return {left, posterior, superior};
    case SlicePlane::coronal:
      return {left, -superior, -posterior};
    case SlicePlane::sagittal:
      break;
  }
  return {posterior, -superior, left};
}

int normal_axis(SlicePlane plane) {
  return plane == SlicePlane::axial ? 2 : plane == SlicePlane::coronal ? 1 : 0;
}

SliceLetters letters_of(SlicePlane plane) {
  const SliceAxes axes = axes_of(plane);
  return {letter_of(-axes.right), letter_of(axes.right), letter_of(-axes.down),
          letter_of(axes.down)};
}

Eigen::Vector2d picture_from_lps(SlicePlane plane, const Eigen::Vector3d& lps) {
  const SliceAxes axes = axes_of(plane);
  return {axes.right.dot(lps), axes.down.dot(lps)};
}

Eigen::Vector3d lps_from_picture(SlicePlane plane, const Eigen::Vector2d& picture,
                                 const Eigen::Vector3d& lps) {
  const SliceAxes axes = axes_of(plane);
  return axes.right * picture.x() + axes.down * picture.y() + axes.onward * axes.onward.dot(lps);
}

Eigen::Vector3d SliceLattice::last() const {
  return origin + ((count.array() - 1).cast<double>() * step.array()).matrix();
}

Eigen::Vector3d SliceLattice::nearest(const Eigen::Vector3d& lps) const {
  const Eigen::Array3d index = ((lps - origin).array() / step.array()).round();
  const Eigen::Array3d last_index = (count.array() - 1).cast<double>();
  return origin + (index.max(0).min(last_index) * step.array()).matrix();
}

SliceLattice slice_lattice(const CtVolume& volume) {
  const Eigen::Vector3d last = (volume.dims().array() - 1).cast<double>();
  Eigen::Array3d low = Eigen::Array3d::Constant(1e300);
  Eigen::Array3d high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d ijk((corner & 1) ? last.x() : 0, (corner & 2) ? last.y() : 0,
                              (corner & 4) ? last.z() : 0);
    low = low.min(volume.lps(ijk).array());
    high = high.max(volume.lps(ijk).array());
  }
  SliceLattice lattice;
  lattice.origin = low;
  lattice.step.setConstant(volume.steps().minCoeff());
  Eigen::Vector3d own = Eigen::Vector3d::Zero();  // of the voxels' steps along the patient's axes
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = volume.lps_from_ijk().block<3, 1>(0, i);
    Eigen::Index axis = 0;
    if (step.cwiseAbs().maxCoeff(&axis) > 0.99999 * step.norm()) own(axis) = step.norm();
  }
  if (own.minCoeff() > 0) lattice.step = own;
  // Rounding must not lose the last place.
  lattice.count = ((high - low) / lattice.step.array() + 1e-4).floor().cast<int>() + 1;
  return lattice;
}

void cut_slice(const CtVolume& volume, const SliceLattice& lattice, SlicePlane plane,
               const Eigen::Vector3d& lps, CtSlice& slice) {
  const SliceAxes axes = axes_of(plane);
  const Eigen::Vector3d last = lattice.last();
  slice.width =
      static_cast<int>(std::lround(std::abs(axes.right.dot(lattice.count.cast<double>()))));
  slice.height =
      static_cast<int>(std::lround(std::abs(axes.down.dot(lattice.count.cast<double>()))));
  slice.pixel = picture_from_lps(plane, lattice.step).cwiseAbs();
  const Eigen::Vector2d first =
      picture_from_lps(plane, lattice.origin).cwiseMin(picture_from_lps(plane, last));
  slice.corner = first - slice.pixel / 2;
  slice.hu.resize(static_cast<std::size_t>(slice.width) * slice.height);

  const Eigen::Matrix3d linear = volume.ijk_from_lps().topLeftCorner<3, 3>();
  const Eigen::Vector3d start = volume.ijk(lps_from_picture(plane, first, lps));
  const Eigen::Vector3f across = (linear * axes.right * slice.pixel.x()).cast<float>();
  const Eigen::Vector3d below = linear * axes.down * slice.pixel.y();
  const Interpolator interpolator(volume);
  std::int16_t* out = slice.hu.data();
  for (int y = 0; y < slice.height; ++y) {
    const Eigen::Vector3f row = (start + y * below).cast<float>();
    for (int x = 0; x < slice.width; ++x) {
      const auto step = static_cast<float>(x);
      *out++ = interpolator.at(row.x() + step * across.x(), row.y() + step * across.y(),
                               row.z() + step * across.z());
    }
  }
}

}  // namespace gnathion
