#include "phantom/head_phantom.h"

#include <Eigen/Geometry>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "phantom/phantom_ct.h"
#include "phantom/phantom_photograph.h"
#include "phantom/surface_search.h"

namespace gnathion {

using Eigen::Vector3d;

namespace {

using Landmarks = std::map<std::string, Vector3d>;

void add_skin_landmarks(const HeadModel& head, Landmarks& landmarks) {
  const DistanceFunction skin = [&](const Vector3d& p) { return head.skin(p); };
  const Vector3d forward(0, -1, 0);
  const auto in_midline = [](double z) { return Vector3d(0, -60, z); };
  const auto most_forward = [&](double low, double high) {
    return most_prominent(skin, in_midline(low), in_midline(high), forward);
  };
  const auto most_backward = [&](double low, double high) {
    return most_recessed(skin, in_midline(low), in_midline(high), forward);
  };
  landmarks["nasion_soft"] = most_backward(18, 34);
  landmarks["nose_tip"] = most_forward(-30, 0);
  landmarks["subnasale"] =
      most_recessed(skin, {0, -116, -18}, {0, -104, -30}, Vector3d(0, -1, -1).normalized());
  landmarks["upper_lip"] = most_forward(-40, -31);
  landmarks["stomion"] = most_backward(-45, -39);
  landmarks["lower_lip"] = most_forward(-53, -44);
  landmarks["mentolabial_fold"] = most_backward(-66, -52);
  landmarks["pogonion_soft"] = most_forward(-84, -62);
  landmarks["menton_soft"] = most_prominent(skin, {0, -70, -60}, {0, -92, -60}, Vector3d(0, 0, -1));
  landmarks["mouth_corner_left"] = surface_point(skin, {25, -180, -41.9}, -forward);
}

void add_bone_landmarks(const HeadModel& head, Landmarks& landmarks) {
  const DistanceFunction skull = [&](const Vector3d& p) { return head.skull(p); };
  const DistanceFunction mandible = [&](const Vector3d& p) { return head.mandible(p); };
  const Vector3d forward(0, -1, 0);
  const auto in_midline = [](double z) { return Vector3d(0, -60, z); };
  landmarks["nasion"] = most_recessed(skull, in_midline(24), in_midline(38), forward);
  landmarks["a_point"] = most_recessed(skull, in_midline(-30), in_midline(-23), forward);
  landmarks["upper_incisor_edge"] =
      most_prominent(skull, {4, -100, -40}, {4, -92, -40}, Vector3d(0, 0, -1));
  landmarks["lower_incisor_edge"] =
      most_prominent(mandible, {2.7, -96, -50}, {2.7, -88, -50}, Vector3d(0, 0, 1));
  landmarks["b_point"] = most_recessed(mandible, in_midline(-72), in_midline(-57), forward);
  landmarks["pogonion"] = most_prominent(mandible, in_midline(-82), in_midline(-68), forward);
  landmarks["menton"] = most_prominent(mandible, {0, -82, -60}, {0, -94, -60}, Vector3d(0, 0, -1));
  landmarks["gnathion"] =
      most_prominent(mandible, {0, -86, -76}, {0, -96, -66}, Vector3d(0, -1, -1).normalized());
  const Vector3d angle = Vector3d(0, 1, -1).normalized();
  const Vector3d along = Vector3d(0, 1, 1).normalized();
  const Vector3d ramus(46, -22, -56);
  landmarks["gonion_left"] = most_prominent(mandible, ramus - 8 * along, ramus + 12 * along, angle);
  landmarks["condyle_left"] =
      most_prominent(mandible, {50, -24, -10}, {50, -8, -10}, Vector3d(0, 0, 1));
}

/// The photograph's frame: y up, z forwards, the head turned and nodded a few degrees, its origin
/// in front of the ears.
Similarity photograph_to_lps() {
  const auto about = [](double degrees, const Vector3d& axis) {
    return Eigen::AngleAxisd(degrees * M_PI / 180, axis);
  };
  const Eigen::Matrix3d lps_from_upright =
      (Eigen::Matrix3d() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
  Similarity s;
  s.rotation = lps_from_upright * (about(6, Vector3d::UnitY()) * about(-4, Vector3d::UnitX()) *
                                   about(1.5, Vector3d::UnitZ()))
                                      .toRotationMatrix();
  s.translation = {4, -61, -17};
  return s;
}

nlohmann::json to_json(const Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

nlohmann::json to_json(const Eigen::Matrix3d& m) {
  return {to_json(Vector3d(m.row(0))), to_json(Vector3d(m.row(1))), to_json(Vector3d(m.row(2)))};
}

nlohmann::json to_json(const PhantomTruth& truth, const PhantomOptions& options) {
  nlohmann::json json;
  json["about"] = "Gnathion's synthetic head; LPS mm";
  json["seed"] = options.seed;
  for (const auto& [name, p] : truth.landmarks) {
    json["landmarks"][name] = to_json(p);
  }
  json["mandible_frame"] = {{"rotation", to_json(truth.mandible_frame.rotation)},
                            {"translation", to_json(truth.mandible_frame.translation)}};
  json["lps_from_photograph"] = {{"scale", truth.lps_from_photograph.scale},
                                 {"rotation", to_json(truth.lps_from_photograph.rotation)},
                                 {"translation", to_json(truth.lps_from_photograph.translation)}};
  json["mandible_box"] = {{"min", to_json(truth.mandible_box_min)},
                          {"max", to_json(truth.mandible_box_max)}};
  return json;
}

void check_range(const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    throw Error(ErrorKind::usage, name, "is " + std::to_string(value),
                "choose a value from " + std::to_string(low) + " to " + std::to_string(high));
  }
}

void check(const std::filesystem::path& folder, const PhantomOptions& options) {
  check_range("pixel_mm", options.pixel_mm, 0.4, 3);
  check_range("slice_step_mm", options.slice_step_mm, 0.4, 3);
  check_range("noise_hu", options.noise_hu, 0, 100);
  check_range("photograph_edge_mm", options.photograph_edge_mm, 1, 6);
  check_range("texture_pixels", options.texture_pixels, 64, 8192);
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw Error(ErrorKind::output, folder.string(), "is not a folder", "make it first");
  }
  if (!std::filesystem::is_empty(folder, error)) {
    throw Error(ErrorKind::output, folder.string(), "is not empty", "choose an empty folder");
  }
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (error) {
    throw Error(ErrorKind::output, folder.string(), error.message(),
                "choose a folder that can be written");
  }
}

}  // namespace

PhantomTruth phantom_truth() {
  const HeadModel head;
  PhantomTruth truth;
  add_skin_landmarks(head, truth.landmarks);
  add_bone_landmarks(head, truth.landmarks);
  truth.landmarks["mole"] = FacePaint(head, 0).mole();
  for (const std::string name : {"mouth_corner", "gonion", "condyle"}) {
    Vector3d mirrored = truth.landmarks.at(name + "_left");
    mirrored.x() = -mirrored.x();
    truth.landmarks[name + "_right"] = mirrored;
  }
  truth.mandible_frame.translation =
      (truth.landmarks.at("condyle_left") + truth.landmarks.at("condyle_right")) / 2;
  truth.lps_from_photograph = photograph_to_lps();
  truth.mandible_box_min = {-62, -104, -92};
  truth.mandible_box_max = {62, -36, -42 - HeadModel::joint_gap / 2};
  return truth;
}

PhantomTruth write_phantom_case(const std::filesystem::path& folder, const PhantomOptions& options,
                                Progress& progress) {
  check(folder, options);
  const HeadModel head;
  PhantomTruth truth = phantom_truth();
  make_folder(folder / "ct");
  write_phantom_dicom(make_phantom_volume(head, options, progress), folder / "ct", options.seed,
                      progress);
  make_folder(folder / "photograph");
  write_phantom_photograph(make_phantom_photograph(head, options, progress),
                           FacePaint(head, options.seed), truth.lps_from_photograph,
                           folder / "photograph", options, progress);
  std::ofstream file(folder / "truth.json");
  file << to_json(truth, options).dump(2) << '\n';
  file.close();
  if (!file) {
    throw Error(ErrorKind::output, (folder / "truth.json").string(), "could not be written",
                "free some space or choose a folder that can be written");
  }
  return truth;
}

}  // namespace gnathion
