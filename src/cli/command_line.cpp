#include "cli/command_line.h"

#include <string>

#include "base/error.h"

namespace gnathion {
namespace {

const CLI::Validator& not_empty() {
  static const CLI::Validator check(
      [](std::string& text) { return std::string(text.empty() ? "must not be empty" : ""); }, "");
  return check;
}

}  // namespace

CommandLine::CommandLine()
    : app_(
          "Gnathion predicts a face after an operation on the jaw. Research use only.\n"
          "Exit codes: 0 done, 2 command line, 3 case file, 4 input file, 5 anatomy, 6 numerics,\n"
          "7 output, 8 cancelled, 70 fault of the program.") {
  app_.set_version_flag("--version", GNATHION_VERSION);
  app_.require_subcommand(1);
  app_.add_flag("-q,--quiet", quiet_, "do not name the stages while working");
  add_steps();
  add_predict();
  add_settle();
  add_register();
  add_photographs();
  add_scan();
}

std::optional<int> CommandLine::parse(int argc, char** argv) {
  try {
    app_.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app_.exit(error) == 0 ? 0 : static_cast<int>(ErrorKind::usage);
  }
  return {};
}

/// input_name: null where the verb reads nothing.
CLI::App* CommandLine::add(const char* name, const char* what, const char* input_name, bool writes,
                           const Verb& verb) {
  CLI::App* sub = app_.add_subcommand(name, what);
  if (input_name != nullptr) sub->add_option(input_name, input_)->required()->check(not_empty());
  if (writes) sub->add_option("OUTPUT", output_, "a new folder")->required()->check(not_empty());
  sub->callback([this, verb] { verb_ = verb; });
  return sub;
}

void CommandLine::add_step(const char* name, const char* what, Step* step) {
  add(name, what, "CASE", true, [this, step](std::ostream& out, Progress& progress) {
    step(input_, output_, out, progress);
  });
}

void CommandLine::add_steps() {
  add("series", "list the DICOM series of a folder", "FOLDER", false,
      [this](std::ostream& out, Progress& progress) { list_series_verb(input_, out, progress); });
  add("demo-case", "write the embedded default case", nullptr, true,
      [this](std::ostream& out, Progress& progress) {
        demo_case_verb(seed_, output_, out, progress);
      })
      ->add_option("--seed", seed_, "of noise and identifiers");
  add("check", "check a case file", "CASE", false,
      [this](std::ostream& out, Progress&) { check_verb(input_, out); });
  add_step("surfaces", "bone and face surfaces", surfaces_verb);
  add_step("segment", "cut the moving bone segment", segment_verb);
  add_step("region", "choose the region of the face that may deform", region_verb);
  add_step("mesh", "tetrahedra, and the same problem for CalculiX", mesh_verb);
}

void CommandLine::add_predict() {
  add("predict", "all steps: predicted face, pictures, report", "CASE", true,
      [this](std::ostream& out, Progress& progress) {
        predict_verb(input_, output_, !no_pictures_, out, progress);
      })
      ->add_flag("--no-pictures", no_pictures_, "leave the pictures out");
}

void CommandLine::add_settle() {
  CLI::App* settle = add("settle", "watch the tissue follow the bone in time", "CASE", true,
                         [this](std::ostream& out, Progress& progress) {
                           SettlingOptions options = settling_;
                           if (newmark_) options.dynamics.scheme = TimeScheme::newmark;
                           settle_verb(input_, output_, options, !no_pictures_, out, progress);
                         });
  settle->add_option("--density", settling_.dynamics.density, "of the tissue, t/mm3");
  settle->add_option("--alpha", settling_.dynamics.alpha, "damping by mass, 1/s");
  settle->add_option("--beta", settling_.dynamics.beta, "damping by stiffness, s");
  settle->add_option("--step", settling_.dynamics.step, "of time, s");
  settle->add_flag("--newmark", newmark_, "instead of implicit Euler");
  settle->add_option("--gamma", settling_.dynamics.gamma, "Newmark's, at least 0.5");
  settle->add_option("--tolerance", settling_.tolerance_mm, "of what counts as settled, mm");
  settle->add_option("--most-steps", settling_.most_steps, "before it is given up");
  settle->add_flag("--no-pictures", no_pictures_, "leave the pictures out");
}

void CommandLine::add_register() {
  CLI::App* place = add("register", "put the photograph onto the skin of the CT", "CASE", true,
                        [this](std::ostream& out, Progress& progress) {
                          register_verb(input_, output_, registering_, out, progress);
                        });
  RegisterChoices& choices = registering_;
  place->add_flag("--from-case", choices.from_case, "begin at the case's transform");
  place->add_option("--mm-per-unit", choices.mm_per_unit, "of the photograph: 1, 10, 1000 …");
  place->add_flag("--fit-scale", choices.fit_scale, "fit the scale, too");
  place->add_option("--landmarks", choices.landmarks, "a file of pairs to begin from and judge by");
  place->add_option("--stable", choices.stable, "a file of the vertices that decide");
  place->add_flag("--accept-doubts", choices.accept_doubts, "take a doubtful registration");
}

void CommandLine::add_photographs() {
  CLI::App* project = add("photographs", "paint the CT's skin with ordinary photographs", "CASE",
                          true, [this](std::ostream& out, Progress& progress) {
                            photographs_verb(input_, output_, photographs_, out, progress);
                          });
  project->add_option("--photo", photographs_.photos, "PICTURE=LANDMARKS.json, once for each")
      ->required()
      ->allow_extra_args(false);
  project->add_option("--landmarks", photographs_.landmarks, "a JSON file with places on the skin");
  project->add_option("--mm-per-pixel", photographs_.mm_per_pixel, "of the picture, 0.05 to 5")
      ->check(CLI::Range(0.05, 5.0));
  project
      ->add_option("--inpaint-mm", photographs_.inpaint_mm, "made up beside what is seen, 0 to 100")
      ->check(CLI::Range(0.0, 100.0));
}

void CommandLine::add_scan() {
  CLI::App* scan = add("scan", "look at a face scan; convert or repair it", "FILE", false,
                       [this](std::ostream& out, Progress& progress) {
                         const auto target = output_.empty()
                                                 ? std::nullopt
                                                 : std::optional<std::filesystem::path>(output_);
                         scan_verb(input_, target, scan_format_, repairs_, out, progress);
                       });
  scan->add_option("OUTPUT", output_, "a new folder")->check(not_empty());
  scan->add_option("--as", scan_format_, "obj, glb or ply")
      ->check(CLI::IsMember({"obj", "glb", "ply"}));
  scan->add_flag("--merge-duplicates", repairs_.merge_duplicates, "vertices at the same place");
  scan->add_flag("--drop-degenerate", repairs_.drop_degenerate, "triangles without area");
  scan->add_flag("--drop-unreferenced", repairs_.drop_unreferenced, "vertices in no triangle");
  scan->add_flag("--orient", repairs_.orient, "turn triangles that face inward");
  scan->add_option("--islands-below", repairs_.islands_below, "remove pieces smaller than this");
  scan->add_option("--fill-holes", repairs_.fill_holes, "close borders no longer than this");
}

}  // namespace gnathion
