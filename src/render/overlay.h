#pragma once

#include <memory>

class vtkProp;
class vtkRenderer;

namespace gnathion {

/// Flat things over a 3D picture that follow its camera: whoever derives from it says what they are
/// and sets them anew before every frame. One thread, the window's own.
class Overlay {
 public:
  virtual ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// The renderer must outlive the overlay, or detach() must be called before.
  void attach(vtkRenderer* renderer);
  void detach();
  void set_visible(bool visible);

 protected:
  Overlay();
  /// Takes part in the picture from now on. While the overlay is hidden, so is the prop.
  void add(vtkProp* prop);
  /// Called before every frame in which the overlay is visible.
  virtual void prepare(vtkRenderer& renderer) = 0;
  /// Pixels of the picture a logical one: more than 1 on screens of high resolution.
  static double pixel_ratio(vtkRenderer& renderer);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
