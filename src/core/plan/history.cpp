#include "plan/history.h"

#include <utility>

namespace gnathion {

PlanHistory::PlanHistory(std::string name, SurgicalCase first)
    : steps_{{std::move(name), std::make_shared<const SurgicalCase>(std::move(first))}} {}

PlanHistory::PlanHistory(std::vector<PlanStep> steps, std::size_t position)
    : steps_(std::move(steps)), position_(position) {}

void PlanHistory::push(std::string name, SurgicalCase plan) {
  if (plan == this->plan()) return;
  steps_.resize(position_ + 1);
  steps_.push_back({std::move(name), std::make_shared<const SurgicalCase>(std::move(plan))});
  ++position_;
}

void PlanHistory::undo() {
  --position_;
}

void PlanHistory::redo() {
  ++position_;
}

}  // namespace gnathion
