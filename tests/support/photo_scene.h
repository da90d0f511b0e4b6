#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "phantom/face_paint.h"
#include "phantom/head_model.h"
#include "phantom/head_phantom.h"
#include "phantom/repeatable_random.h"
#include "phantom/surface_search.h"
#include "projection/photo.h"
#include "projection/photo_camera.h"
#include "registration/parallel.h"

namespace gnathion::test {

/// Light that falls on a photograph: its colour, and how much of it comes from one side.
struct Light {
  Eigen::Vector3d gain = Eigen::Vector3d::Ones();
  double shade = 0;  ///< 0: flat; 1: black where it is turned away
  Eigen::Vector3d from = Eigen::Vector3d(0.4, -0.8, 0.45);
};

/// A camera that looks from a direction (degrees to the patient's left of straight ahead, degrees
/// above) at the middle of the face, upright but for `roll`; its picture is `height` pixels high
/// and three quarters as wide.
inline PhotoCamera camera_from(double left_deg, double above_deg, double roll_deg,
                               double distance_mm, double focal_35mm, int height) {
  using Eigen::Vector3d;
  const double side = left_deg * M_PI / 180, up = above_deg * M_PI / 180;
  const Vector3d outward(std::sin(side) * std::cos(up), -std::cos(side) * std::cos(up),
                         std::sin(up));
  const Vector3d eye = Vector3d(0, -45, -10) + distance_mm * outward, into = -outward;
  const Vector3d right = into.cross(Vector3d(0, 0, 1)).normalized(), down = into.cross(right);
  PhotoCamera camera;
  Eigen::Matrix3d& turn = camera.camera_from_lps.rotation;
  turn << right.transpose(), down.transpose(), into.transpose();
  turn = Eigen::AngleAxisd(roll_deg * M_PI / 180, Vector3d::UnitZ()).toRotationMatrix() * turn;
  camera.camera_from_lps.translation = -turn * eye;
  const int width = 3 * height / 4;
  camera.focal = focal_35mm * std::hypot(width, height) / 43.2666;
  camera.centre = {(width - 1) / 2.0, (height - 1) / 2.0};
  return camera;
}

inline int width_of(const PhotoCamera& camera) {
  return static_cast<int>(std::lround(2 * camera.centre.x() + 1));
}
inline int height_of(const PhotoCamera& camera) {
  return static_cast<int>(std::lround(2 * camera.centre.y() + 1));
}

/// What the camera sees of the painted skin, before a grey wall: a ray for each pixel.
inline Photo photograph(const PhotoCamera& camera, const SkinSight& skin, const FacePaint& paint,
                        const Light& light = {}) {
  Photo photo{width_of(camera), height_of(camera), {}};
  photo.rgb.assign(static_cast<std::size_t>(3 * photo.width * photo.height), 150);
  const Eigen::Vector3d eye = camera.eye(), from = light.from.normalized();
  for_each_in_parallel(static_cast<std::size_t>(photo.height), [&](std::size_t y) {
    for (int x = 0; x < photo.width; ++x) {
      const Eigen::Vector3d direction = camera.direction({x, static_cast<double>(y)});
      const auto hit = skin.tree().first_hit(eye, direction, 1e5);
      if (!hit) continue;
      const Eigen::Vector3d at = eye + hit->distance * direction;
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k) {
        normal += hit->barycentric[k] *
                  skin.normals().row(skin.mesh().triangles(hit->triangle, k)).transpose();
      }
      const double lit = 1 - light.shade * (1 - std::max(0.0, normal.normalized().dot(from)));
      const Eigen::Vector3d colour =
          lit * paint.colour(at).cwiseProduct(light.gain).cwiseMin(1.0) * 255;
      for (std::size_t c = 0; c < 3; ++c) {
        photo.rgb[3 * (y * static_cast<std::size_t>(photo.width) + static_cast<std::size_t>(x)) +
                  c] = static_cast<std::uint8_t>(std::lround(colour[static_cast<int>(c)]));
      }
    }
  });
  return photo;
}

/// Places of the analytic head's skin that a user would pick, LPS mm: those of the phantom's truth,
/// the corners of the eyes, and before the ears.
inline std::map<std::string, Eigen::Vector3d> picked_places() {
  std::map<std::string, Eigen::Vector3d> places;
  const auto truth = phantom_truth().landmarks;
  for (const char* name :
       {"nasion_soft", "nose_tip", "subnasale", "upper_lip", "lower_lip", "pogonion_soft",
        "menton_soft", "mouth_corner_left", "mouth_corner_right"}) {
    places[name] = truth.at(name);
  }
  const HeadModel head;
  const auto skin = [&](const Eigen::Vector3d& p) { return head.skin(p); };
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side > 0 ? "left" : "right";
    const Eigen::Vector3d back(0, 1, 0), inwards(-side, 0, 0);
    places["canthus_inner_" + name] = surface_point(skin, {16.5 * side, -180, 12.5}, back);
    places["canthus_outer_" + name] = surface_point(skin, {46.5 * side, -180, 14.5}, back);
    places["before_ear_" + name] = surface_point(skin, {150 * side, -14, 0}, inwards);
  }
  return places;
}

/// Those of the places that the camera sees, picked with normal errors in the picture (pixels) and
/// on the skin (mm).
inline std::vector<PhotoLandmark> picked(const PhotoCamera& camera, const SkinSight& skin,
                                         double picture_pixels, double skin_mm, unsigned seed) {
  std::vector<PhotoLandmark> landmarks;
  const std::uint64_t key = static_cast<std::uint64_t>(seed) << 32;
  std::uint64_t at = 0;
  for (const auto& [name, place] : picked_places()) {
    at += 10;
    if (skin.hides(place, camera.eye(), 3)) continue;
    PhotoLandmark landmark{name, place, camera.pixel(place)};
    for (int c = 0; c < 2; ++c) {
      landmark.pixel[c] += picture_pixels * normal(key + at + static_cast<unsigned>(c));
    }
    for (int c = 0; c < 3; ++c) {
      landmark.lps[c] += skin_mm * normal(key + at + 2 + static_cast<unsigned>(c));
    }
    const bool inside = landmark.pixel.minCoeff() > 0 &&
                        landmark.pixel.x() < width_of(camera) - 1 &&
                        landmark.pixel.y() < height_of(camera) - 1;
    if (inside) landmarks.push_back(landmark);
  }
  return landmarks;
}

/// For each place of the skin that the camera sees squarely (to 70 degrees): how far from it, in mm
/// across the line of sight, lies what it is given the colour of when `found` is taken for the
/// camera.
inline std::vector<double> displacements(const PhotoCamera& camera, const PhotoCamera& found,
                                         const SkinSight& skin) {
  std::vector<double> mm;
  const Eigen::Vector3d eye = camera.eye();
  const Points& vertices = skin.mesh().vertices;
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    const Eigen::Vector3d x = vertices.row(v), normal = skin.normals().row(v);
    if (normal.dot((eye - x).normalized()) < 0.34 || found.depth(x) < 1) continue;
    const Eigen::Vector2d pixel = camera.pixel(x);
    if (pixel.minCoeff() < 0 || pixel.x() > width_of(camera) || pixel.y() > height_of(camera))
      continue;
    if (skin.hides(x + 0.5 * normal, eye, 0.2)) continue;
    mm.push_back((found.pixel(x) - pixel).norm() * camera.depth(x) / camera.focal);
  }
  return mm;
}

}  // namespace gnathion::test
