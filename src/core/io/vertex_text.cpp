#include "io/vertex_text.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <iterator>
#include <string_view>

namespace gnathion {
namespace {

constexpr std::size_t kMost = 20'000'000;  // vertices: more than any face has

bool ascends(const std::vector<int>& list) {
  return std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
}

std::optional<int> number_of(std::string_view text) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, status] = std::from_chars(text.data(), end, number);
  if (text.empty() || text[0] == '-' || status != std::errc() || rest != end) return {};
  return number;
}

/// Appends a number, or the numbers of a range; false when it is neither.
bool append_word(std::string_view word, std::vector<int>& vertices) {
  const std::size_t dash = word.find('-');
  const std::optional<int> first = number_of(word.substr(0, dash));
  const std::optional<int> last =
      dash == std::string_view::npos ? first : number_of(word.substr(dash + 1));
  if (!first || !last || *last < *first) return false;
  const auto count = static_cast<std::size_t>(*last - *first) + 1;
  if (vertices.size() + count > kMost) return false;
  for (std::size_t i = 0; i < count; ++i) vertices.push_back(*first + static_cast<int>(i));
  return true;
}

}  // namespace

std::string vertex_text(const std::vector<int>& vertices) {
  std::string text;
  for (std::size_t begin = 0, end = 0; begin < vertices.size(); begin = end) {
    end = begin + 1;
    while (end < vertices.size() && vertices[end] - 1 == vertices[end - 1]) ++end;
    if (!text.empty()) text += ' ';
    text += std::to_string(vertices[begin]);
    if (end > begin + 1) text += '-' + std::to_string(vertices[end - 1]);
  }
  return text;
}

std::optional<std::vector<int>> vertices_of_text(const std::string& text) {
  constexpr std::string_view kBlank = " \t\r\n";
  std::vector<int> vertices;
  const std::string_view all = text;
  for (std::size_t begin = all.find_first_not_of(kBlank); begin != std::string_view::npos;) {
    const std::size_t end = std::min(all.find_first_of(kBlank, begin), all.size());
    if (!append_word(all.substr(begin, end - begin), vertices)) return {};
    begin = all.find_first_not_of(kBlank, end);
  }
  return vertices;
}

std::optional<VertexChange> vertex_change(const std::vector<int>& from,
                                          const std::vector<int>& to) {
  if (!ascends(from) || !ascends(to)) return {};
  VertexChange change;
  std::set_difference(to.begin(), to.end(), from.begin(), from.end(),
                      std::back_inserter(change.added));
  std::set_difference(from.begin(), from.end(), to.begin(), to.end(),
                      std::back_inserter(change.removed));
  return change;
}

std::optional<std::vector<int>> with_change(const std::vector<int>& list,
                                            const VertexChange& change) {
  const bool ordered = ascends(list) && ascends(change.added) && ascends(change.removed);
  if (!ordered ||
      !std::includes(list.begin(), list.end(), change.removed.begin(), change.removed.end())) {
    return {};
  }
  std::vector<int> kept, result;
  std::set_difference(list.begin(), list.end(), change.removed.begin(), change.removed.end(),
                      std::back_inserter(kept));
  std::merge(kept.begin(), kept.end(), change.added.begin(), change.added.end(),
             std::back_inserter(result));
  if (!ascends(result)) return {};  // what was to be added was there already
  return result;
}

}  // namespace gnathion
