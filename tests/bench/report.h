#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/plot.h"
#include "bench/table.h"

namespace gnathion::bench {

/// Where the figures go: tables to the terminal as Markdown and into CSV files, plots into SVG
/// files, all in one folder.
class Report {
 public:
  /// Makes the folder. Throws std::filesystem::filesystem_error.
  explicit Report(std::filesystem::path folder);

  void heading(const std::string& text) const;
  void say(const std::string& paragraph) const;
  /// NAME.csv. Throws Error(output), as figure().
  void table(const std::string& name, const Table& table) const;
  /// NAME.svg
  void figure(const std::string& name, const std::string& title, const std::vector<Plot>& plots,
              int columns) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace gnathion::bench
