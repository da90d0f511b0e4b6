// The table of hard cases that `./run bench hard` prints, asserted row by row.
#include "bench/hard_cases.h"

#include <gtest/gtest.h>

#include <cctype>

namespace gnathion {
namespace {

const std::vector<bench::HardCase>& rows() {
  static const std::vector<bench::HardCase> all = bench::hard_cases();
  return all;
}

class Hard : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Hard, Case) {
  const bench::HardCase& row = rows()[GetParam()];
  const bench::HardOutcome outcome = bench::outcome_of(row);
  EXPECT_TRUE(outcome.held) << row.what << "\nmust: " << row.must << "\ndid:  " << outcome.did;
}

INSTANTIATE_TEST_SUITE_P(Rows, Hard, ::testing::Range<std::size_t>(0, rows().size()),
                         [](const auto& row) {
                           std::string name;
                           for (const char c : rows()[row.param].what) {
                             if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
                           }
                           return name + "_" + std::to_string(row.param);
                         });

TEST(HardCases, AreAtLeastTwentyFive) {
  EXPECT_GE(rows().size(), 25u);
}

}  // namespace
}  // namespace gnathion
