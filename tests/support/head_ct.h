#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace gnathion::test {

/// The folder with the DICOM files of the real CT, unpacked for this process; empty when the shared
/// data are not there.
inline std::filesystem::path head_ct_folder() {
  namespace fs = std::filesystem;
  const fs::path archive =
      fs::path(GNATHION_SHARED_DATA) / "ct-head-phantom" / "dicom_head_135slices.tar.xz";
  std::error_code ignored;
  if (!fs::exists(archive, ignored)) return {};
  struct Unpacked {
    fs::path folder;
    explicit Unpacked(const fs::path& from) {
      std::string name = (fs::temp_directory_path() / "gnathion-head-ct-XXXXXX").string();
      if (!mkdtemp(name.data())) return;
      folder = name;
      const std::string command = "tar -xJf '" + from.string() + "' -C '" + folder.string() + "'";
      if (std::system(command.c_str()) != 0) ADD_FAILURE() << "failed: " << command;
    }
    ~Unpacked() {
      std::error_code failed;
      if (!folder.empty()) fs::remove_all(folder, failed);
    }
    Unpacked(const Unpacked&) = delete;
    Unpacked& operator=(const Unpacked&) = delete;
  };
  static const Unpacked unpacked(archive);
  return unpacked.folder / "phead";
}

}  // namespace gnathion::test
