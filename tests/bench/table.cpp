#include "bench/table.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace gnathion::bench {
namespace {

std::string for_reading(const Table::Cell& cell) {
  std::string text;
  if (const auto* value = std::get_if<double>(&cell)) {
    text =
        *value == std::round(*value) && std::abs(*value) < 1e9 ? number(*value, 9) : number(*value);
  } else {
    text = std::get<std::string>(cell);
  }
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return text;
}

std::string for_programs(const Table::Cell& cell) {
  if (const auto* value = std::get_if<double>(&cell)) {
    if (!std::isfinite(*value)) return {};
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", *value);
    return text;
  }
  const std::string& word = std::get<std::string>(cell);
  if (word.find_first_of(",\"\n") == std::string::npos) return word;
  std::string quoted = "\"";
  for (const char c : word) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  char text[64];
  const double size = std::abs(value);
  if (size != 0 && (size < 1e-4 || size >= std::max(1e7, std::pow(10, digits)))) {
    std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
    return text;
  }
  const int before_point = size == 0 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
  const bool is_whole = value == std::round(value);
  std::snprintf(text, sizeof text, "%.*f", is_whole ? 0 : std::max(0, digits - before_point),
                value);
  return text;
}

Table::Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}

void Table::add(std::vector<Cell> row) {
  if (row.size() != columns_.size()) throw std::logic_error("a row of another width: " + csv());
  rows_.push_back(std::move(row));
}

std::string Table::markdown() const {
  std::string text = "|";
  for (const std::string& column : columns_) text += " " + for_reading(column) + " |";
  text += "\n|";
  for (std::size_t i = 0; i < columns_.size(); ++i) text += "---|";
  for (const auto& row : rows_) {
    text += "\n|";
    for (const Cell& cell : row) text += " " + for_reading(cell) + " |";
  }
  return text + "\n";
}

std::string Table::csv() const {
  std::string text;
  const auto add_line = [&](const auto& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      text += (i == 0 ? "" : ",") + for_programs(cells[i]);
    }
    text += "\r\n";
  };
  add_line(columns_);
  for (const auto& row : rows_) add_line(row);
  return text;
}

}  // namespace gnathion::bench
