#include "imaging/volume_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "imaging/volume_header.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& problem,
                         const std::string& remedy) {
  throw Error(ErrorKind::input, path.string(), problem, remedy);
}

std::string file_bytes(const fs::path& path) {
  std::error_code failed;
  const auto size = fs::is_regular_file(path, failed) ? fs::file_size(path, failed) : 0;
  std::ifstream in(path, std::ios::binary);
  if (failed || !in || !fs::is_regular_file(path, failed)) {
    refuse(path, "does not exist or cannot be opened", "check the path and its permissions");
  }
  std::string bytes(size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(in.gcount()) != size) {
    refuse(path, "cannot be read to its end", "copy the file again");
  }
  return bytes;
}

/// At most `limit` bytes of the zlib or gzip stream that begins at `offset`; fewer when the stream
/// ends before or is cut short. Throws Error(input) when it is damaged.
std::string inflated(const std::string& packed, std::size_t offset, std::size_t limit,
                     const fs::path& path) {
  // deflate packs no better than 1032 : 1, so a small file cannot ask for all memory.
  std::string out(std::min(limit, 1100 * packed.size()), '\0');
  limit = out.size();
  z_stream stream{};
  // 15 + 32: the largest window, zlib or gzip by the stream's own header.
  if (inflateInit2(&stream, 15 + 32) != Z_OK) refuse(path, "cannot be unpacked", "free memory");
  std::size_t read = offset, written = 0;
  int status = Z_OK;
  constexpr std::size_t most = 1U << 30;  // zlib counts in 32 bits
  while (status == Z_OK && written < limit && read < packed.size()) {
    const std::size_t in = std::min(packed.size() - read, most);
    const std::size_t room = std::min(limit - written, most);
    // zlib's interface is not const-correct; it does not write here.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + read));
    stream.avail_in = static_cast<uInt>(in);
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + written);
    stream.avail_out = static_cast<uInt>(room);
    status = inflate(&stream, Z_NO_FLUSH);
    read += in - stream.avail_in;
    written += room - stream.avail_out;
  }
  inflateEnd(&stream);
  if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) {
    refuse(path, "is damaged: its compressed data cannot be unpacked", "copy the file again");
  }
  out.resize(written);
  return out;
}

template <typename Stored>
long long to_hu(const char* raw, const VolumeHeader& header, std::vector<std::int16_t>& hu) {
  const bool swap = header.big_endian == (std::endian::native == std::endian::little);
  constexpr double lowest = std::numeric_limits<std::int16_t>::min();
  constexpr double highest = std::numeric_limits<std::int16_t>::max();
  long long not_a_number = 0;
  for (std::size_t i = 0; i < hu.size(); ++i) {
    std::array<char, sizeof(Stored)> one;
    std::memcpy(one.data(), raw + i * sizeof(Stored), sizeof(Stored));
    if (swap) std::reverse(one.begin(), one.end());
    const double value =
        header.slope * static_cast<double>(std::bit_cast<Stored>(one)) + header.intercept;
    if (std::isnan(value)) {
      ++not_a_number;
      hu[i] = -1024;
    } else {
      hu[i] = static_cast<std::int16_t>(std::floor(std::clamp(value, lowest, highest) + 0.5));
    }
  }
  return not_a_number;
}

long long convert(const char* raw, const VolumeHeader& header, std::vector<std::int16_t>& hu) {
  switch (header.type) {
    case VoxelType::int8:
      return to_hu<std::int8_t>(raw, header, hu);
    case VoxelType::uint8:
      return to_hu<std::uint8_t>(raw, header, hu);
    case VoxelType::int16:
      return to_hu<std::int16_t>(raw, header, hu);
    case VoxelType::uint16:
      return to_hu<std::uint16_t>(raw, header, hu);
    case VoxelType::int32:
      return to_hu<std::int32_t>(raw, header, hu);
    case VoxelType::uint32:
      return to_hu<std::uint32_t>(raw, header, hu);
    case VoxelType::float32:
      return to_hu<float>(raw, header, hu);
    case VoxelType::float64:
      break;
  }
  return to_hu<double>(raw, header, hu);
}

