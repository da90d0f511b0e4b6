#pragma once

#include <memory>
#include <string>
#include <vector>

#include "plan/surgical_case.h"

namespace gnathion {

/// One state of the plan and what led to it.
struct PlanStep {
  std::string name;  ///< what was done, for "Undo …": "Cut the chin"
  std::shared_ptr<const SurgicalCase> plan;
};

/// All states of a plan, the oldest first, and where one stands in them: undo and redo without
/// limit. Plans are small beside what is computed from them, so that each step holds a whole one.
class PlanHistory {
 public:
  /// `name`: of the first step: "Open", "Import".
  PlanHistory(std::string name, SurgicalCase first);
  /// \pre steps is not empty, no plan is null, position < steps.size().
  PlanHistory(std::vector<PlanStep> steps, std::size_t position);

  const SurgicalCase& plan() const { return *steps_[position_].plan; }
  const std::vector<PlanStep>& steps() const { return steps_; }
  std::size_t position() const { return position_; }
  bool can_undo() const { return position_ > 0; }
  bool can_redo() const { return position_ + 1 < steps_.size(); }
  const std::string& undo_name() const { return steps_[position_].name; }      ///< \pre can_undo()
  const std::string& redo_name() const { return steps_[position_ + 1].name; }  ///< \pre can_redo()

  /// A new step after the present one; what could be redone is gone. A plan equal to the present
  /// one makes no step.
  void push(std::string name, SurgicalCase plan);
  void undo();  ///< \pre can_undo()
  void redo();  ///< \pre can_redo()

 private:
  std::vector<PlanStep> steps_;
  std::size_t position_ = 0;
};

}  // namespace gnathion
