#pragma once

#include <Eigen/Core>
#include <QString>

namespace gnathion {

/// A vector (mm, LPS) as a surgeon says it: "12.3 mm left, 4.0 mm forward, 1.5 mm down"; parts
/// that round to 0.0 are left out, and "0.0 mm" says that all are.
QString direction_words(const Eigen::Vector3d& lps);

/// A length or signed value with its unit, one decimal: "3.4 mm"; `with_sign`: "+3.4 mm". A value
/// that rounds to zero has no sign.
QString mm_words(double mm, bool with_sign = false);

}  // namespace gnathion
