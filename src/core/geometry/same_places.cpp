#include "geometry/same_places.h"

#include <bit>
#include <cstdint>

namespace gnathion {
namespace {

std::uint64_t mixed(std::uint64_t hash, double x) {
  // + 0.0 makes −0 the 0 it compares equal to. The multiplier is that of Knuth's LCG.
  hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 6364136223846793005ULL;
  return hash ^ (hash >> 29U);
}

}  // namespace

std::vector<int> first_at_same_place(const Points& points) {
  const auto count = static_cast<std::size_t>(points.rows());
  const std::size_t mask = std::bit_ceil(2 * count + 1) - 1;
  std::vector<int> slots(mask + 1, -1), first(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    std::size_t slot =
        mixed(mixed(mixed(0, points(row, 0)), points(row, 1)), points(row, 2)) & mask;
    while (slots[slot] >= 0 && points.row(slots[slot]) != points.row(row)) slot = (slot + 1) & mask;
    if (slots[slot] < 0) slots[slot] = static_cast<int>(i);
    first[i] = slots[slot];
  }
  return first;
}

}  // namespace gnathion
