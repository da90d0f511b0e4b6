#include <csignal>
#include <exception>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "cli/verbs.h"

namespace {

gnathion::Progress* running = nullptr;

extern "C" void cancel_on_signal(int) {
  if (running != nullptr) running->cancel();
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gnathion;
  CLI::App app{
      "Gnathion predicts a face after an operation on the jaw. Research use only.\n"
      "Exit codes: 0 done, 2 command line, 3 case file, 4 input file, 5 anatomy, 6 numerics,\n"
      "7 output, 8 cancelled, 70 fault of the program."};
  app.set_version_flag("--version", GNATHION_VERSION);
  app.require_subcommand(1);
  bool quiet = false;
  app.add_flag("-q,--quiet", quiet, "do not name the stages while working");

  std::string input, output;
  unsigned seed = 1;
  bool no_pictures = false;
  const CLI::Validator not_empty(
      [](std::string& text) { return std::string(text.empty() ? "must not be empty" : ""); }, "");
  const auto verb = [&](const char* name, const char* what, const char* input_name, bool writes) {
    CLI::App* sub = app.add_subcommand(name, what);
    if (input_name != nullptr) sub->add_option(input_name, input)->required()->check(not_empty);
    if (writes) sub->add_option("OUTPUT", output, "a new folder")->required()->check(not_empty);
    return sub;
  };
  verb("series", "list the DICOM series of a folder", "FOLDER", false);
  verb("demo-case", "write the embedded default case", nullptr, true)
      ->add_option("--seed", seed, "of noise and identifiers");
  verb("check", "check a case file", "CASE", false);
  verb("surfaces", "bone and face surfaces", "CASE", true);
  verb("segment", "cut the moving bone segment", "CASE", true);
  verb("region", "choose the region of the face that may deform", "CASE", true);
  verb("mesh", "tetrahedra, and the same problem for CalculiX", "CASE", true);
  verb("predict", "all steps: predicted face, pictures, report", "CASE", true)
      ->add_flag("--no-pictures", no_pictures, "leave the pictures out");
  SettlingOptions settling;
  bool newmark = false;
  CLI::App* settle = verb("settle", "watch the tissue follow the bone in time", "CASE", true);
  settle->add_option("--density", settling.dynamics.density, "of the tissue, t/mm3");
  settle->add_option("--alpha", settling.dynamics.alpha, "damping by mass, 1/s");
  settle->add_option("--beta", settling.dynamics.beta, "damping by stiffness, s");
  settle->add_option("--step", settling.dynamics.step, "of time, s");
  settle->add_flag("--newmark", newmark, "instead of implicit Euler");
  settle->add_option("--gamma", settling.dynamics.gamma, "Newmark's, at least 0.5");
  settle->add_option("--tolerance", settling.tolerance_mm, "of what counts as settled, mm");
  settle->add_option("--most-steps", settling.most_steps, "before it is given up");
  settle->add_flag("--no-pictures", no_pictures, "leave the pictures out");
  RegisterChoices choices;
  CLI::App* place = verb("register", "put the photograph onto the skin of the CT", "CASE", true);
  place->add_flag("--from-case", choices.from_case, "begin at the case's transform");
  place->add_option("--mm-per-unit", choices.mm_per_unit, "of the photograph: 1, 10, 1000 …");
  place->add_flag("--fit-scale", choices.fit_scale, "fit the scale, too");
  place->add_option("--landmarks", choices.landmarks, "a file of pairs to begin from and judge by");
  place->add_option("--stable", choices.stable, "a file of the vertices that decide");
  place->add_flag("--accept-doubts", choices.accept_doubts, "take a doubtful registration");
  PhotographsChoices photographs;
  CLI::App* project =
      verb("photographs", "paint the CT's skin with ordinary photographs", "CASE", true);
  project->add_option("--photo", photographs.photos, "PICTURE=LANDMARKS.json, once for each")
      ->required()
      ->allow_extra_args(false);
  project->add_option("--landmarks", photographs.landmarks, "a JSON file with places on the skin");
  project->add_option("--mm-per-pixel", photographs.mm_per_pixel, "of the picture, 0.05 to 5")
      ->check(CLI::Range(0.05, 5.0));
  project
      ->add_option("--inpaint-mm", photographs.inpaint_mm, "made up beside what is seen, 0 to 100")
      ->check(CLI::Range(0.0, 100.0));
  std::string format = "obj";
  ScanRepairChoices repairs;
  CLI::App* scan = verb("scan", "look at a face scan; convert or repair it", "FILE", false);
  scan->add_option("OUTPUT", output, "a new folder")->check(not_empty);
  scan->add_option("--as", format, "obj, glb or ply")->check(CLI::IsMember({"obj", "glb", "ply"}));
  scan->add_flag("--merge-duplicates", repairs.merge_duplicates, "vertices at the same place");
  scan->add_flag("--drop-degenerate", repairs.drop_degenerate, "triangles without area");
  scan->add_flag("--drop-unreferenced", repairs.drop_unreferenced, "vertices in no triangle");
  scan->add_flag("--orient", repairs.orient, "turn triangles that face inward");
  scan->add_option("--islands-below", repairs.islands_below, "remove pieces smaller than this");
  scan->add_option("--fill-holes", repairs.fill_holes, "close borders no longer than this");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ErrorKind::usage);
  }

  if (newmark) settling.dynamics.scheme = TimeScheme::newmark;
  const auto say = [quiet](const std::string& text) {
    if (!quiet) std::cerr << text + "\n" << std::flush;
  };
  Progress progress([&](const std::string& stage) { say("… " + stage); },
                    [](const std::string& notice) { std::cerr << "notice: " + notice + "\n"; });
  running = &progress;
  std::signal(SIGINT, cancel_on_signal);
  std::signal(SIGTERM, cancel_on_signal);
  const std::string name = app.get_subcommands().front()->get_name();
  try {
    if (name == "series") list_series_verb(input, std::cout, progress);
    if (name == "demo-case") demo_case_verb(seed, output, std::cout, progress);
    if (name == "check") check_verb(input, std::cout);
    if (name == "surfaces") surfaces_verb(input, output, std::cout, progress);
    if (name == "segment") segment_verb(input, output, std::cout, progress);
    if (name == "region") region_verb(input, output, std::cout, progress);
    if (name == "mesh") mesh_verb(input, output, std::cout, progress);
    if (name == "predict") predict_verb(input, output, !no_pictures, std::cout, progress);
    if (name == "scan") {
      const auto target =
          output.empty() ? std::nullopt : std::optional<std::filesystem::path>(output);
      scan_verb(input, target, format, repairs, std::cout, progress);
    }
    if (name == "photographs") photographs_verb(input, output, photographs, std::cout, progress);
    if (name == "register") register_verb(input, output, choices, std::cout, progress);
    if (name == "settle") {
      settle_verb(input, output, settling, !no_pictures, std::cout, progress);
    }
    return 0;
  } catch (const Error& error) {
    std::cerr << "gnathion-cli: " << error.what() << '\n';
    return static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    std::cerr << "gnathion-cli: a fault of the program: " << error.what() << '\n';
    return 70;
  }
}
