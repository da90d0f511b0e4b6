#include "io/own_inputs.h"

#include <memory>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.h"
#include "io/files.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

/// The path below the folder; empty when it is not within.
fs::path below(const fs::path& path, const fs::path& folder) {
  if (path.empty() || folder.empty()) return {};
  const fs::path relative = fs::absolute(path).lexically_normal().lexically_relative(
      fs::absolute(folder).lexically_normal());
  const bool within = !relative.empty() && *relative.begin() != ".." && relative != ".";
  return within ? relative : fs::path();
}

/// The paths of a plan's inputs.
std::vector<fs::path*> inputs_of(SurgicalCase& plan) {
  std::vector<fs::path*> inputs{&plan.ct.path};
  if (plan.photograph) inputs.push_back(&plan.photograph->obj);
  return inputs;
}

void copy_input(const fs::path& from, const fs::path& to) {
  std::error_code failure;
  fs::copy(from, to, fs::copy_options::recursive, failure);
  if (!failure) return;
  std::error_code ignored;
  if (!fs::exists(from, ignored)) {
    throw Error(ErrorKind::input, from.string(), "is no longer there to be copied",
                "open the case again");
  }
  throw Error(ErrorKind::output, to.string(),
              "the case's images cannot be copied (" + failure.message() + ")",
              "check free space and rights, or choose another place");
}

}  // namespace

bool lies_within(const fs::path& path, const fs::path& folder) {
  return !below(path, folder).empty();
}

void copy_inputs(const PlanHistory& history, const fs::path& folder, const fs::path& target) {
  std::set<fs::path> entries;  // the first name of each input's path below the folder
  for (const PlanStep& step : history.steps()) {
    SurgicalCase plan = *step.plan;
    for (const fs::path* input : inputs_of(plan)) {
      const fs::path found = below(*input, folder);
      if (!found.empty()) entries.insert(*found.begin());
    }
  }
  NewFolder copies(target);
  for (const fs::path& entry : entries) copy_input(folder / entry, copies.path() / entry);
  copies.publish();
}

SurgicalCase with_copied_inputs(SurgicalCase plan, const fs::path& folder, const fs::path& target) {
  for (fs::path* input : inputs_of(plan)) {
    const fs::path found = below(*input, folder);
    if (!found.empty()) *input = fs::absolute(target).lexically_normal() / found;
  }
  return plan;
}

PlanHistory with_copied_inputs(const PlanHistory& history, const fs::path& folder,
                               const fs::path& target) {
  std::vector<PlanStep> steps;
  for (const PlanStep& step : history.steps()) {
    steps.push_back({step.name, std::make_shared<const SurgicalCase>(
                                    with_copied_inputs(*step.plan, folder, target))});
  }
  return {std::move(steps), history.position()};
}

}  // namespace gnathion
