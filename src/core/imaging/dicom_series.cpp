#include "imaging/dicom_series.h"

#include <vtkDICOMReader.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "imaging/dicom_scan.h"
#include "imaging/vtk_errors.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

std::string number(double value) {
  std::ostringstream out;
  out.precision(6);
  out << value;
  return out.str();
}

std::string name_of(const DicomHeader& header) {
  return header.path.filename().string();
}

[[noreturn]] void refuse(const fs::path& subject, const std::string& problem,
                         const std::string& remedy) {
  throw Error(ErrorKind::input, subject.string(), problem, remedy);
}

std::vector<SeriesSummary> summaries(const DicomScan& scan) {
  std::map<std::string, SeriesSummary> by_uid;
  for (const DicomHeader& header : scan.headers) {
    SeriesSummary& series = by_uid[header.series_uid];
    if (series.slices++ > 0) continue;
    series.uid = header.series_uid;
    series.modality = header.modality;
    series.description = header.description;
    series.size = Eigen::Vector2i(header.columns, header.rows);
    series.pixel_spacing = header.spacing;
  }
  std::vector<SeriesSummary> list;
  for (auto& [uid, series] : by_uid) list.push_back(std::move(series));
  return list;
}

std::string listing(const std::vector<SeriesSummary>& list) {
  std::string text;
  for (const SeriesSummary& series : list) {
    if (!text.empty()) text += ", ";
    text += series.uid + " (" + series.modality + ", \"" + series.description + "\", " +
            std::to_string(series.slices) + " files)";
  }
  return text;
}

std::string chosen_uid(const fs::path& folder, const DicomScan& scan,
                       const std::optional<std::string>& uid) {
  const std::vector<SeriesSummary> all = summaries(scan);
  if (uid) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.uid == *uid; });
    if (found == all.end()) {
      refuse(folder, "holds no series " + *uid, "choose one of: " + listing(all));
    }
    if (found->modality != "CT") {
      refuse(folder, "series " + *uid + " is no CT, its modality is " + found->modality,
             "choose a series of modality CT from: " + listing(all));
    }
    return *uid;
  }
  std::vector<SeriesSummary> ct;
  std::copy_if(all.begin(), all.end(), std::back_inserter(ct),
               [](const auto& s) { return s.modality == "CT"; });
  if (ct.empty()) {
    const std::string what = all.empty() ? "no DICOM file in it" : "only " + listing(all);
    refuse(folder, "holds no CT: " + what, "give the folder of a CT series");
  }
  if (ct.size() > 1) {
    refuse(folder, "holds " + std::to_string(ct.size()) + " CT series",
           "choose one by its UID: " + listing(ct));
  }
  return ct.front().uid;
}

/// Everything that every slice must have, and have in common with the first.
void check_slices(const std::vector<DicomHeader>& slices) {
  const DicomHeader& first = slices.front();
  for (const DicomHeader& slice : slices) {
    if (slice.frames != 1) {
      refuse(slice.path, "is a multi-frame file of " + std::to_string(slice.frames) + " frames",
             "export the series as one file a slice (classic CT Image Storage)");
    }
    if (slice.samples_per_pixel != 1) {
      refuse(slice.path, "is a colour picture, no CT slice",
             "take it out of the folder, or choose another series");
    }
    if (!slice.has_position || !slice.has_spacing) {
      refuse(slice.path,
             std::string("has no valid ") +
                 (slice.has_position ? "PixelSpacing"
                                     : "ImagePositionPatient and ImageOrientationPatient"),
             "export the series again, with its geometry");
    }
    if (!slice.has_rescale) {
      refuse(slice.path, "has no RescaleSlope and RescaleIntercept, so its values are not HU",
             "export the series again as CT Image Storage");
    }
    if (slice.columns != first.columns || slice.rows != first.rows ||
        slice.bits_allocated != first.bits_allocated || slice.is_signed != first.is_signed ||
        (slice.spacing - first.spacing).norm() > 1e-4) {
      refuse(slice.path, "differs in size, pixel spacing or number format from " + name_of(first),
             "keep one reconstruction of one series in the folder");
    }
    // 1e-3 rad: over a 500 mm field of view half a millimetre.
    if ((slice.along_row - first.along_row).norm() > 1e-3 ||
        (slice.along_column - first.along_column).norm() > 1e-3) {
      refuse(slice.path, "is turned against " + name_of(first) + " of the same series",
             "take localizers and reformatted slices out of the folder");
    }
  }
}

Eigen::Vector3d normal_of(const DicomHeader& slice) {
  return slice.along_row.cross(slice.along_column).normalized();
}

