#include "imaging/reduced_volume.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gnathion {

CtVolume reduced(const CtVolume& volume, double step_mm) {
  const Eigen::Array3d wanted = (step_mm / volume.steps().array()).round();
  const Eigen::Array3i limit = (volume.dims().array() / 2).max(1);
  const Eigen::Array3i block = wanted.cast<int>().max(1).min(limit);
  if ((block == 1).all()) return volume;
  const Eigen::Vector3i dims = (volume.dims().array() / block).matrix();
  std::vector<std::int16_t> hu;
  hu.reserve(static_cast<std::size_t>(dims.cast<std::ptrdiff_t>().prod()));
  std::vector<int> row(static_cast<std::size_t>(dims.x()));
  const int count = block.prod();
  for (int k = 0; k < dims.z(); ++k) {
    for (int j = 0; j < dims.y(); ++j) {
      std::fill(row.begin(), row.end(), 0);
      for (int b = 0; b < block.y() * block.z(); ++b) {
        const std::size_t start =
            volume.index(0, j * block.y() + b % block.y(), k * block.z() + b / block.y());
        const std::int16_t* in = volume.hu().data() + start;
        for (int& sum : row) {
          for (int i = 0; i < block.x(); ++i) sum += *in++;
        }
      }
      for (const int sum : row) hu.push_back(static_cast<std::int16_t>(sum / count));
    }
  }
  Eigen::Matrix4d full_from_block = Eigen::Matrix4d::Identity();
  for (int a = 0; a < 3; ++a) {
    full_from_block(a, a) = block(a);
    full_from_block(a, 3) = 0.5 * (block(a) - 1);
  }
  return {dims, std::move(hu), volume.lps_from_ijk() * full_from_block, volume.source()};
}

}  // namespace gnathion
