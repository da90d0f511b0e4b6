#include "phantom/phantom_ct.h"

#include <array>

#include "phantom/parallel_rows.h"
#include "phantom/repeatable_random.h"

namespace gnathion {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr int block = 8;  // voxels along a block's side

enum Part { skin, skull, mandible, spine, teeth, brain, airway, eyeballs, muscle, part_count };

constexpr std::array<double (HeadModel::*)(const Vector3d&) const, part_count> part_distance = {
    &HeadModel::skin,   &HeadModel::skull,    &HeadModel::mandible,
    &HeadModel::spine,  &HeadModel::teeth,    &HeadModel::brain,
    &HeadModel::airway, &HeadModel::eyeballs, &HeadModel::muscle};

using Distances = std::array<double, part_count>;

/// Share of what a voxel sees that lies inside a surface `d` mm away. A scanner's slice and kernel
/// blur over about two voxels (`width` mm); a sharper step would show as terraces in iso-surfaces.
double cover(double d, double width) {
  const double t = std::clamp(0.5 - d / width, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

void mix(double& value, double other, double share) {
  value += share * (other - value);
}

/// Soft tissue, Hounsfield units, where the skin is `depth` mm away.
double soft_tissue(const Distances& d, double fat_depth, double width) {
  const double depth = -d[skin];
  double hu = 50;
  const double fat = cover(depth - 2 - fat_depth, width) * cover(2 - depth, width);
  mix(hu, -90, fat * (1 - cover(d[muscle], width)));
  mix(hu, 40, cover(depth - 2, width));
  // The eyeball lies in fat.
  mix(hu, -80, cover(d[eyeballs] - 5, 3) * cover(6 - depth, 2));
  mix(hu, 12, cover(d[eyeballs], width));
  mix(hu, 35, cover(d[brain] + 1, width));
  mix(hu, -1000, cover(d[airway], width));
  return hu;
}

double hounsfield(const Distances& d, double fat_depth, double z, double width) {
  double hu = -1000;
  mix(hu, soft_tissue(d, fat_depth, width), cover(d[skin], width));
  const double bone = std::min({d[skull], d[mandible], d[spine]});
  const double marrow = cover(bone + 2.4, 1.6);
  mix(hu, 1400 - 1000 * marrow, cover(bone, width));
  const bool crown = std::abs(z + 43.4) < 9;
  mix(hu, crown ? 2400 : 1900, cover(d[teeth], width));
  return hu;
}

/// Fills one block; a part that is farther than the block is large is not evaluated again.
void fill_block(const HeadModel& head, const Vector3i& first, double noise_hu, std::uint64_t seed,
                PhantomVolume& volume) {
  const Vector3i last = (first + Vector3i::Constant(block)).cwiseMin(volume.size);
  const Vector3d middle = (first + last - Vector3i::Ones()).cast<double>() / 2;
  const Vector3d centre = volume.origin + middle.cwiseProduct(volume.spacing);
  const double reach =
      1.4 * (last - first).cast<double>().cwiseProduct(volume.spacing).norm() / 2 + 8;
  const double width = 2 * volume.spacing.mean();
  Distances d;
  std::array<bool, part_count> near;
  for (int part = 0; part < part_count; ++part) {
    d[part] = part > skin && d[skin] > reach ? 1e3 : (head.*part_distance[part])(centre);
    near[part] = std::abs(d[part]) < reach;
  }
  const bool only_air = d[skin] > reach;
  for (int k = first.z(); k < last.z(); ++k) {
    for (int j = first.y(); j < last.y(); ++j) {
      for (int i = first.x(); i < last.x(); ++i) {
        const std::size_t index =
            (static_cast<std::size_t>(k) * volume.size.y() + j) * volume.size.x() + i;
        double hu = -1000;
        if (!only_air) {
          const Vector3d p = volume.origin + Vector3d(i, j, k).cwiseProduct(volume.spacing);
          for (int part = 0; part < part_count; ++part) {
            d[part] = near[part] ? (head.*part_distance[part])(p) : d[part];
          }
          hu = hounsfield(d, near[skin] ? head.fat_depth(p) : 0, p.z(), width);
        }
        hu += noise_hu * normal(seed + index);
        volume.hounsfield[index] =
            static_cast<std::int16_t>(std::lround(std::clamp(hu, -1024.0, 3071.0)));
      }
    }
  }
}

}  // namespace

PhantomVolume make_phantom_volume(const HeadModel& head, const PhantomOptions& options,
                                  Progress& progress) {
  const auto stage = progress.stage("phantom CT");
  const Vector3d low(-92, -136, -118);
  const Vector3d high(92, 104, 132);
  PhantomVolume volume;
  volume.spacing = {options.pixel_mm, options.pixel_mm, options.slice_step_mm};
  volume.origin = low;
  volume.size = ((high - low).cwiseQuotient(volume.spacing)).array().floor().cast<int>() + 1;
  volume.hounsfield.resize(static_cast<std::size_t>(volume.size.x()) * volume.size.y() *
                           volume.size.z());
  const Vector3i blocks = (volume.size + Vector3i::Constant(block - 1)) / block;
  const std::uint64_t seed = mixed(options.seed) & 0x00ffffffffffffffULL;
  for_each_row(blocks.y() * blocks.z(), options.threads, progress, [&](int row) {
    for (int i = 0; i < blocks.x(); ++i) {
      const Vector3i first = block * Vector3i(i, row % blocks.y(), row / blocks.y());
      fill_block(head, first, options.noise_hu, seed, volume);
    }
  });
  return volume;
}

}  // namespace gnathion
