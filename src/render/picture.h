#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace gnathion {

/// 8-bit RGB pixels, rows from the top, no padding.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 · width · height

  /// The three bytes of a pixel; (0, 0) is the upper left one.
  const std::uint8_t* at(int x, int y) const {
    return &rgb[static_cast<size_t>(3 * (y * width + x))];
  }
  bool operator==(const Picture&) const = default;
};

/// Throws Error(output) naming the file when it cannot be written.
void write_png(const Picture& picture, const std::filesystem::path& path);

/// Throws Error(input) naming the file when it is missing or no picture.
Picture read_picture_file(const std::filesystem::path& path);

/// Rows of equally large pictures, `gap` white pixels apart.
/// Throws std::invalid_argument when sizes or row lengths differ.
Picture tiled(const std::vector<std::vector<Picture>>& rows, int gap = 2);

}  // namespace gnathion
