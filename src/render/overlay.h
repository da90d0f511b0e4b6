#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

class vtkActor2D;
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

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Straight lines of one colour for an overlay, as wide wherever they are.
class OverlayLines {
 public:
  /// Where the ends of a line are.
  enum class Place {
    picture,  ///< pixels from the lower left corner, z 0
    patient,  ///< mm, LPS; seen through everything
  };
  /// colour: RGB, 0..1.
  OverlayLines(Place place, const Eigen::Vector3d& colour);
  ~OverlayLines();
  OverlayLines(const OverlayLines&) = delete;
  OverlayLines& operator=(const OverlayLines&) = delete;

  /// What an overlay adds.
  vtkActor2D* prop() const;
  void set_lines(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& ends);
  /// In pixels of the picture.
  void set_width(double pixels);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
