#pragma once

#include <filesystem>
#include <memory>

#include "render/picture.h"

namespace gnathion {

/// A film as an AVI file of JPEG pictures (Motion JPEG), which common players open. The file
/// appears when it is finished; without finish() nothing is left of it.
class MovieFile {
 public:
  /// width, height: pixels of every picture. Throws Error(output) when the folder is missing or
  /// cannot be written.
  MovieFile(const std::filesystem::path& path, int width, int height, int frames_per_second);
  ~MovieFile();
  MovieFile(const MovieFile&) = delete;
  MovieFile& operator=(const MovieFile&) = delete;

  /// The next picture. Throws Error(output) when it cannot be written, and when the file would
  /// exceed the 2 GB that every player reads; std::invalid_argument when its size is another.
  void add(const Picture& picture);
  /// The file, in place of one that has its name. Throws Error(output).
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
