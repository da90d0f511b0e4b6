#pragma once

#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh_types.h"

class vtkRenderer;

namespace gnathion {

/// A named point of the skin, before and after, mm, LPS.
struct ProfileLandmark {
  std::string name;
  Eigen::Vector3d before, after;
};

/// What a profile shows: sections of the face by one sagittal plane. Points: mm, LPS; their x is
/// not drawn.
struct Profile {
  std::vector<Points> before, after;  ///< chains, as section_chains() in geometry/section_chains.h
  std::vector<ProfileLandmark> landmarks;
};

/// The words of the drawing, in the user's language.
struct ProfileWords {
  std::string caption;              ///< upper left
  std::string before = "Before";    ///< in the legend
  std::string after = "Predicted";  ///< in the legend
  std::string landmarks = "Soft-tissue landmarks";
  std::string grid = "grid";  ///< "grid 10 mm"
};

/// The profile of a face as a drawing on millimetre paper, the nose to the right: before as a
/// dashed blue line, after as a solid orange one, with landmarks, legend and scale. Moves and zooms
/// in its plane only. One thread at a time.
class ProfileDrawing {
 public:
  ProfileDrawing();
  ~ProfileDrawing();
  ProfileDrawing(const ProfileDrawing&) = delete;
  ProfileDrawing& operator=(const ProfileDrawing&) = delete;

  /// Belongs to the drawing, as FaceScene::renderer().
  vtkRenderer* renderer() const;

  void show(const Profile& profile);
  void set_words(const ProfileWords& words);
  /// The part of the patient that fills the picture, mm, LPS: only y and z count.
  void frame(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double aspect_ratio);
  /// Moves the paper, in fractions of the picture's height, right and up.
  void pan(double right, double up);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
