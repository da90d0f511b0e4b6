#pragma once

#include <string>
#include <variant>
#include <vector>

namespace gnathion::bench {

/// `digits` significant digits, without exponent between 1e-4 and 1e7; "–" when it is not a number.
std::string number(double value, int digits = 3);

/// A table of words and numbers that people read as Markdown and programs as CSV.
class Table {
 public:
  using Cell = std::variant<std::string, double>;

  explicit Table(std::vector<std::string> columns);
  /// Throws std::logic_error when it has not one cell a column.
  void add(std::vector<Cell> row);

  /// Numbers with three significant digits, whole ones above that in full.
  std::string markdown() const;
  /// Numbers with nine significant digits; a cell that is not a number is empty. RFC 4180.
  std::string csv() const;

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace gnathion::bench
