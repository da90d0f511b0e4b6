#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"

namespace gnathion {

enum class VoxelType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Where the voxels of a volume file are, how they are stored, and where they lie.
struct VolumeHeader {
  Eigen::Vector3i dims = Eigen::Vector3i::Zero();
  VoxelType type = VoxelType::int16;
  bool big_endian = false;
  bool compressed = false;          ///< zlib or gzip
  std::filesystem::path data_file;  ///< empty: in the same file
  long long data_offset = 0;        ///< bytes; −1: the data end where the file ends
  double slope = 1;                 ///< HU = slope · stored + intercept
  double intercept = 0;
  Eigen::Matrix4d lps_from_ijk = Eigen::Matrix4d::Identity();  ///< mm
};

int byte_size(VoxelType type);

/// Each parses the beginning of a file. bytes: the file (NIfTI: unpacked). Throws Error(input)
/// that names the field; notices tell what was assumed.
VolumeHeader parse_meta_image(const std::string& bytes, const std::filesystem::path& path,
                              Progress& progress);
VolumeHeader parse_nrrd(const std::string& bytes, const std::filesystem::path& path,
                        Progress& progress);
VolumeHeader parse_nifti(const std::string& bytes, const std::filesystem::path& path,
                         Progress& progress);

}  // namespace gnathion
