#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace gnathion {

struct PictureSize {
  std::uint64_t width = 0, height = 0;  ///< pixels
};

/// What a PNG, JPEG, BMP or TIFF says of its size, without decoding it. None when that cannot be
/// found; whether it is a picture at all shows when it is decoded.
std::optional<PictureSize> picture_size(const std::filesystem::path& file);

/// Throws Error(input) naming the picture when it says that it has more than 20 000 x 20 000
/// pixels: a small file can claim a size that fills the memory.
void check_picture_size(const std::filesystem::path& file);

}  // namespace gnathion
