#include "imaging/ct_volume.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"

namespace gnathion {
namespace {

void check_grid(const Eigen::Vector3i& dims, std::size_t count, const Eigen::Matrix4d& affine,
                const std::string& source) {
  const std::string remedy = "export the CT again, with at least two slices";
  if (dims.minCoeff() < 2) {
    throw Error(ErrorKind::input, source,
                "is no volume: it has fewer than two voxels along an axis", remedy);
  }
  const std::size_t expected = static_cast<std::size_t>(dims.x()) * dims.y() * dims.z();
  if (count != expected) {
    throw Error(
        ErrorKind::input, source,
        "has " + std::to_string(count) + " voxels where its size needs " + std::to_string(expected),
        remedy);
  }
  const Eigen::Matrix3d linear = affine.topLeftCorner<3, 3>();
  const double steps = linear.col(0).norm() * linear.col(1).norm() * linear.col(2).norm();
  const bool affine_row = affine.row(3) == Eigen::RowVector4d(0, 0, 0, 1);
  if (!affine.allFinite() || !affine_row || !(steps > 0) ||
      std::abs(linear.determinant()) < 1e-6 * steps) {
    throw Error(ErrorKind::input, source,
                "has no usable place in the patient: its axes are zero, parallel or not finite",
                remedy);
  }
}

}  // namespace

CtVolume::CtVolume(Eigen::Vector3i dims, std::vector<std::int16_t> hu,
                   const Eigen::Matrix4d& lps_from_ijk, std::string source)
    : dims_(std::move(dims)), lps_from_ijk_(lps_from_ijk), source_(std::move(source)) {
  check_grid(dims_, hu.size(), lps_from_ijk_, source_);
  hu_ = std::make_shared<const std::vector<std::int16_t>>(std::move(hu));
  ijk_from_lps_ = Eigen::Affine3d(lps_from_ijk_).inverse().matrix();
}

Eigen::Vector3d CtVolume::steps() const {
  return lps_from_ijk_.topLeftCorner<3, 3>().colwise().norm();
}

Eigen::Vector3d CtVolume::lps(const Eigen::Vector3d& ijk) const {
  return lps_from_ijk_.topLeftCorner<3, 3>() * ijk + lps_from_ijk_.topRightCorner<3, 1>();
}

Eigen::Vector3d CtVolume::ijk(const Eigen::Vector3d& lps) const {
  return ijk_from_lps_.topLeftCorner<3, 3>() * lps + ijk_from_lps_.topRightCorner<3, 1>();
}

double CtVolume::sample(const Eigen::Vector3d& lps, double outside) const {
  const Eigen::Vector3d p = ijk(lps);
  // Rounding must not put a point on the last voxel's centre outside.
  const Eigen::Array3d last = (dims_.array() - 1).cast<double>();
  if ((p.array() < -1e-9).any() || (p.array() > last + 1e-9).any()) return outside;
  const Eigen::Array3i cell = p.array().floor().cast<int>().max(0).min(dims_.array() - 2);
  const Eigen::Array3d t = p.array() - cell.cast<double>();
  const auto along_i = [&](int dj, int dk) {
    const std::int16_t* v = hu_->data() + index(cell.x(), cell.y() + dj, cell.z() + dk);
    return v[0] + t.x() * (v[1] - v[0]);
  };
  const double front = along_i(0, 0) + t.y() * (along_i(1, 0) - along_i(0, 0));
  const double back = along_i(0, 1) + t.y() * (along_i(1, 1) - along_i(0, 1));
  return front + t.z() * (back - front);
}

CtVolume cropped(const CtVolume& volume, const LpsBox& box) {
  Eigen::Array3d low = Eigen::Array3d::Constant(1e300);
  Eigen::Array3d high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p((corner & 1) ? box.max.x() : box.min.x(),
                            (corner & 2) ? box.max.y() : box.min.y(),
                            (corner & 4) ? box.max.z() : box.min.z());
    const Eigen::Array3d index = volume.ijk(p).array();
    low = low.min(index);
    high = high.max(index);
  }
  const Eigen::Array3d limit = (volume.dims().array() - 1).cast<double>();
  const Eigen::Array3i first = low.floor().max(0).min(limit).cast<int>();
  const Eigen::Array3i last = high.ceil().max(0).min(limit).cast<int>();
  if ((box.min.array() >= box.max.array()).any() || (high < 0).any() || (low > limit).any() ||
      (last - first < 1).any()) {
    throw Error(ErrorKind::input, volume.source(), "the crop box does not meet the volume",
                "give the box in LPS mm, min below max, inside the volume");
  }
  const Eigen::Vector3i dims = (last - first + 1).matrix();
  std::vector<std::int16_t> hu;
  hu.reserve(static_cast<std::size_t>(dims.x()) * dims.y() * dims.z());
  for (int k = first.z(); k <= last.z(); ++k) {
    for (int j = first.y(); j <= last.y(); ++j) {
      const auto row =
          volume.hu().begin() + static_cast<std::ptrdiff_t>(volume.index(first.x(), j, k));
      hu.insert(hu.end(), row, row + dims.x());
    }
  }
  Eigen::Matrix4d affine = volume.lps_from_ijk();
  affine.topRightCorner<3, 1>() = volume.lps(first.matrix().cast<double>());
  return CtVolume(dims, std::move(hu), affine, volume.source());
}

}  // namespace gnathion