template <typename Stored>
void rescale(const Stored* stored, const std::vector<DicomHeader>& slices, std::int16_t* hu) {
  const std::size_t size = static_cast<std::size_t>(slices[0].columns) * slices[0].rows;
  constexpr double lowest = std::numeric_limits<std::int16_t>::min();
  constexpr double highest = std::numeric_limits<std::int16_t>::max();
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const double slope = slices[k].slope;
    const double intercept = slices[k].intercept;
    const Stored* in = stored + k * size;
    std::int16_t* out = hu + k * size;
    for (std::size_t i = 0; i < size; ++i) {
      const double value = slope * static_cast<double>(in[i]) + intercept;
      out[i] = static_cast<std::int16_t>(std::floor(std::clamp(value, lowest, highest) + 0.5));
    }
  }
}

/// Empty when the files were read, otherwise what went wrong.
std::string try_reading(const std::vector<DicomHeader>& slices, vtkDICOMReader* reader) {
  const VtkErrors errors(reader);
  vtkNew<vtkStringArray> names;
  for (const DicomHeader& slice : slices) names->InsertNextValue(slice.path.string());
  reader->SetFileNames(names);
  reader->SetSorting(0);  // the slices are sorted already, by position
  reader->AutoRescaleOff();
  reader->SetMemoryRowOrderToFileNative();
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError || !errors.text().empty()) {
    return errors.text().empty() ? vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode())
                                 : errors.text();
  }
  int dims[3] = {};
  reader->GetOutput()->GetDimensions(dims);
  const bool complete = dims[0] == slices[0].columns && dims[1] == slices[0].rows &&
                        dims[2] == static_cast<int>(slices.size()) &&
                        reader->GetOutput()->GetNumberOfScalarComponents() == 1;
  return complete ? "" : "the pixels do not make a volume of the stated size";
}

/// Rounded HU of the files in their order, rows in the order of the file.
std::vector<std::int16_t> read_hu(const std::vector<DicomHeader>& slices) {
  vtkNew<vtkDICOMReader> reader;
  const std::string problem = try_reading(slices, reader);
  if (!problem.empty()) {
    // Read one by one to name the file.
    for (const DicomHeader& slice : slices) {
      vtkNew<vtkDICOMReader> single;
      const std::string own = try_reading({slice}, single);
      if (!own.empty()) refuse(slice.path, "cannot be decoded (" + own + ")", "copy it again");
    }
    refuse(slices[0].path.parent_path(), "cannot be read (" + problem + ")", "copy it again");
  }
  vtkImageData* image = reader->GetOutput();
  std::vector<std::int16_t> hu(static_cast<std::size_t>(image->GetNumberOfPoints()));
  switch (image->GetScalarType()) {
    vtkTemplateMacro(
        rescale(static_cast<const VTK_TT*>(image->GetScalarPointer()), slices, hu.data()));
    default:
      refuse(slices[0].path, "has an unknown pixel type", "export the series again");
  }
  return hu;
}

void sort_by_position(std::vector<DicomHeader>& slices) {
  const Eigen::Vector3d normal = normal_of(slices.front());
  std::stable_sort(slices.begin(), slices.end(), [&](const auto& a, const auto& b) {
    return normal.dot(a.position) < normal.dot(b.position);
  });
}

/// Drops files that repeat a slice exactly; refuses different slices at one place.
void drop_copies(std::vector<DicomHeader>& slices, Progress& progress) {
  const Eigen::Vector3d normal = normal_of(slices.front());
  std::vector<DicomHeader> kept;
  int copies = 0;
  for (DicomHeader& slice : slices) {
    if (kept.empty() || normal.dot(slice.position - kept.back().position) > 1e-3) {
      kept.push_back(std::move(slice));
      continue;
    }
    const bool same_place = (slice.position - kept.back().position).norm() < 1e-3;
    if (!same_place || read_hu({slice}) != read_hu({kept.back()})) {
      refuse(slice.path,
             "lies in the same plane as " + name_of(kept.back()) + " and is not the same (at " +
                 number(normal.dot(slice.position)) + " mm along the normal)",
             "keep one reconstruction of one series in the folder");
    }
    ++copies;
  }
  if (copies > 0) {
    progress.notice(std::to_string(copies) + " files repeat a slice exactly and were left out");
  }
  slices = std::move(kept);
}

std::string place_text(const Eigen::Vector3d& p) {
  return "(" + number(p.x()) + ", " + number(p.y()) + ", " + number(p.z()) + ") mm";
}

