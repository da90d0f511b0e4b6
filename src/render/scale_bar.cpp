#include "render/scale_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "render/pixel_ratio.h"

namespace gnathion {
namespace {

constexpr double most_of_the_width = 0.25;
constexpr double tick = 4;  // half height, logical pixels
constexpr double from_below = 12;
constexpr double font_size = 12;
const Eigen::Vector3d ink{0.13, 0.17, 0.22};
constexpr double pi = 3.14159265358979323846;

}  // namespace

double scale_bar_mm(double pixels_per_mm, double most_pixels) {
  const double most = most_pixels / pixels_per_mm;
  const double decade = std::pow(10, std::floor(std::log10(most)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * decade <= most) return digit * decade;
  }
  return decade;
}

std::string scale_bar_words(double mm) {
  char words[32];
  std::snprintf(words, sizeof words, "%g mm", mm);
  return words;
}

double pixels_per_mm(vtkRenderer& renderer) {
  vtkCamera* camera = renderer.GetActiveCamera();
  const double half_height =
      camera->GetParallelProjection()
          ? camera->GetParallelScale()
          : camera->GetDistance() * std::tan(camera->GetViewAngle() / 2 * pi / 180);
  return renderer.GetSize()[1] / (2 * half_height);
}

struct ScaleBar::Impl {
  OverlayLines bar{OverlayLines::Place::picture, ink};
  vtkNew<vtkTextActor> label;
};

ScaleBar::ScaleBar() : impl_(std::make_unique<Impl>()) {
  impl_->label->SetInput("");
  impl_->label->GetTextProperty()->SetColor(ink.x(), ink.y(), ink.z());
  impl_->label->GetTextProperty()->SetJustificationToCentered();
  add(impl_->bar.prop());
  add(impl_->label);
}

ScaleBar::~ScaleBar() {
  detach();
}

void ScaleBar::prepare(vtkRenderer& renderer) {
  const double ratio = pixel_ratio(&renderer);
  const double width = renderer.GetSize()[0];
  const double scale = pixels_per_mm(renderer);
  const double mm = scale_bar_mm(scale, most_of_the_width * width);
  const double left = std::round((width - mm * scale) / 2);
  const double right = left + mm * scale;
  const double y = from_below * ratio;
  const double up = tick * ratio;
  impl_->bar.set_lines({{{left, y, 0}, {right, y, 0}},
                        {{left, y - up, 0}, {left, y + up, 0}},
                        {{right, y - up, 0}, {right, y + up, 0}}});
  impl_->bar.set_width(1.5 * ratio);
  impl_->label->SetInput(scale_bar_words(mm).c_str());
  impl_->label->SetPosition((left + right) / 2, y + up + 2 * ratio);
  impl_->label->GetTextProperty()->SetFontSize(static_cast<int>(font_size));
}

}  // namespace gnathion
