#include "render/colour_map.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <vtkLookupTable.h>

namespace gnathion {
namespace {

/// Moreland's Msh: magnitude, saturation (angle from the lightness axis), hue, of CIELAB.
struct Msh {
  double m, s, h;
};

constexpr Msh cold{80, 1.08, -1.1};
constexpr Msh warm{80, 1.08, 0.5};
constexpr double white_magnitude = 88;

double to_srgb(double linear) {
  const double c = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return std::clamp(c, 0.0, 1.0);
}

double inverse_f(double t) {  // CIE 15:2004, inverse of the CIELAB companding
  constexpr double delta = 6.0 / 29.0;
  return t > delta ? t * t * t : 3 * delta * delta * (t - 4.0 / 29.0);
}

Eigen::Vector3d rgb_of(const Msh& colour) {
  const double lightness = colour.m * std::cos(colour.s);
  const double a = colour.m * std::sin(colour.s) * std::cos(colour.h);
  const double b = colour.m * std::sin(colour.s) * std::sin(colour.h);
  const double fy = (lightness + 16) / 116;
  const Eigen::Vector3d xyz(0.9505 * inverse_f(fy + a / 500), inverse_f(fy),
                            1.089 * inverse_f(fy - b / 200));  // D65
  Eigen::Matrix3d linear_from_xyz;                             // IEC 61966-2-1
  linear_from_xyz << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
  const Eigen::Vector3d linear = linear_from_xyz * xyz;
  return {to_srgb(linear.x()), to_srgb(linear.y()), to_srgb(linear.z())};
}

/// The hue turns a little towards white, so that lightness and hue change at an even pace
/// (Moreland 2009, figure 4).
double turned_hue(const Msh& end) {
  const double spin = end.s * std::sqrt(white_magnitude * white_magnitude - end.m * end.m) /
                      (end.m * std::sin(end.s));
  return end.h > -0.3 * 3.14159265358979 ? end.h + spin : end.h - spin;
}

}  // namespace

Eigen::Vector3d diverging_colour(double position) {
  const double x = std::clamp(position, -1.0, 1.0);
  const Msh& end = x < 0 ? cold : warm;
  const double w = std::abs(x);
  const double hue = turned_hue(end) + w * (end.h - turned_hue(end));
  return rgb_of({white_magnitude + w * (end.m - white_magnitude), w * end.s, hue});
}

vtkSmartPointer<vtkLookupTable> diverging_table(double half_range) {
  constexpr int count = 257;  // odd: zero has an entry of its own
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetRange(-half_range, half_range);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d rgb = diverging_colour(2.0 * i / (count - 1) - 1);
    table->SetTableValue(i, rgb.x(), rgb.y(), rgb.z(), 1);
  }
  table->SetNanColor(unmeasured_colour.x(), unmeasured_colour.y(), unmeasured_colour.z(), 1);
  return table;
}

double round_half_range(const Eigen::VectorXd& values) {
  std::vector<double> sizes;
  for (const double value : values) {
    if (std::isfinite(value) && std::abs(value) > 0.05) sizes.push_back(std::abs(value));
  }
  if (sizes.empty()) return 1;
  const auto rank =
      static_cast<std::ptrdiff_t>(std::ceil(0.99 * static_cast<double>(sizes.size())));
  const auto place = sizes.begin() + std::max<std::ptrdiff_t>(rank - 1, 0);
  std::nth_element(sizes.begin(), place, sizes.end());
  const double wanted = std::max(*place, 0.1);
  const double unit = std::pow(10, std::floor(std::log10(wanted) + 1e-9));
  for (const double step : {1, 2, 3, 4, 5, 6, 8}) {
    if (wanted <= step * unit * (1 + 1e-9)) return step * unit;
  }
  return 10 * unit;
}

}  // namespace gnathion
