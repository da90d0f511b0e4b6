#pragma once

#include <memory>
#include <string>

#include "render/overlay.h"

namespace gnathion {

/// The longest of 1, 2 or 5 times a power of ten mm that takes at most `most_pixels`.
/// \pre both positive.
double scale_bar_mm(double pixels_per_mm, double most_pixels);

/// The length in words: "50 mm", "0.5 mm".
std::string scale_bar_words(double mm);

/// Pixels of a millimetre at the depth of the point that the camera turns about: with perspective,
/// nearer things are larger.
double pixels_per_mm(vtkRenderer& renderer);

/// A bar of a round length at the picture's lower edge, of what lies at the depth of the point that
/// the camera turns about.
class ScaleBar : public Overlay {
 public:
  ScaleBar();
  ~ScaleBar() override;

 private:
  void prepare(vtkRenderer& renderer) override;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
