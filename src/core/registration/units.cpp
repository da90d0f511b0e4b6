#include "registration/units.h"

#include <algorithm>
#include <cmath>

namespace gnathion {

double robust_size(const Points& vertices) {
  if (vertices.rows() == 0) return 0;
  double size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> along(static_cast<std::size_t>(vertices.rows()));
    for (std::size_t i = 0; i < along.size(); ++i) {
      along[i] = vertices(static_cast<Eigen::Index>(i), axis);
    }
    const auto stray = static_cast<std::ptrdiff_t>(along.size() / 100);
    const auto low = along.begin() + stray, high = along.end() - 1 - stray;
    std::nth_element(along.begin(), low, along.end());
    const double least = *low;
    std::nth_element(along.begin(), high, along.end());
    size = std::max(size, *high - least);
  }
  return size;
}

std::vector<LengthUnit> proposed_units(const Points& vertices) {
  constexpr double kLeast = 110, kMost = 1300, kUsual = 300;  // mm
  const double size = robust_size(vertices);
  std::vector<LengthUnit> units;
  for (const auto& [name, mm] : {std::pair{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}}) {
    if (size * mm >= kLeast && size * mm <= kMost) units.push_back({name, mm, size * mm});
  }
  std::sort(units.begin(), units.end(), [](const LengthUnit& a, const LengthUnit& b) {
    return std::abs(std::log(a.size_mm / kUsual)) < std::abs(std::log(b.size_mm / kUsual));
  });
  return units;
}

}  // namespace gnathion
