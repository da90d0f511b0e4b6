#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gnathion {

/// Vertex numbers as a short text: "12-480 500 499". A range counts up by one; order and
/// repetitions are kept. An empty list is an empty text. vertices: from 0.
std::string vertex_text(const std::vector<int>& vertices);

/// The numbers of such a text, separated by blanks. None when it is anything else: a sign, a range
/// that counts down, a number above 2³¹ − 1, more than 20 million numbers.
std::optional<std::vector<int>> vertices_of_text(const std::string& text);

/// How one list of vertices differs from another. Both ascend.
struct VertexChange {
  std::vector<int> added, removed;
};

/// None when one of the lists does not ascend strictly, so that a change could not tell its order.
std::optional<VertexChange> vertex_change(const std::vector<int>& from, const std::vector<int>& to);

/// The list after the change. None when the change does not fit: a vertex to remove that is not
/// there, one to add that is, or a list that does not ascend strictly.
std::optional<std::vector<int>> with_change(const std::vector<int>& list,
                                            const VertexChange& change);

}  // namespace gnathion
