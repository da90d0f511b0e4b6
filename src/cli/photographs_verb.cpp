#include <iomanip>

#include "base/error.h"
#include "cli/verbs.h"
#include "imaging/ct_import.h"
#include "io/case_file.h"
#include "io/files.h"
#include "projection/photo_marks.h"
#include "projection/projection.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

/// PICTURE=LANDMARKS at the last equals sign that leaves an existing picture.
std::pair<fs::path, fs::path> parts_of(const std::string& photo) {
  const std::size_t sign = photo.rfind('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == photo.size()) {
    throw Error(ErrorKind::usage, "--photo " + photo, "names no landmarks",
                "write --photo PICTURE=LANDMARKS.json");
  }
  return {photo.substr(0, sign), photo.substr(sign + 1)};
}

std::vector<MarkedPhoto> read_photos(const SurgicalCase& plan, const PhotographsChoices& choices) {
  std::map<std::string, Eigen::Vector3d> on_skin = plan.landmarks;
  if (choices.landmarks) {
    for (const auto& [name, place] : read_skin_landmarks(*choices.landmarks)) on_skin[name] = place;
  }
  std::vector<MarkedPhoto> photos;
  for (const std::string& photo : choices.photos) {
    const auto [picture, marks_file] = parts_of(photo);
    const PhotoMarks marks = read_photo_marks(marks_file);
    photos.push_back({picture.filename().string(),
                      std::make_shared<const Photo>(read_photo(picture)),
                      paired(marks, on_skin, marks_file.string()), marks.camera});
  }
  return photos;
}

void print(const ProjectedPhotographs& projected, std::ostream& out) {
  const PaintedSkin& painted = projected.painted;
  out << std::fixed;
  for (std::size_t i = 0; i < painted.photos.size(); ++i) {
    const CameraFit& fit = projected.cameras[i];
    const PhotoShare& share = painted.photos[i];
    out << share.name << ": landmarks " << std::setprecision(1) << fit.rms_pixels << " pixels, "
        << std::setprecision(2) << fit.rms_mm << " mm RMS; its place on the skin is sure to "
        << fit.uncertainty_mm << " mm; lens like " << std::setprecision(0) << fit.focal_35mm
        << " mm on 35 mm film\n"
        << "  shows " << share.seen_cm2 << " cm2 of the skin; colours times "
        << std::setprecision(2) << share.gain[0] << ", " << share.gain[1] << ", " << share.gain[2]
        << '\n';
    for (const auto& [name, residual] : fit.residuals) {
      out << "  " << std::left << std::setw(22) << name << std::right << std::setw(7)
          << std::setprecision(1) << residual.pixels << " pixels" << std::setw(8)
          << std::setprecision(2) << residual.mm << " mm\n";
    }
  }
  out << std::setprecision(0) << "of " << painted.skin_cm2 << " cm2 of skin " << painted.seen_cm2
      << " are seen, " << painted.inpainted_cm2 << " made up beside them, the rest is plain\n"
      << "picture: " << painted.charts.width << " x " << painted.charts.height << " pixels of "
      << std::setprecision(2) << painted.charts.mm_per_pixel << " mm\n";
}

}  // namespace

void photographs_verb(const fs::path& case_file, const fs::path& target,
                      const PhotographsChoices& choices, std::ostream& out, Progress& progress) {
  SurgicalCase plan = read_case_file(case_file);
  NewFolder folder(target);
  const std::vector<MarkedPhoto> photos = read_photos(plan, choices);
  const CtVolume ct = read_ct(plan.ct.path, plan.ct.series_uid, progress);
  const SkinSight skin(skin_surface(ct, plan.skin, progress));
  PaintOptions options;
  options.mm_per_pixel = choices.mm_per_pixel;
  if (choices.inpaint_mm) options.inpaint_mm = *choices.inpaint_mm;
  const ProjectedPhotographs projected = project_photographs(photos, skin, options, progress);
  print(projected, out);
  write_projection(projected, skin.mesh(), folder.path());
  if (plan.photograph && !plan.region.vertices.empty()) {
    progress.notice("the region's vertices were those of another photograph: left out");
  }
  plan = with_projection(std::move(plan), folder.path());
  plan.ct.path = fs::absolute(plan.ct.path);
  write_case_file(plan, folder.path() / "case.json");
  folder.publish();
  out << "wrote\n";
  for (const char* name :
       {"case.json", "photograph.mtl", "photograph.obj", "photograph.png", "projection.json"}) {
    out << "  " << (target / name).string() << '\n';
  }
}

}  // namespace gnathion
