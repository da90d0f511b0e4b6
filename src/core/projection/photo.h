#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gnathion {

/// The pixels of an ordinary photograph, upright, without what its file says beside them (camera,
/// place, names).
struct Photo {
  int width = 0;                  ///< pixels
  int height = 0;                 ///< pixels
  std::vector<std::uint8_t> rgb;  ///< 3 · width · height, rows from the top
};

/// Reads a JPEG, PNG, TIFF, BMP or WebP. An EXIF orientation is applied, so that the pixels are
/// those that an image viewer shows. Deeper colours become 8 bits a channel, grey becomes RGB.
/// Throws Error(input) naming the file: missing, no picture, damaged, smaller than 64 x 64 pixels,
/// or larger than check_picture_size() allows.
Photo read_photo(const std::filesystem::path& file);

/// The picture as PNG, without loss and without anything else. photo: not empty.
std::string png_of(const Photo& photo);

}  // namespace gnathion
