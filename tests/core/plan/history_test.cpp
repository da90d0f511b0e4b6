#include "plan/history.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace gnathion {
namespace {

SurgicalCase plan_of(double hu) {
  SurgicalCase plan;
  plan.bone.hu = hu;
  return plan;
}

TEST(PlanHistory, BeginsWithOneStepThatCannotBeUndone) {
  const PlanHistory history("Open", plan_of(1));
  EXPECT_EQ(history.steps().size(), 1u);
  EXPECT_EQ(history.steps()[0].name, "Open");
  EXPECT_EQ(history.position(), 0u);
  EXPECT_EQ(history.plan(), plan_of(1));
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.can_redo());
}

TEST(PlanHistory, UndoAndRedoGoAlongTheSteps) {
  PlanHistory history("Open", plan_of(1));
  history.push("Two", plan_of(2));
  history.push("Three", plan_of(3));
  EXPECT_EQ(history.undo_name(), "Three");
  history.undo();
  EXPECT_EQ(history.plan(), plan_of(2));
  EXPECT_EQ(history.undo_name(), "Two");
  EXPECT_EQ(history.redo_name(), "Three");
  history.undo();
  EXPECT_EQ(history.plan(), plan_of(1));
  EXPECT_FALSE(history.can_undo());
  history.redo();
  history.redo();
  EXPECT_EQ(history.plan(), plan_of(3));
  EXPECT_FALSE(history.can_redo());
}

TEST(PlanHistory, ANewStepDropsWhatCouldBeRedone) {
  PlanHistory history("Open", plan_of(1));
  history.push("Two", plan_of(2));
  history.push("Three", plan_of(3));
  history.undo();
  history.undo();
  history.push("Four", plan_of(4));
  EXPECT_FALSE(history.can_redo());
  ASSERT_EQ(history.steps().size(), 2u);
  EXPECT_EQ(history.steps()[1].name, "Four");
  EXPECT_EQ(history.undo_name(), "Four");
}

TEST(PlanHistory, AnEqualPlanMakesNoStepAndKeepsWhatCanBeRedone) {
  PlanHistory history("Open", plan_of(1));
  history.push("Two", plan_of(2));
  history.undo();
  history.push("Nothing", plan_of(1));
  EXPECT_EQ(history.position(), 0u);
  ASSERT_TRUE(history.can_redo());
  EXPECT_EQ(history.redo_name(), "Two");
}

TEST(PlanHistory, ACopyGoesItsOwnWayAndSharesThePlans) {
  PlanHistory history("Open", plan_of(1));
  history.push("Two", plan_of(2));
  PlanHistory copy = history;
  copy.undo();
  copy.push("Other", plan_of(3));
  EXPECT_EQ(history.plan(), plan_of(2));
  EXPECT_EQ(copy.steps()[0].plan, history.steps()[0].plan) << "the same object";
}

TEST(PlanHistory, StandsWhereItIsPut) {
  const auto plan = [](double hu) { return std::make_shared<const SurgicalCase>(plan_of(hu)); };
  PlanHistory history({{"a", plan(1)}, {"b", plan(2)}, {"c", plan(3)}}, 1);
  EXPECT_EQ(history.plan(), plan_of(2));
  EXPECT_EQ(history.undo_name(), "b");
  EXPECT_EQ(history.redo_name(), "c");
}

/// Two stacks and the present: what an undo list is, told in another way.
struct TwoStacks {
  std::vector<std::pair<std::string, double>> done, undone;
};

TEST(PlanHistory, DoesAsTwoStacksDoWhateverComes) {
  std::mt19937 random(4);
  for (int round = 0; round < 50; ++round) {
    PlanHistory history("Open", plan_of(0));
    TwoStacks model{{{"Open", 0}}, {}};
    for (int i = 0; i < 200; ++i) {
      const auto what = random() % 3;
      if (what == 0 && history.can_undo()) {
        history.undo();
        model.undone.push_back(model.done.back());
        model.done.pop_back();
      } else if (what == 1 && history.can_redo()) {
        history.redo();
        model.done.push_back(model.undone.back());
        model.undone.pop_back();
      } else if (what == 2) {
        const auto hu = static_cast<double>(random() % 3);
        const std::string name = "step " + std::to_string(i);
        history.push(name, plan_of(hu));
        if (hu != model.done.back().second) {
          model.done.emplace_back(name, hu);
          model.undone.clear();
        }
      }
      ASSERT_EQ(history.plan(), plan_of(model.done.back().second));
      ASSERT_EQ(history.can_undo(), model.done.size() > 1);
      ASSERT_EQ(history.can_redo(), !model.undone.empty());
      ASSERT_EQ(history.steps().size(), model.done.size() + model.undone.size());
      ASSERT_EQ(history.position() + 1, model.done.size());
      ASSERT_EQ(history.steps()[history.position()].name, model.done.back().first);
      ASSERT_EQ(history.can_undo() ? history.undo_name() : history.steps()[0].name,
                model.done.back().first);
      const std::string next = model.undone.empty() ? "" : model.undone.back().first;
      ASSERT_EQ(history.can_redo() ? history.redo_name() : "", next);
    }
  }
}

}  // namespace
}  // namespace gnathion
