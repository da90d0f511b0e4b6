#include "geometry/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gnathion {
namespace {

double next_round(double at_least) {
  const double unit = std::pow(10, std::floor(std::log10(at_least)));
  for (const double step : {1, 2, 5}) {
    if (at_least <= step * unit * (1 + 1e-9)) return step * unit;
  }
  return 10 * unit;
}

}  // namespace

Eigen::Index Histogram::largest() const {
  return counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
}

Eigen::Index Histogram::total() const {
  return std::accumulate(counts.begin(), counts.end(), Eigen::Index{0});
}

Histogram histogram(const Eigen::VectorXd& values, int most) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  Histogram result;
  if (low > high) return result;
  // Two intervals may be needed beyond the span's own: the borders lie on multiples of the width.
  result.width = next_round(std::max((high - low) / (most - 2), 1e-3));
  const double first = std::floor(low / result.width);
  result.low = first * result.width;
  const auto place = [&](double value) {
    return static_cast<std::size_t>(std::max(std::floor(value / result.width) - first, 0.0));
  };
  result.counts.assign(place(high) + 1, 0);
  for (const double value : values) {
    if (std::isfinite(value)) ++result.counts[place(value)];
  }
  return result;
}

}  // namespace gnathion