/// The voxels in HU; `bytes` is the header's own file, unpacked already when it was packed whole.
std::vector<std::int16_t> voxels(const std::string& bytes, const VolumeHeader& header,
                                 const fs::path& path, Progress& progress) {
  const fs::path data_path = header.data_file.empty() ? path : header.data_file;
  std::string other;
  if (!header.data_file.empty()) other = file_bytes(data_path);
  const std::string* data = header.data_file.empty() ? &bytes : &other;

  const std::size_t count =
      static_cast<std::size_t>(header.dims.x()) * header.dims.y() * header.dims.z();
  const std::size_t needed = count * static_cast<std::size_t>(byte_size(header.type));
  std::size_t offset = static_cast<std::size_t>(std::max(0LL, header.data_offset));
  if (header.data_offset < 0 && data->size() >= needed) offset = data->size() - needed;
  std::string unpacked;
  if (header.compressed) {
    unpacked = inflated(*data, std::min(offset, data->size()), needed, data_path);
    data = &unpacked;
    offset = 0;
  }
  const std::size_t there = data->size() - std::min(offset, data->size());
  if (there < needed) {
    refuse(data_path,
           "is cut short: it holds " + std::to_string(there) + " of " + std::to_string(needed) +
               " bytes of voxels",
           "copy the file again");
  }
  std::vector<std::int16_t> hu(count);
  const long long not_a_number = convert(data->data() + offset, header, hu);
  if (not_a_number > 0) {
    progress.notice(data_path.string() + ": " + std::to_string(not_a_number) +
                    " voxels are not a number and count as air");
  }
  return hu;
}

/// A head in mm, in HU. The unit is not guessed: what cannot be right is refused.
void check_plausible(const CtVolume& volume, const fs::path& path) {
  const double extent =
      (volume.steps().array() * (volume.dims().array() - 1).cast<double>()).maxCoeff();
  if (extent < 30 || extent > 3000) {
    refuse(path,
           "spans " + std::to_string(extent) + " mm, so its voxel size is not in mm or is missing",
           "write the file with its voxel size in mm");
  }
  if (*std::min_element(volume.hu().begin(), volume.hu().end()) >= -500) {
    refuse(path, "holds no air (no value below -500), so its values are not Hounsfield units",
           "write the CT in HU, air at -1000 and water at 0");
  }
}

bool ends_with(std::string name, const std::string& ending) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.ends_with(ending);
}

}  // namespace

CtVolume read_volume_file(const fs::path& path, Progress& progress) {
  const auto stage = progress.stage("read volume file");
  const std::string name = path.filename().string();
  const bool meta = ends_with(name, ".mha") || ends_with(name, ".mhd");
  const bool nrrd = ends_with(name, ".nrrd") || ends_with(name, ".nhdr");
  const bool packed = ends_with(name, ".nii.gz");
  if (!meta && !nrrd && !packed && !ends_with(name, ".nii")) {
    refuse(path, "has no known volume format",
           "give .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz, or the folder of a DICOM series");
  }
  std::string bytes = file_bytes(path);
  VolumeHeader header;
  if (meta || nrrd) {
    header = meta ? parse_meta_image(bytes, path, progress) : parse_nrrd(bytes, path, progress);
  } else {
    header = parse_nifti(packed ? inflated(bytes, 0, 348, path) : bytes, path, progress);
    header.compressed = false;
    if (packed) {
      const std::size_t all = static_cast<std::size_t>(header.data_offset) +
                              static_cast<std::size_t>(header.dims.x()) * header.dims.y() *
                                  header.dims.z() *
                                  static_cast<std::size_t>(byte_size(header.type));
      bytes = inflated(bytes, 0, all, path);
    }
  }
  CtVolume volume(header.dims, voxels(bytes, header, path, progress), header.lps_from_ijk,
                  path.string());
  check_plausible(volume, path);
  return volume;
}

}  // namespace gnathion
