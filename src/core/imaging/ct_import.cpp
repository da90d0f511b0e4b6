#include "imaging/ct_import.h"

#include "base/error.h"
#include "imaging/dicom_series.h"
#include "imaging/volume_file.h"

namespace gnathion {

CtVolume read_ct(const std::filesystem::path& path, const std::optional<std::string>& uid,
                 Progress& progress) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw Error(ErrorKind::input, path.string(), "does not exist",
                "give a folder with a DICOM series, or a .mha, .mhd, .nrrd, .nii or .nii.gz file");
  }
  if (std::filesystem::is_directory(path, ignored)) return read_series(path, uid, progress);
  if (uid) {
    throw Error(ErrorKind::input, path.string(), "is a file, and a series UID was given",
                "leave the UID out, or give the folder of the DICOM series");
  }
  return read_volume_file(path, progress);
}

}  // namespace gnathion
