#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "projection/photo_camera.h"

namespace gnathion {

/// The landmarks that were picked in a photograph.
struct PhotoMarks {
  std::map<std::string, Eigen::Vector2d> pixels;  ///< as PhotoLandmark::pixel
  CameraOptions camera;
};

/// Reads {"landmarks": {"nose_tip": [x, y], …}, "focal_35mm": 50}; the focal length may be left
/// out. Throws Error(input) when the file cannot be read, Error(case_file) with the key's path for
/// what is wrong in it.
PhotoMarks read_photo_marks(const std::filesystem::path& file);

/// Landmarks of the skin, LPS mm, from the object "landmarks" of a JSON file, whatever else it
/// holds: a case file, a file of their own. Throws as read_photo_marks().
std::map<std::string, Eigen::Vector3d> read_skin_landmarks(const std::filesystem::path& file);

/// Those that are known on the skin and in the picture. Throws Error(input) naming `photo` and the
/// first name that the skin does not have.
std::vector<PhotoLandmark> paired(const PhotoMarks& marks,
                                  const std::map<std::string, Eigen::Vector3d>& on_skin,
                                  const std::string& photo);

}  // namespace gnathion
