#pragma once

#include <filesystem>
#include <string>

namespace gnathion {

/// The whole file. Throws Error(input) when it is missing, unreadable, empty or above 2 GiB.
std::string read_text_file(const std::filesystem::path& path);

/// Throws Error(output) when not every byte can be written.
void write_text_file(const std::filesystem::path& path, const std::string& text);

/// The same, but the file changes whole or not at all: the text goes into a hidden file beside it,
/// onto the disk, and takes the old file's place and rights. A crash or a full disk leaves the old
/// file as it was. Of a link, the file that it points to is replaced. Throws Error(output).
void replace_text_file(const std::filesystem::path& path, const std::string& text);

/// Hex SHA-256 of a file; of a folder, that of the sorted list of its files' hashes and relative
/// names. Throws Error(input).
std::string sha256_of(const std::filesystem::path& path);

/// A folder that appears whole or not at all: work goes into a hidden folder beside it, which
/// publish() renames. Without publish() everything is removed again.
class NewFolder {
 public:
  /// Throws Error(output) when `target` exists already, or its parent is missing or not writable.
  explicit NewFolder(const std::filesystem::path& target);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// Where to write meanwhile.
  const std::filesystem::path& path() const { return partial_; }
  /// Throws Error(output) when the target has come into being meanwhile.
  void publish();

 private:
  std::filesystem::path target_;
  std::filesystem::path partial_;
  bool published_ = false;
};

}  // namespace gnathion
