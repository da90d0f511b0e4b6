#include "bench/report.h"

#include <iostream>
#include <utility>

#include "io/files.h"

namespace gnathion::bench {

Report::Report(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
}

void Report::heading(const std::string& text) const {
  std::cout << "\n### " << text << "\n\n" << std::flush;
}

void Report::say(const std::string& paragraph) const {
  std::cout << paragraph << "\n\n" << std::flush;
}

void Report::table(const std::string& name, const Table& table) const {
  std::cout << table.markdown() << '\n' << std::flush;
  write_text_file(folder_ / (name + ".csv"), table.csv());
}

void Report::figure(const std::string& name, const std::string& title,
                    const std::vector<Plot>& plots, int columns) const {
  write_text_file(folder_ / (name + ".svg"), svg(title, plots, columns));
}

}  // namespace gnathion::bench
