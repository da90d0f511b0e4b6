#pragma once

#include <Eigen/Core>
#include <vector>

namespace gnathion {

/// How many values lie in each of a row of equally wide intervals.
struct Histogram {
  double low = 0;    ///< where the first begins
  double width = 1;  ///< of each, a round number: 1, 2 or 5 times a power of ten
  std::vector<Eigen::Index> counts;

  double high() const { return low + width * static_cast<double>(counts.size()); }
  Eigen::Index largest() const;
  Eigen::Index total() const;
};

/// Of the finite values, in at most `most` intervals that begin at multiples of their width, so
/// that zero never lies within one. A value on a border counts to the right. No values: no
/// intervals. \pre most >= 3
Histogram histogram(const Eigen::VectorXd& values, int most = 48);

}  // namespace gnathion
