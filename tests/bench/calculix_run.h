#pragma once

#include <functional>
#include <optional>

#include "io/calculix.h"

namespace gnathion::bench {

/// Wall clock and processor time, user and system, s.
struct Cost {
  double wall = 0, processor = 0;
};

/// Of what this process does itself.
Cost cost_of(const std::function<void()>& work);

/// What CalculiX answers, one thread; the cost is the whole program's.
struct CalculixRun {
  Points displacements;  ///< a row each node, mm, seven digits
  Cost cost;
};

/// Nothing where ccx is not installed or does not converge.
std::optional<CalculixRun> run_calculix(const CalculixProblem& problem);

}  // namespace gnathion::bench