/// The step from slice to slice (LPS mm); refuses gaps and uneven steps.
Eigen::Vector3d slice_step(const std::vector<DicomHeader>& slices) {
  const Eigen::Vector3d normal = normal_of(slices.front());
  std::vector<double> steps;
  for (std::size_t k = 1; k < slices.size(); ++k) {
    steps.push_back(normal.dot(slices[k].position - slices[k - 1].position));
  }
  std::vector<double> sorted = steps;
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted[(sorted.size() - 1) / 2];
  // Positions are often written with one decimal: 0.625 becomes 0.6, 0.7, 0.6…
  const double tolerance = std::max(0.11, 0.1 * usual);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (std::abs(steps[k] - usual) <= std::min(tolerance, 0.4 * usual)) continue;
    const DicomHeader& before = slices[k];
    const DicomHeader& after = slices[k + 1];
    const double count = std::round(steps[k] / usual);
    const std::string between = "between " + name_of(before) + " and " + name_of(after);
    if (count >= 2 && std::abs(steps[k] - count * usual) <= 0.1 * usual * count) {
      const Eigen::Vector3d place = before.position + (after.position - before.position) / count;
      refuse(before.path.parent_path(),
             "lacks " + number(count - 1) + " slice(s) " + between + ": the gap is " +
                 number(steps[k]) + " mm where the step is " + number(usual) +
                 " mm; the (first) missing ImagePositionPatient is " + place_text(place),
             "copy or export the whole series again");
    }
    refuse(before.path.parent_path(),
           "has uneven steps: " + number(steps[k]) + " mm " + between + ", elsewhere " +
               number(usual) + " mm",
           "export the series again with even steps");
  }
  return (slices.back().position - slices.front().position) /
         static_cast<double>(slices.size() - 1);
}

/// Each slice must lie where the even steps put it; small scatter is rounding and is reported.
void check_line(const std::vector<DicomHeader>& slices, const Eigen::Vector3d& step,
                Progress& progress) {
  double worst = 0;
  std::size_t where = 0;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const Eigen::Vector3d expected = slices[0].position + static_cast<double>(k) * step;
    const double off = (slices[k].position - expected).norm();
    if (off > worst) {
      worst = off;
      where = k;
    }
  }
  if (worst > std::max(0.11, 0.1 * step.norm())) {
    refuse(slices[where].path, "lies " + number(worst) + " mm beside the line of the other slices",
           "export the series again with even steps");
  }
  if (worst > 0.02) {
    progress.notice("slice positions scatter by up to " + number(worst) +
                    " mm about even steps; even steps are used");
  }
}

void report_tilt(const DicomHeader& slice, const Eigen::Vector3d& step, Progress& progress) {
  const Eigen::Vector3d normal = normal_of(slice);
  const double angle =
      std::atan2(step.cross(normal).norm(), step.dot(normal)) * 180 / std::numbers::pi;
  if (angle < 0.05) return;
  progress.notice("the gantry is tilted by " + number(std::round(angle * 100) / 100) +
                  " degrees; the slices keep their true places, nothing is resampled");
}

/// The chosen series' slices, checked one against the other and sorted along their normal.
std::vector<DicomHeader> slices_of(const fs::path& folder, const std::optional<std::string>& uid,
                                   Progress& progress) {
  DicomScan scan = scan_folder(folder, progress);
  if (!scan.unreadable.empty()) {
    const UnreadableFile& broken = scan.unreadable.front();
    const std::size_t others = scan.unreadable.size() - 1;
    refuse(broken.path,
           broken.problem + (others ? " (and " + std::to_string(others) + " more like it)" : ""),
           "copy it again, or take it out of the folder if it is not part of the series");
  }
  const std::string chosen = chosen_uid(folder, scan, uid);
  std::vector<DicomHeader> slices;
  for (DicomHeader& header : scan.headers) {
    if (header.series_uid == chosen) slices.push_back(std::move(header));
  }
  check_slices(slices);
  sort_by_position(slices);
  drop_copies(slices, progress);
  if (slices.size() < 2) {
    refuse(slices.front().path, "is the only slice of its series", "give the whole series");
  }
  return slices;
}

}  // namespace

std::vector<SeriesSummary> list_series(const fs::path& folder, Progress& progress) {
  const DicomScan scan = scan_folder(folder, progress);
  for (const UnreadableFile& broken : scan.unreadable) {
    progress.notice(broken.path.string() + ": " + broken.problem);
  }
  if (scan.headers.empty()) {
    refuse(folder, "holds no readable DICOM file", "give the folder that holds the DICOM files");
  }
  return summaries(scan);
}

CtVolume read_series(const fs::path& folder, const std::optional<std::string>& uid,
                     Progress& progress) {
  const auto stage = progress.stage("read DICOM series");
  const std::vector<DicomHeader> slices = slices_of(folder, uid, progress);
  const Eigen::Vector3d step = slice_step(slices);
  check_line(slices, step, progress);
  const DicomHeader& first = slices.front();
  report_tilt(first, step, progress);

  Eigen::Matrix4d lps_from_ijk = Eigen::Matrix4d::Identity();
  lps_from_ijk.col(0).head<3>() = first.along_row * first.spacing.x();
  lps_from_ijk.col(1).head<3>() = first.along_column * first.spacing.y();
  lps_from_ijk.col(2).head<3>() = step;
  lps_from_ijk.col(3).head<3>() = first.position;
  return CtVolume({first.columns, first.rows, static_cast<int>(slices.size())}, read_hu(slices),
                  lps_from_ijk, folder.string());
}

}  // namespace gnathion
