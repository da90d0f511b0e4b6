#include "io/input_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <string>

#include "base/error.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

constexpr std::array volume_endings{".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".nii.gz"};
constexpr std::array dicom_endings{".dcm", ".ima", "dicomdir"};

std::string listed(std::span<const char* const> endings) {
  std::string text;
  for (const char* ending : endings) text += (text.empty() ? "" : ", ") + std::string(ending);
  return text;
}

bool ends_with_any(const std::string& name, std::span<const char* const> endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [&name](const char* ending) { return name.ends_with(ending); });
}

std::string lower_name(const fs::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return name;
}

}  // namespace

bool is_scan_name(const fs::path& path) {
  return ends_with_any(lower_name(path), scan_endings);
}

InputKind input_kind(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) {
    throw Error(ErrorKind::input, path.string(), "does not exist or cannot be reached",
                "check the name, its rights, and that its disk is connected");
  }
  if (fs::is_directory(status)) return InputKind::dicom_folder;
  const std::string name = lower_name(path);
  if (name.ends_with(".json")) return InputKind::case_file;
  if (is_scan_name(path)) return InputKind::photograph;
  if (ends_with_any(name, volume_endings)) return InputKind::volume;
  if (ends_with_any(name, dicom_endings)) {
    throw Error(ErrorKind::input, path.string(), "is one file of a DICOM series",
                "give the folder that holds the series");
  }
  throw Error(ErrorKind::input, path.string(), "is nothing that Gnathion can open",
              "give a folder with DICOM files, a volume (" + listed(volume_endings) +
                  "), a photograph (" + listed(scan_endings) + ") or a case (.json)");
}

}  // namespace gnathion
