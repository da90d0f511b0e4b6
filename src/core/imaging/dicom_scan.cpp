#include "imaging/dicom_scan.h"

#include <vtkDICOMDictionary.h>
#include <vtkDICOMMetaData.h>
#include <vtkDICOMParser.h>
#include <vtkDICOMUtilities.h>
#include <vtkDICOMValue.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <system_error>

#include "base/error.h"
#include "imaging/vtk_errors.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_below(const fs::path& folder) {
  std::error_code failed;
  if (!fs::exists(folder, failed)) {
    throw Error(ErrorKind::input, folder.string(), "does not exist",
                "give the folder that holds the DICOM files");
  }
  if (!fs::is_directory(folder, failed)) {
    throw Error(ErrorKind::input, folder.string(), "is no folder",
                "give the folder that holds the DICOM files");
  }
  std::vector<fs::path> files;
  fs::recursive_directory_iterator it(folder, failed);
  for (; !failed && it != fs::recursive_directory_iterator(); it.increment(failed)) {
    std::error_code ignored;
    if (it->is_regular_file(ignored)) files.push_back(it->path());
  }
  if (failed) {
    throw Error(ErrorKind::input, folder.string(), "cannot be listed: " + failed.message(),
                "check the folder's permissions");
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool has_dicom_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".dcm" || extension == ".dicom" || extension == ".ima";
}

bool is_native_syntax(const std::string& uid) {
  return uid.empty() || uid == "1.2.840.10008.1.2" || uid == "1.2.840.10008.1.2.1" ||
         uid == "1.2.840.10008.1.2.2";
}

bool read_numbers(vtkDICOMMetaData* data, vtkDICOMTag tag, double* out, std::size_t count) {
  const vtkDICOMValue& value = data->Get(tag);
  if (!value.IsValid() || value.GetNumberOfValues() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = value.GetDouble(i);
    if (!std::isfinite(out[i])) return false;
  }
  return true;
}

void read_geometry(vtkDICOMMetaData* data, DicomHeader& header) {
  double orientation[6] = {};
  double row_column[2] = {};
  header.has_position = read_numbers(data, DC::ImagePositionPatient, header.position.data(), 3) &&
                        read_numbers(data, DC::ImageOrientationPatient, orientation, 6);
  const Eigen::Vector3d row(orientation[0], orientation[1], orientation[2]);
  const Eigen::Vector3d column(orientation[3], orientation[4], orientation[5]);
  // Written with few digits, the axes are unit and orthogonal to about 1e-3 only.
  if (std::abs(row.norm() - 1) > 1e-2 || std::abs(column.norm() - 1) > 1e-2 ||
      std::abs(row.dot(column)) > 1e-2) {
    header.has_position = false;
  }
  if (header.has_position) {
    header.along_row = row.normalized();
    header.along_column = (column - column.dot(header.along_row) * header.along_row).normalized();
  }
  // PixelSpacing is (between rows, between columns): the second is the step along a row.
  header.has_spacing =
      read_numbers(data, DC::PixelSpacing, row_column, 2) && row_column[0] > 0 && row_column[1] > 0;
  header.spacing = Eigen::Vector2d(row_column[1], row_column[0]);
  header.has_rescale = read_numbers(data, DC::RescaleSlope, &header.slope, 1) &&
                       read_numbers(data, DC::RescaleIntercept, &header.intercept, 1);
}

DicomHeader header_of(vtkDICOMMetaData* data, const fs::path& path) {
  DicomHeader header;
  header.path = path;
  header.series_uid = data->Get(DC::SeriesInstanceUID).AsString();
  header.modality = data->Get(DC::Modality).AsString();
  header.description = data->Get(DC::SeriesDescription).AsUTF8String();
  header.columns = data->Get(DC::Columns).AsInt();
  header.rows = data->Get(DC::Rows).AsInt();
  header.samples_per_pixel = data->Get(DC::SamplesPerPixel).AsInt();
  header.bits_allocated = data->Get(DC::BitsAllocated).AsInt();
  header.is_signed = data->Get(DC::PixelRepresentation).AsInt() != 0;
  if (data->Has(DC::NumberOfFrames)) header.frames = data->Get(DC::NumberOfFrames).AsInt();
  read_geometry(data, header);
  return header;
}

/// What is wrong with the file's pixels, as far as that shows without decoding them.
std::string pixel_problem(const DicomHeader& header, vtkDICOMParser* parser,
                          const std::string& transfer_syntax) {
  if (header.columns <= 0 || header.rows <= 0) return {};  // a report, a plan: no image
  if (!parser->GetPixelDataFound()) return "ends before its pixels";
  if (!is_native_syntax(transfer_syntax)) return {};
  const long long needed = static_cast<long long>(header.columns) * header.rows *
                           std::max(header.samples_per_pixel, 1) * std::max(header.frames, 1) *
                           (header.bits_allocated / 8);
  const long long there = parser->GetFileSize() - parser->GetFileOffset();
  if (there >= needed) return {};
  return "is cut short: it holds " + std::to_string(std::max(there, 0LL)) + " of " +
         std::to_string(needed) + " bytes of pixels";
}

void scan_file(const fs::path& path, DicomScan& scan) {
  const std::string name = path.string();
  if (path.filename() == "DICOMDIR") return;
  if (!vtkDICOMUtilities::IsDICOMFile(name.c_str())) {
    if (has_dicom_extension(path)) scan.unreadable.push_back({path, "is no DICOM file inside"});
    return;
  }
  vtkNew<vtkDICOMMetaData> data;
  vtkNew<vtkDICOMParser> parser;
  const VtkErrors errors(parser);
  parser->SetMetaData(data);
  parser->SetFileName(name.c_str());
  parser->Update();
  if (parser->GetErrorCode() != vtkErrorCode::NoError || !errors.text().empty()) {
    scan.unreadable.push_back({path, "cannot be read as DICOM (" + errors.text() + ")"});
    return;
  }
  DicomHeader header = header_of(data, path);
  const std::string problem =
      header.series_uid.empty()
          ? "has no SeriesInstanceUID"
          : pixel_problem(header, parser, data->Get(DC::TransferSyntaxUID).AsString());
  if (problem.empty()) {
    scan.headers.push_back(std::move(header));
  } else {
    scan.unreadable.push_back({path, problem});
  }
}

}  // namespace

DicomScan scan_folder(const fs::path& folder, Progress& progress) {
  DicomScan scan;
  for (const fs::path& path : files_below(folder)) {
    progress.check();
    scan_file(path, scan);
  }
  return scan;
}

}  // namespace gnathion
