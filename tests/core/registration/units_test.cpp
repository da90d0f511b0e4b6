#include "registration/units.h"

#include <gtest/gtest.h>

#include "support/solids.h"

namespace gnathion {
namespace {

TEST(Units, OfAHeadInEachUnitAreProposedFirst) {
  const Points head = test::sphere({0, 0, 0}, 125, 3).vertices;  // mm
  for (const auto& [name, mm] :
       {std::pair{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"inch", 25.4}}) {
    const auto units = proposed_units(head / mm);
    EXPECT_EQ(units[0].name, name);
    EXPECT_EQ(units[0].mm_per_unit, mm);
    EXPECT_EQ(units[0].confidence == Confidence::low, units[0].name == "inch");
    EXPECT_NE(units[0].reason.find("mm along"), std::string::npos);
  }
  EXPECT_EQ(proposed_units(head)[0].confidence, Confidence::high);
}

TEST(Units, ThatCannotBeToldAreSaid) {
  const Points head = test::sphere({0, 0, 0}, 125, 3).vertices;
  const auto units = proposed_units(head / 50);  // arbitrary units, 5 across: inches or nothing
  EXPECT_EQ(units[0].confidence, Confidence::low);
  const auto none = proposed_units(head * 40);
  ASSERT_EQ(none.size(), 1U);
  EXPECT_TRUE(none[0].name.empty());
  EXPECT_EQ(none[0].confidence, Confidence::low);
  EXPECT_NEAR(none[0].mm_per_unit * 250 * 40, 260, 15);
}

TEST(Units, AreThoseThatMakeAHead) {
  const auto names = [](double size) {
    std::string text;
    for (const ProposedUnit& unit : proposed_units(test::sphere({3, 4, 5}, size / 2, 4).vertices)) {
      if (unit.confidence > Confidence::low) text += unit.name + " ";
    }
    return text;
  };
  EXPECT_EQ(names(0.25), "m ");
  EXPECT_EQ(names(24), "cm ");
  EXPECT_EQ(names(450), "mm ");
  EXPECT_EQ(names(125), "mm cm ");  // a small face, or all of a person
  EXPECT_EQ(names(8), "");          // inches are never sure
}

TEST(Units, OfAScanWithoutExtentAreNone) {
  const auto units = proposed_units(Points::Zero(3, 3));
  ASSERT_EQ(units.size(), 1U);
  EXPECT_TRUE(units[0].name.empty());
  EXPECT_EQ(units[0].mm_per_unit, 1);
}

}  // namespace
}  // namespace gnathion
