#include "projection/projection.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/files.h"
#include "io/obj_document.h"

namespace gnathion {
namespace {

using nlohmann::json;

constexpr const char* kName = "photograph.obj";

CameraFit fitted(const MarkedPhoto& photo, const SkinSight& skin) {
  try {
    return fit_camera(photo.landmarks, photo.photo->width, photo.photo->height, skin, photo.camera);
  } catch (const Error& error) {
    throw Error(error.kind(), photo.name + ", " + error.subject(), error.problem(), error.remedy());
  }
}

json to_json(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

json to_json(const CameraFit& fit) {
  const RigidMotion& pose = fit.camera.camera_from_lps;
  json landmarks = json::object(), rotation = json::array();
  for (const auto& [name, residual] : fit.residuals) {
    landmarks[name] = {{"pixels", residual.pixels}, {"mm", residual.mm}};
  }
  for (int r = 0; r < 3; ++r) rotation.push_back(to_json(pose.rotation.row(r).transpose()));
  return {
      {"focal_pixels", fit.camera.focal},
      {"focal_35mm", fit.focal_35mm},
      {"eye_lps_mm", to_json(fit.camera.eye())},
      {"camera_from_lps", {{"rotation", rotation}, {"translation_mm", to_json(pose.translation)}}},
      {"rms_pixels", fit.rms_pixels},
      {"rms_mm", fit.rms_mm},
      {"uncertainty_mm", fit.uncertainty_mm},
      {"landmarks", landmarks}};
}

json report(const ProjectedPhotographs& projected) {
  const PaintedSkin& painted = projected.painted;
  json photos = json::array();
  for (std::size_t i = 0; i < painted.photos.size(); ++i) {
    const PhotoShare& share = painted.photos[i];
    // In their order, not by their files' names, which may be a patient's.
    photos.push_back({{"seen_cm2", share.seen_cm2},
                      {"gain", to_json(share.gain)},
                      {"camera", to_json(projected.cameras[i])}});
  }
  return {{"photographs", photos},
          {"skin_cm2", painted.skin_cm2},
          {"seen_cm2", painted.seen_cm2},
          {"inpainted_cm2", painted.inpainted_cm2},
          {"disagreement", painted.disagreement},
          {"picture",
           {{"width", painted.charts.width},
            {"height", painted.charts.height},
            {"mm_per_pixel", painted.charts.mm_per_pixel},
            {"pieces", painted.charts.pieces.size()}}}};
}

}  // namespace

ProjectedPhotographs project_photographs(const std::vector<MarkedPhoto>& photos,
                                         const SkinSight& skin, const PaintOptions& options,
                                         Progress& progress) {
  if (photos.empty()) {
    throw Error(ErrorKind::input, "photographs", "none is given",
                "give one from the front, and profiles if there are any");
  }
  ProjectedPhotographs projected;
  std::vector<PlacedPhoto> placed;
  for (const MarkedPhoto& photo : photos) {
    progress.check();
    projected.cameras.push_back(fitted(photo, skin));
    const CameraFit& fit = projected.cameras.back();
    placed.push_back({photo.name, photo.photo.get(), fit.camera, fit.uncertainty_mm});
  }
  projected.painted = paint_skin(placed, skin, options, progress);
  return projected;
}

void write_projection(const ProjectedPhotographs& projected, const TriangleMesh& skin,
                      const std::filesystem::path& folder) {
  ObjDocument::of_scan(kName, scan_of(projected.painted, skin)).write(folder, kName, skin.vertices);
  write_text_file(folder / "projection.json", report(projected).dump(2) + "\n");
}

SurgicalCase with_projection(SurgicalCase plan, const std::filesystem::path& folder) {
  if (plan.photograph) {
    plan.region.vertices.clear();
    plan.region.erased = false;
    plan.tissue.sliding_vertices.clear();
  }
  plan.photograph = PhotographSource{folder / kName, {}};
  return plan;
}

}  // namespace gnathion
