#include "io/vertex_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace gnathion {
namespace {

using Vertices = std::vector<int>;

TEST(VertexText, IsShortForRuns) {
  EXPECT_EQ(vertex_text({}), "");
  EXPECT_EQ(vertex_text({7}), "7");
  EXPECT_EQ(vertex_text({12, 13, 14, 500}), "12-14 500");
  EXPECT_EQ(vertex_text({3, 2, 1, 1, 2}), "3 2 1 1-2");
}

TEST(VertexText, GivesEveryListBack) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    Vertices list(random() % 50);
    for (int& v : list) v = static_cast<int>(random() % 40);
    if (round % 2 == 0) std::sort(list.begin(), list.end());
    EXPECT_EQ(vertices_of_text(vertex_text(list)), list);
  }
  EXPECT_EQ(vertices_of_text("2147483646-2147483647"), (Vertices{2147483646, 2147483647}));
  EXPECT_EQ(vertices_of_text(" 3\n4\t9-10  "), (Vertices{3, 4, 9, 10}));
}

TEST(VertexText, RefusesEverythingElse) {
  for (const char* bad : {"a", "1,2", "-1", "1-", "-", "3-1", "1--2", "1-2-3", "+1", "1.5",
                          "2147483648", "0-20000000", "1 2x"}) {
    EXPECT_FALSE(vertices_of_text(bad)) << bad;
  }
}

TEST(VertexChange, LeadsFromOneListToTheOther) {
  std::mt19937 random(2);
  const auto some = [&random] {
    std::set<int> set;
    for (auto n = random() % 40; n > 0; --n) set.insert(static_cast<int>(random() % 60));
    return Vertices(set.begin(), set.end());
  };
  for (int round = 0; round < 300; ++round) {
    const Vertices from = some(), to = some();
    const auto change = vertex_change(from, to);
    ASSERT_TRUE(change);
    EXPECT_EQ(with_change(from, *change), to);
    EXPECT_LE(change->added.size(), to.size());
    EXPECT_LE(change->removed.size(), from.size());
  }
}

TEST(VertexChange, IsNoneForListsThatDoNotAscend) {
  EXPECT_FALSE(vertex_change({1, 1}, {1}));
  EXPECT_FALSE(vertex_change({1}, {3, 2}));
}

TEST(VertexChange, RefusesAListThatItDoesNotFit) {
  EXPECT_FALSE(with_change({1, 2}, {{2}, {}})) << "added twice";
  EXPECT_FALSE(with_change({1, 2}, {{}, {3}})) << "not there";
  EXPECT_FALSE(with_change({1, 2}, {{5, 4}, {}}));
  EXPECT_FALSE(with_change({2, 1}, {{5}, {}}));
  EXPECT_EQ(with_change({1, 2}, {{0, 9}, {2}}), (Vertices{0, 1, 9}));
}

}  // namespace
}  // namespace gnathion
