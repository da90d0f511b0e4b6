// Measures what docs/evidence.md shows: `./run bench`.
//   gnathion-bench FOLDER [--only PART]… [--largest TETS] [CASE.json …]
// Prints Markdown tables, and writes the same as CSV and its plots as SVG into FOLDER. Exits with 1
// when a hard case does not do what it must, or a registration fails silently.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>

#include "bench/calibration.h"
#include "bench/elements.h"
#include "bench/frames.h"
#include "bench/limits.h"
#include "bench/mesh_peers.h"
#include "bench/models.h"
#include "bench/photographs.h"
#include "bench/registration.h"
#include "bench/scaling.h"
#include "bench/scans.h"
#include "bench/targets.h"

namespace {

using namespace gnathion::bench;

struct Part {
  std::string name;
  std::function<void(const Report&)> run;
  bool is_long = false;  ///< minutes: runs only when named
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures speed, error and limits of the tissue model", "gnathion-bench");
  std::string folder;
  std::vector<std::string> only, cases;
  long largest = 1000000;
  app.add_option("folder", folder, "for tables (CSV) and plots (SVG)")->required();
  app.add_option("cases", cases, "case files: heads to mesh");
  app.add_option("--only", only,
                 "hard, targets, calibration, models, meshes, elements, registration, scans, "
                 "photographs, scaling, "
                 "frames; only when named: reference, calculix-reference")
      ->take_all();
  app.add_option("--largest", largest, "tets of the largest patch of the scaling");
  CLI11_PARSE(app, argc, argv);
  int failed = 0;
  const std::vector<Part> parts{
      {"hard", [&](const Report& report) { failed += report_hard_cases(report); }},
      {"targets", report_targets},
      {"calibration", report_calibration},
      {"models", [&](const Report& report) { report_models(report, cases); }},
      {"meshes", [&](const Report& report) { report_mesh_peers(report, cases); }},
      {"elements", [&](const Report& report) { report_elements(report); }},
      {"registration", [&](const Report& report) { failed += report_registration(report, cases); }},
      {"scans", report_scans},
      {"photographs", report_photographs},
      {"scaling", [&](const Report& report) { report_scaling(report, largest); }},
      {"frames", [&](const Report& report) { report_frames(report, cases); }},
      {"reference", [&](const Report& report) { report_reference(report, cases); }, true},
      {"calculix-reference", report_calculix_reference, true}};
  try {
    const Report report(folder);
    for (const Part& part : parts) {
      const bool named = std::find(only.begin(), only.end(), part.name) != only.end();
      if (named || (only.empty() && !part.is_long)) part.run(report);
    }
    return failed == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "gnathion-bench: " << error.what() << '\n';
    return 1;
  }
}
