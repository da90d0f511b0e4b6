#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/error.h"

namespace gnathion::bench {

/// What a hard case did, in words, and whether that is what it must do.
struct HardOutcome {
  std::string did;
  bool held = false;
};

/// One row of the table of hard cases: asked for in `./run bench`, asserted in `./run test`.
struct HardCase {
  std::string what, must;
  std::function<HardOutcome()> run;
};

/// All of them, those of the mechanics first.
std::vector<HardCase> hard_cases();
std::vector<HardCase> hard_mechanics();  ///< materials, meshes, motions, time
std::vector<HardCase> hard_scenes();     ///< regions and points of faces

/// Runs the case; an error that it does not expect is an outcome that does not hold.
HardOutcome outcome_of(const HardCase& hard);

/// Asks for `value` <= `limit`; NaN is not. `measure`: what the value is.
HardCase bounded(const std::string& what, const std::string& measure, double limit,
                 const std::string& unit, std::function<double()> value);

/// Asks for an Error of this kind and subject, whose problem holds `part`.
HardCase refused(const std::string& what, ErrorKind kind, const std::string& subject,
                 const std::string& part, std::function<void()> work);

}  // namespace gnathion::bench
