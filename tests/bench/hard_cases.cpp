#include "bench/hard_cases.h"

#include <exception>
#include <filesystem>
#include <utility>

#include "bench/table.h"

namespace gnathion::bench {
namespace {

std::string name_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return "usage";
    case ErrorKind::case_file:
      return "case file";
    case ErrorKind::input:
      return "input";
    case ErrorKind::anatomy:
      return "anatomy";
    case ErrorKind::numeric:
      return "numeric";
    case ErrorKind::output:
      return "output";
    case ErrorKind::cancelled:
      return "cancelled";
  }
  return "unknown";
}

/// Without the folder of a file, which is another one each time.
std::string subject_of(const Error& error) {
  return std::filesystem::path(error.subject()).filename();
}

std::string words(const Error& error) {
  return "refused (" + name_of(error.kind()) + ") " + subject_of(error) + ": " + error.problem();
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all = hard_mechanics();
  for (HardCase& hard : hard_scenes()) all.push_back(std::move(hard));
  return all;
}

HardOutcome outcome_of(const HardCase& hard) {
  try {
    return hard.run();
  } catch (const Error& error) {
    return {words(error), false};
  } catch (const std::exception& error) {
    return {error.what(), false};
  }
}

HardCase bounded(const std::string& what, const std::string& measure, double limit,
                 const std::string& unit, std::function<double()> value) {
  const std::string in_unit = unit.empty() ? "" : " " + unit;
  return {what, measure + " ≤ " + number(limit) + in_unit, [=, value = std::move(value)] {
            const double is = value();
            return HardOutcome{number(is) + in_unit, is <= limit};
          }};
}

HardCase refused(const std::string& what, ErrorKind kind, const std::string& subject,
                 const std::string& part, std::function<void()> work) {
  return {what, "refused (" + name_of(kind) + ") " + subject + ": … " + part + " …",
          [=, work = std::move(work)] {
            try {
              work();
            } catch (const Error& error) {
              return HardOutcome{words(error), error.kind() == kind &&
                                                   subject_of(error) == subject &&
                                                   error.problem().find(part) != std::string::npos};
            }
            return HardOutcome{"no refusal", false};
          }};
}

}  // namespace gnathion::bench
