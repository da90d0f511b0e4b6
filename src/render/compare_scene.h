#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/face_scene.h"
#include "render/profile_drawing.h"

class vtkRenderWindow;

namespace gnathion {

/// How two faces are laid side by side.
enum class CompareMode {
  predicted,     ///< the predicted face alone
  side_by_side,  ///< before on the left, predicted on the right, one camera
  wipe,          ///< one picture: before left of a divider, predicted right of it
  blend,         ///< before as a veil over the predicted one
  profile,       ///< the outlines of both in a sagittal plane
};

/// The face before, beside or over the scene that shows the predicted one. Both are seen through
/// the camera of that scene, whoever moves it; the mouse never reaches the other. All in one render
/// window. One thread at a time.
class CompareScene {
 public:
  /// predicted: outlives this object.
  explicit CompareScene(FaceScene& predicted);
  ~CompareScene();
  CompareScene(const CompareScene&) = delete;
  CompareScene& operator=(const CompareScene&) = delete;

  /// Adds what is needed to the window that shows the predicted scene; nothing changes in the
  /// picture until a mode is set. The window must outlive this object, or detach() must be called.
  void attach(vtkRenderWindow* window);
  /// Gives the whole picture back to the predicted scene.
  void detach();
  bool is_attached() const;

  void set_mode(CompareMode mode);
  CompareMode mode() const;
  /// Where the divider of the wipe is, 0 (left) to 1; held off the very edges so that it can be
  /// grasped.
  void set_wipe(double fraction);
  double wipe() const;
  /// How much of the face before is seen in the blend, 0..1.
  void set_blend(double share_of_before);
  /// The line at the lower edge of the blend.
  void set_blend_words(const std::string& words);

  /// The face before: give it face, bones and label. Its look (photograph, bones) follows that of
  /// the predicted scene frame by frame.
  FaceScene& before();
  ProfileDrawing& profile();

  /// Whether a place (fractions of the picture, from the upper left) shows the face before.
  bool shows_before(double x) const;
  /// Where in the predicted scene's part of the picture the same line of sight lies: x is a
  /// fraction of the picture's width.
  double in_predicted(double x) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
