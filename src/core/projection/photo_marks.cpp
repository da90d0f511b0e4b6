#include "projection/photo_marks.h"

#include "base/error.h"
#include "io/json_reader.h"

namespace gnathion {

PhotoMarks read_photo_marks(const std::filesystem::path& file) {
  JsonReader reader = JsonReader::file(file.string());
  PhotoMarks marks;
  JsonReader landmarks = reader.required_object("landmarks");
  for (const std::string& name : landmarks.keys()) {
    marks.pixels[name] = landmarks.required_pixel(name);
  }
  if (reader.has("focal_35mm")) {
    double focal = 0;
    reader.read("focal_35mm", focal);
    marks.camera.focal_35mm = focal;
  }
  reader.finish();
  return marks;
}

std::map<std::string, Eigen::Vector3d> read_skin_landmarks(const std::filesystem::path& file) {
  JsonReader reader = JsonReader::file(file.string());
  JsonReader landmarks = reader.required_object("landmarks");
  std::map<std::string, Eigen::Vector3d> places;
  for (const std::string& name : landmarks.keys()) places[name] = landmarks.required_vector(name);
  return places;
}

std::vector<PhotoLandmark> paired(const PhotoMarks& marks,
                                  const std::map<std::string, Eigen::Vector3d>& on_skin,
                                  const std::string& photo) {
  std::vector<PhotoLandmark> landmarks;
  for (const auto& [name, pixel] : marks.pixels) {
    const auto place = on_skin.find(name);
    if (place == on_skin.end()) {
      throw Error(ErrorKind::input, photo,
                  "has the landmark " + name + ", whose place on the skin is not known",
                  "give it in LPS mm with --landmarks, or leave it out");
    }
    landmarks.push_back({name, place->second, pixel});
  }
  return landmarks;
}

}  // namespace gnathion
