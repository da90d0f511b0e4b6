#pragma once

#include <array>
#include <filesystem>

namespace gnathion {

/// What a file or folder that a user gives is good for.
enum class InputKind {
  dicom_folder,  ///< a folder: its DICOM series are to be listed
  volume,        ///< .mha, .mhd, .nrrd, .nhdr, .nii, .nii.gz
  photograph,    ///< a face scan: is_scan_name()
  case_file,     ///< .json
};

/// What the names of face scans end in: every format that read_scan() reads (scan/scan_import.h).
inline constexpr std::array scan_endings{".obj", ".ply", ".stl", ".glb", ".gltf",
                                         ".3ds", ".fbx", ".dae", ".off", ".3mf"};

/// Whether the name ends like a face scan's, capitals or not.
bool is_scan_name(const std::filesystem::path& path);

/// By its name, capitals or not; nothing is read.
/// Throws Error(input) when it does not exist, and for any other name with what would do instead.
InputKind input_kind(const std::filesystem::path& path);

}  // namespace gnathion
