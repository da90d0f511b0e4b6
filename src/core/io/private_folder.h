#pragma once

#include <filesystem>

namespace gnathion {

/// A new folder that only this user can look into, gone with the object: pictures of a patient do
/// not stay behind. In the user's runtime folder (in memory, emptied at logout) where there is one,
/// else among the temporary files.
class PrivateFolder {
 public:
  /// Throws Error(output) when none can be made.
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace gnathion
