#include "registration/units.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

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

namespace {

constexpr double kHead = 260;  // mm along the longest side; a face alone is some 200

std::string in_short(double number) {
  std::ostringstream text;
  if (number >= 100) {
    text << std::lround(number);
  } else {
    text << std::setprecision(3) << number;
  }
  return text.str();
}

/// How far from a head's size, for the order. Inches come last where something else will do.
double unlikely(const ProposedUnit& unit, double size) {
  return std::abs(std::log(size * unit.mm_per_unit / kHead)) + (unit.name == "inch" ? 1 : 0);
}

/// Of those that are not in doubt otherwise: sure only where there is no other.
void doubt_together(std::vector<ProposedUnit>& units) {
  for (ProposedUnit& unit : units) {
    if (units.size() > 1) unit.confidence = std::min(unit.confidence, Confidence::fair);
    if (unit.name != "inch") continue;
    unit.confidence = Confidence::low;
    unit.reason += "; few scanners use inches, and some use no unit at all";
  }
}

ProposedUnit no_usual_unit(double size) {
  const double mm = size > 0 ? kHead / size : 1;
  return {"", mm, Confidence::low,
          "in no usual unit is the scan as large as a head; with " + in_short(mm) +
              " mm a unit its longest side is that of one"};
}

}  // namespace

std::vector<ProposedUnit> proposed_units(const Points& vertices) {
  constexpr double kLeast = 110, kMost = 1300, kSureLeast = 150, kSureMost = 520;  // mm
  const double size = robust_size(vertices);
  std::vector<ProposedUnit> units;
  for (const auto& [name, mm_per_unit] :
       {std::pair{"mm", 1.0}, {"m", 1000.0}, {"cm", 10.0}, {"inch", 25.4}}) {
    const double mm = size * mm_per_unit;
    if (!(mm >= kLeast && mm <= kMost)) continue;
    const bool sure = mm >= kSureLeast && mm <= kSureMost;
    units.push_back({name, mm_per_unit, sure ? Confidence::high : Confidence::fair,
                     std::string("in ") + name + " the scan is " + in_short(mm) +
                         " mm along its longest side, as " +
                         (mm <= 330 ? "a face or head" : "a head with shoulders") + " is"});
  }
  std::stable_sort(units.begin(), units.end(), [size](const auto& a, const auto& b) {
    return unlikely(a, size) < unlikely(b, size);
  });
  doubt_together(units);
  if (units.empty()) units.push_back(no_usual_unit(size));
  return units;
}

}  // namespace gnathion
