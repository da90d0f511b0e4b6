#include <fcntl.h>
#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/photo_scene.h"
#include "support/scan_scene.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using nlohmann::json;
using test::bytes_of;

struct CliRun {
  int code = -1;
  std::string out, err;
};

std::string read_all(int descriptor, const std::function<void(const std::string&)>& heard) {
  std::string text;
  std::array<char, 4096> block;
  for (ssize_t size = 0; (size = read(descriptor, block.data(), block.size())) > 0;) {
    text.append(block.data(), static_cast<std::size_t>(size));
    heard(text);
  }
  close(descriptor);
  return text;
}

/// Runs gnathion-cli in `folder` without a display. `heard` is told its process and what it has
/// said so far on stderr.
CliRun run_cli(const fs::path& folder, std::vector<std::string> arguments,
               const std::function<void(pid_t, const std::string&)>& heard = {}) {
  arguments.insert(arguments.begin(), GNATHION_CLI);
  std::vector<char*> raw;
  for (std::string& argument : arguments) raw.push_back(argument.data());
  raw.push_back(nullptr);
  const fs::path out = folder / ".stdout";
  std::array<int, 2> err{};
  if (pipe(err.data()) != 0) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    dup2(open(out.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(err[1], STDERR_FILENO);
    close(err[0]);
    if (chdir(folder.c_str()) == 0) execv(raw[0], raw.data());
    _exit(127);
  }
  close(err[1]);
  CliRun run;
  run.err = read_all(err[0], [&](const std::string& text) {
    if (heard) heard(child, text);
  });
  int status = 0;
  waitpid(child, &status, 0);
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  run.out = bytes_of(out);
  fs::remove(out);
  return run;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Rows of the `v` lines.
std::vector<Vector3d> vertices_of(const fs::path& obj) {
  std::vector<Vector3d> vertices;
  std::istringstream lines(bytes_of(obj));
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("v ", 0) != 0) continue;
    std::istringstream numbers(line.substr(2));
    Vector3d v;
    numbers >> v[0] >> v[1] >> v[2];
    vertices.push_back(v);
  }
  return vertices;
}

std::string without_vertex_lines(const fs::path& obj) {
  std::string rest;
  std::istringstream lines(bytes_of(obj));
  for (std::string line; std::getline(lines, line);)
    rest += line.rfind("v ", 0) == 0 ? "v\n" : line + "\n";
  return rest;
}

Vector3d vector_of(const json& array) {
  return {array[0].get<double>(), array[1].get<double>(), array[2].get<double>()};
}

/// The demo case, made and predicted once by the program itself, in a folder whose name has blanks
/// and accents.
class Cli : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    temporary_ = std::make_unique<test::TemporaryFolder>();
    fs::create_directory(folder());
    demo_run_ = run_cli(folder(), {"demo-case", "demo"});
    predict_run_ = run_cli(folder(), {"predict", "demo/case.json", "out"});
  }
  static void TearDownTestSuite() { temporary_.reset(); }

  static fs::path folder() { return temporary_->path() / "Fälle von heute"; }
  static fs::path demo() { return folder() / "demo"; }

  /// The demo case with some change, as a case file beside it.
  static std::string changed_case(const std::string& name,
                                  const std::function<void(json&)>& change) {
    json plan = json::parse(bytes_of(demo() / "case.json"));
    change(plan);
    temporary_->write("Fälle von heute/demo/" + name, plan.dump(2));
    return "demo/" + name;
  }

  /// Runs a verb that must fail with this code and one line that names `parts`, and leave nothing.
  static void expect_failure(int code, const std::vector<std::string>& parts,
                             const std::vector<std::string>& arguments) {
    const std::vector<std::string> before = names_in(folder());
    std::vector<std::string> quiet = arguments;
    quiet.insert(quiet.begin(), "-q");
    const CliRun run = run_cli(folder(), quiet);
    EXPECT_EQ(run.code, code) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(run.err.rfind("gnathion-cli: ", 0), 0U) << run.err;
    EXPECT_NE(run.err.find("; "), std::string::npos) << "no remedy in: " << run.err;
    for (const std::string& part : parts) {
      EXPECT_NE(run.err.find(part), std::string::npos) << "no \"" << part << "\" in: " << run.err;
    }
    EXPECT_EQ(run.err.find("SYNTHETIC"), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(names_in(folder()), before) << "something was left behind";
  }

  static inline std::unique_ptr<test::TemporaryFolder> temporary_;
  static inline CliRun demo_run_, predict_run_;
};

TEST_F(Cli, DemoCaseWritesACaseThatIsWellFormed) {
  EXPECT_EQ(demo_run_.code, 0) << demo_run_.err;
  EXPECT_EQ(names_in(demo()).size(), 4U);
  const CliRun check = run_cli(folder(), {"check", "demo/case.json"});
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_NE(check.out.find("well formed"), std::string::npos);
}

TEST_F(Cli, PredictWritesFacePicturesAndReportWithoutADisplay) {
  ASSERT_EQ(predict_run_.code, 0) << predict_run_.err;
  const std::vector<std::string> names = names_in(folder() / "out");
  for (const char* name : {"predicted.obj", "face.mtl", "face.png", "report.json", "tissue.vtu",
                           "before.png", "after.png", "colour_map.png"}) {
    EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name)) << name;
    EXPECT_NE(predict_run_.out.find(name), std::string::npos) << name << " is not told";
  }
  for (const char* name : {"before.png", "after.png", "colour_map.png"}) {
    const std::string picture = bytes_of(folder() / "out" / name);
    EXPECT_EQ(picture.substr(1, 3), "PNG") << name;
    EXPECT_GT(picture.size(), 5000U) << name;
  }
  EXPECT_NE(bytes_of(folder() / "out/before.png"), bytes_of(folder() / "out/after.png"));
}

TEST_F(Cli, PredictChangesNothingButTheVerticesCoordinates) {
  const fs::path photograph = demo() / "photograph", out = folder() / "out";
  EXPECT_EQ(without_vertex_lines(out / "predicted.obj"),
            without_vertex_lines(photograph / "face.obj"));
  EXPECT_NE(bytes_of(out / "predicted.obj"), bytes_of(photograph / "face.obj"));
  EXPECT_EQ(bytes_of(out / "face.png"), bytes_of(photograph / "face.png"));
  EXPECT_EQ(bytes_of(out / "face.mtl"), bytes_of(photograph / "face.mtl"));
}

TEST_F(Cli, ReportHoldsWhatWasMeasured) {
  const json report = json::parse(bytes_of(folder() / "out/report.json"));
  EXPECT_LT(report.at("relative_residual").get<double>(), 1e-8);
  EXPECT_LT(report.at("basis_against_direct_solve").get<double>(), 1e-12);
  EXPECT_EQ(report.at("element_quality").at("inverted"), 0);
  EXPECT_GT(report.at("sizes").at("tets").get<int>(), 10000);
  EXPECT_EQ(report.at("inputs").at("ct_sha256").get<std::string>().size(), 64U);
  EXPECT_EQ(report.at("inputs").at("photograph_sha256").size(), 3U);
  const double chin = report.at("landmarks").at("pogonion_soft").at("ratio_to_bone");
  const double lip = report.at("landmarks").at("upper_lip").at("ratio_to_bone");
  EXPECT_GT(chin, 0.8);
  EXPECT_LT(chin, 1.1);
  EXPECT_LT(lip, 0.5 * chin);
  for (const char* key : {"program", "seconds", "peak_memory_MiB", "displacement_mm", "segments",
                          "estimated_error_mm"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
}

TEST_F(Cli, ThePatientsNameIsInNoOutput) {
  const std::string name = "GNATHION^SYNTHETIC";
  const fs::path slice = demo() / "ct" / names_in(demo() / "ct").front();
  ASSERT_NE(bytes_of(slice).find(name), std::string::npos) << "the CT has another name";
  for (const auto& entry : fs::recursive_directory_iterator(folder() / "out")) {
    EXPECT_EQ(bytes_of(entry.path()).find(name), std::string::npos) << entry.path();
  }
  const CliRun series = run_cli(folder(), {"series", "demo/ct"});
  EXPECT_EQ(series.code, 0);
  for (const std::string& text :
       {predict_run_.out, predict_run_.err, demo_run_.out, demo_run_.err, series.out, series.err}) {
    EXPECT_EQ(text.find(name), std::string::npos) << text;
  }
}

TEST_F(Cli, SeriesListsWhatIsThere) {
  const CliRun series = run_cli(folder(), {"-q", "series", "demo/ct"});
  EXPECT_EQ(series.code, 0);
  EXPECT_NE(series.out.find("  CT  " + std::to_string(names_in(demo() / "ct").size()) + " slices"),
            std::string::npos)
      << series.out;
}

TEST_F(Cli, TheSameInputsGiveTheSameFace) {
  const CliRun again =
      run_cli(folder(), {"-q", "predict", "--no-pictures", "demo/case.json", "again"});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.err, "");
  EXPECT_EQ(bytes_of(folder() / "again/predicted.obj"), bytes_of(folder() / "out/predicted.obj"));
  EXPECT_EQ(bytes_of(folder() / "again/tissue.vtu"), bytes_of(folder() / "out/tissue.vtu"));
  EXPECT_FALSE(fs::exists(folder() / "again/after.png"));
}

TEST_F(Cli, ZeroMotionGivesThePhotographBackToTheByte) {
  const std::string plan = changed_case("still.json", [](json& c) {
    c["motion"] = {{"forward_mm", 0}};
  });
  const CliRun run = run_cli(folder(), {"predict", "--no-pictures", plan, "still"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(bytes_of(folder() / "still/predicted.obj"), bytes_of(demo() / "photograph/face.obj"));
}

TEST_F(Cli, LeftIsThePatientsLeftFromDicomToExport) {
  const std::string plan = changed_case("left.json", [](json& c) {
    c["motion"] = {{"left_mm", 5}};
  });
  const CliRun run = run_cli(folder(), {"predict", "--no-pictures", plan, "left"});
  ASSERT_EQ(run.code, 0) << run.err;
  const std::vector<Vector3d> before = vertices_of(demo() / "photograph/face.obj"),
                              after = vertices_of(folder() / "left/predicted.obj");
  ASSERT_EQ(after.size(), before.size());
  // The mole is painted on the left cheek: in the photograph's own frame the face must move to its
  // side, away from the right corner of the mouth.
  const json truth = json::parse(bytes_of(demo() / "truth.json"));
  const json transform = json::parse(bytes_of(demo() / "case.json"))["photograph"]["transform"];
  Eigen::Matrix3d R;
  for (int row = 0; row < 3; ++row) {
    R.row(row) = vector_of(transform["rotation"][static_cast<std::size_t>(row)]).transpose();
  }
  const auto in_photograph = [&](const char* landmark) {
    const Vector3d lps = vector_of(truth.at("landmarks").at(landmark));
    return Vector3d(R.transpose() * (lps - vector_of(transform["translation_mm"])) /
                    transform["scale"].get<double>());
  };
  const Vector3d chin = in_photograph("pogonion_soft");
  const Vector3d to_mole = in_photograph("mole") - in_photograph("mouth_corner_right");
  Vector3d moved = Vector3d::Zero();
  int count = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    if ((before[v] - chin).norm() > 8) continue;
    moved += after[v] - before[v];
    ++count;
  }
  ASSERT_GT(count, 10);
  moved /= count;
  EXPECT_GT(moved.dot(to_mole.normalized()), 1.5) << moved.transpose();
  EXPECT_GT((R * moved).x(), 2.5) << "LPS x is the patient's left";
}

TEST_F(Cli, EachStepHasItsVerb) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> verbs{
      {"surfaces", {"bone.ply", "face.mtl", "face.obj", "face.png"}},
      {"segment", {"remainder.ply", "segment.ply"}},
      {"region", {"region.ply", "region.txt"}},
      {"mesh", {"tissue.inp", "tissue.vtu"}}};
  for (const auto& [verb, files] : verbs) {
    const CliRun run = run_cli(folder(), {"-q", verb, "demo/case.json", verb});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(names_in(folder() / verb), files);
  }
  EXPECT_EQ(bytes_of(folder() / "surfaces/face.obj"), bytes_of(demo() / "photograph/face.obj"));
  // A region that was written can be given back.
  fs::copy_file(folder() / "region/region.txt", demo() / "region.txt");
  const std::string plan = changed_case("region.json", [](json& c) {
    c["region"] = {{"vertices_file", "region.txt"}};
  });
  const CliRun run = run_cli(folder(), {"-q", "region", plan, "region again"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(bytes_of(folder() / "region again/region.ply"),
            bytes_of(folder() / "region/region.ply"));
}

TEST_F(Cli, ScanLooksAtAFaceScanAndConvertsIt) {
  const CliRun look = run_cli(folder(), {"-q", "scan", "demo/photograph/face.obj"});
  ASSERT_EQ(look.code, 0) << look.err;
  for (const char* words :
       {"12179 vertices", "unit: surely mm", "left +x, back -z, up +y", "1 border"}) {
    EXPECT_NE(look.out.find(words), std::string::npos) << look.out;
  }
  const CliRun write = run_cli(folder(), {"-q", "scan", "demo/photograph/face.obj", "demo/als GLB",
                                          "--as", "glb", "--orient"});
  ASSERT_EQ(write.code, 0) << write.err;
  EXPECT_NE(write.out.find("repaired: 0 triangles turned"), std::string::npos) << write.out;
  // A case takes the GLB as it took the OBJ: the same face, in single precision.
  const std::string plan =
      changed_case("glb.json", [](json& c) { c["photograph"]["obj"] = "als GLB/face.glb"; });
  const CliRun run = run_cli(folder(), {"-q", "surfaces", plan, "of glb"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(names_in(folder() / "of glb"),
            (std::vector<std::string>{"bone.ply", "face.mtl", "face.obj", "face_0.png"}));
  EXPECT_EQ(bytes_of(folder() / "of glb/face_0.png"), bytes_of(demo() / "photograph/face.png"));
  const CliRun bad = run_cli(folder(), {"-q", "scan", "demo/case.json"});
  EXPECT_EQ(bad.code, 4) << bad.err;
}

TEST_F(Cli, SettleFollowsTheTissueInTime) {
  const CliRun run = run_cli(folder(), {"-q", "settle", "demo/case.json", "settled"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out.rfind("settled to 0.01 mm", 0), 0U) << run.out;
  const std::vector<std::string> names = names_in(folder() / "settled");
  EXPECT_EQ(names.front(), "frame_00000.png");
  EXPECT_EQ(names.back(), "settling.csv");
  EXPECT_GT(names.size(), 5U);
  EXPECT_LE(names.size(), 26U);
  EXPECT_NE(bytes_of(folder() / "settled" / names.front()),
            bytes_of(folder() / "settled" / names[names.size() - 2]));
  std::istringstream csv(bytes_of(folder() / "settled/settling.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "time_s,mean_mm,max_mm,energy_Nmm");
  std::vector<std::array<double, 4>> rows;
  while (std::getline(csv, line)) {
    std::array<double, 4>& row = rows.emplace_back();
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &row[0], &row[1], &row[2], &row[3]), 4);
  }
  EXPECT_EQ(rows.front()[0], 0);
  EXPECT_NEAR(rows.front()[2], 6, 0.5);  // the whole motion is still to come
  EXPECT_LE(rows.back()[2], 0.01);
  EXPECT_LT(rows.back()[3], rows.front()[3]);

  const CliRun given_up = run_cli(folder(), {"-q", "settle", "demo/case.json", "short", "--newmark",
                                             "--step", "0.001", "--most-steps", "40"});
  ASSERT_EQ(given_up.code, 0) << given_up.err;
  EXPECT_NE(given_up.out.find("not settled"), std::string::npos) << given_up.out;
  EXPECT_EQ(names_in(folder() / "short").size(), 22U);  // of 41 times every 2nd; csv
  EXPECT_NE(given_up.out.find("40 steps, 40 ms"), std::string::npos) << given_up.out;
  expect_failure(3, {"dynamics.step"}, {"settle", "demo/case.json", "x", "--step", "0"});
}

TEST_F(Cli, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(run_cli(folder(), {"--help"}).code, 0);
  EXPECT_EQ(run_cli(folder(), {"predict", "--help"}).code, 0);
  EXPECT_EQ(run_cli(folder(), {"--version"}).code, 0);
}

TEST_F(Cli, AWrongCommandLineIsCode2) {
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{},
                                                {"guess"},
                                                {"predict"},
                                                {"predict", "demo/case.json"},
                                                {"predict", "demo/case.json", "x", "--fast"},
                                                {"demo-case", "x", "--seed", "two"},
                                                {"predict", "", "x"},
                                                {"predict", "demo/case.json", ""}}) {
    EXPECT_EQ(run_cli(folder(), wrong).code, 2);
  }
  EXPECT_FALSE(fs::exists(folder() / "x"));
}

TEST_F(Cli, AWrongCaseFileIsCode3) {
  const auto refused = [](const std::string& key, const std::function<void(json&)>& change) {
    expect_failure(3, {"wrong.json: " + key}, {"predict", changed_case("wrong.json", change), "x"});
  };
  refused("motion.forward", [](json& c) { c["motion"]["forward"] = 8; });
  refused("motion.forward_mm", [](json& c) { c["motion"]["forward_mm"] = "8"; });
  refused("tissue.poisson", [](json& c) { c["tissue"]["poisson"] = 0.5; });
  refused("tissue.young_MPa", [](json& c) { c["tissue"]["young_MPa"] = 0; });
  temporary_->write("Fälle von heute/demo/wrong.json", "{ \"ct\": ");
  expect_failure(3, {"wrong.json", "line 1"}, {"check", "demo/wrong.json"});
}

TEST_F(Cli, ACaseWithoutSegmentsIsCheckedAndShownButMovesNothing) {
  const std::string plan = changed_case("uncut.json", [](json& c) {
    c.erase("segment");
    c.erase("motion");
  });
  const CliRun check = run_cli(folder(), {"check", plan});
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_NE(check.out.find("no segment yet"), std::string::npos);
  EXPECT_EQ(run_cli(folder(), {"surfaces", plan, "uncut surfaces"}).code, 0);
  for (const char* verb : {"segment", "region", "mesh", "predict", "settle"}) {
    expect_failure(3, {"uncut.json: segments", "no segment"}, {verb, plan, "x"});
  }
}

TEST_F(Cli, CheckReadsTheHistoryToo) {
  const auto with_step = [](const char* hu) {
    return changed_case("steps.json", [hu](json& c) {
      c["history"] = {{"position", 1},
                      {"steps",
                       {{{"name", "Import"}, {"changes", {{"bone", {{"hu", json::parse(hu)}}}}}},
                        {{"name", "Set the level"}}}}};
    });
  };
  const CliRun check = run_cli(folder(), {"check", with_step("300")});
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_NE(check.out.find("step 2 of 2: Set the level"), std::string::npos) << check.out;
  expect_failure(3, {"steps.json: history.steps[0].changes.bone.hu"},
                 {"check", with_step("\"high\"")});
}

TEST_F(Cli, ForceTransferRefusesARotationNamingTheKey) {
  const std::string plan = changed_case("force.json", [](json& c) {
    c["tissue"]["load"] = "force";
    c["motion"] = {{"pitch_deg", 3}};
  });
  expect_failure(3, {"tissue.load"}, {"predict", "--no-pictures", plan, "x"});
}

TEST_F(Cli, AMissingOrUselessInputIsCode4) {
  const auto with_ct = [](const std::string& path) {
    return changed_case("input.json", [&](json& c) { c["ct"]["path"] = path; });
  };
  expect_failure(4, {"none.json"}, {"predict", "none.json", "x"});
  expect_failure(4, {"none"}, {"predict", with_ct("none"), "x"});
  fs::create_directory(demo() / "empty");
  expect_failure(4, {"empty"}, {"predict", with_ct("empty"), "x"});
  temporary_->write("Fälle von heute/demo/letters/a.txt", "no picture");
  expect_failure(4, {"letters", "CT"}, {"predict", with_ct("letters"), "x"});
  temporary_->write("Fälle von heute/demo/letters.nrrd", "no picture");
  expect_failure(4, {"letters.nrrd"}, {"predict", with_ct("letters.nrrd"), "x"});
  expect_failure(
      4, {"none.obj"},
      {"predict", changed_case("input.json", [](json& c) { c["photograph"]["obj"] = "none.obj"; }),
       "x"});
  fs::create_directory(demo() / "bare");
  fs::copy_file(demo() / "photograph/face.obj", demo() / "bare/face.obj");
  fs::copy_file(demo() / "photograph/face.mtl", demo() / "bare/face.mtl");
  expect_failure(
      4, {"face.png"},
      {"predict",
       changed_case("input.json", [](json& c) { c["photograph"]["obj"] = "bare/face.obj"; }), "x"});
  expect_failure(4, {"none"}, {"series", "none"});
  expect_failure(
      4, {"face.obj", "photograph.transform.scale"},
      {"predict",
       changed_case("input.json", [](json& c) { c["photograph"]["transform"]["scale"] = 0.001; }),
       "x"});
}

TEST_F(Cli, AMissingSliceIsCode4) {
  fs::copy(demo() / "ct", demo() / "gap");
  const std::vector<std::string> slices = names_in(demo() / "gap");
  fs::remove(demo() / "gap" / slices[slices.size() / 2]);
  const std::string plan = changed_case("gap.json", [](json& c) { c["ct"]["path"] = "gap"; });
  expect_failure(4, {"gap"}, {"predict", plan, "x"});
}

TEST_F(Cli, ABrokenPhotographIsCode4) {
  const std::string text = bytes_of(demo() / "photograph/face.obj");
  const auto with_obj = [&](const std::string& changed) {
    temporary_->write("Fälle von heute/demo/photograph/broken.obj", changed);
    return changed_case("broken.json",
                        [](json& c) { c["photograph"]["obj"] = "photograph/broken.obj"; });
  };
  expect_failure(4, {"broken.obj", "names vertex"},
                 {"predict", with_obj(text + "f 1 2 999999\n"), "x"});
  expect_failure(4, {"broken.obj", "not a finite number"},
                 {"predict", with_obj("v nan 0 0\n" + text), "x"});
  expect_failure(4, {"broken.obj", "no faces"},
                 {"predict", with_obj(text.substr(0, text.find("\nf ")) + "\n"), "x"});
}

TEST_F(Cli, TwoSeriesOrACutOffSliceIsCode4) {
  ASSERT_EQ(run_cli(folder(), {"-q", "demo-case", "--seed", "2", "second"}).code, 0);
  fs::copy(demo() / "ct", demo() / "both");
  for (const std::string& slice : names_in(folder() / "second/ct")) {
    fs::copy_file(folder() / "second/ct" / slice, demo() / "both" / ("second_" + slice));
  }
  const std::string both = changed_case("both.json", [](json& c) { c["ct"]["path"] = "both"; });
  expect_failure(4, {"both", "series"}, {"predict", both, "x"});

  fs::copy(demo() / "ct", demo() / "cut");
  const std::string slice = names_in(demo() / "cut")[20];
  fs::resize_file(demo() / "cut" / slice, fs::file_size(demo() / "cut" / slice) / 2);
  const std::string cut = changed_case("cut.json", [](json& c) { c["ct"]["path"] = "cut"; });
  expect_failure(4, {slice}, {"predict", cut, "x"});
  fs::remove_all(folder() / "second");
}

TEST_F(Cli, ARegionInPiecesIsCode5) {
  std::string vertices;  // two patches of neighbouring rows, far apart
  const std::size_t count = vertices_of(demo() / "photograph/face.obj").size();
  for (std::size_t v = 0; v < count; ++v) {
    if (v < count / 5 || v > count * 4 / 5) vertices += std::to_string(v) + "\n";
  }
  temporary_->write("Fälle von heute/demo/pieces.txt", vertices);
  const std::string plan = changed_case("pieces.json", [](json& c) {
    c["region"] = {{"vertices_file", "pieces.txt"}};
  });
  expect_failure(5, {"region", "pieces"}, {"predict", plan, "x"});
}

TEST_F(Cli, TheCasesOnRealDataPredict) {
  const fs::path shared = GNATHION_SHARED_DATA;
  if (!fs::exists(shared / "ct-head-phantom")) GTEST_SKIP() << "the real CT is not at hand";
  const fs::path place = folder() / "real";
  fs::create_directory(place);
  const std::string unpack = "tar -xJf '" +
                             (shared / "ct-head-phantom/dicom_head_135slices.tar.xz").string() +
                             "' -C '" + place.string() + "'";
  ASSERT_EQ(std::system(unpack.c_str()), 0);
  // The scan's chin is not that of the CT: little of its tissue reaches the bone.
  const std::map<std::string, double> chins{{"ct-head-phantom", 0.98}, {"face-scan-on-ct", 0.85}};
  for (const auto& [name, chin] : chins) {
    json plan = json::parse(bytes_of(fs::path(GNATHION_TESTS_FOLDER) / "cases" / (name + ".json")));
    if (plan.contains("photograph")) {
      plan["photograph"]["obj"] = (shared / "face-scan/LeePerrySmith.obj").string();
    }
    temporary_->write("Fälle von heute/real/" + name + ".json", plan.dump());
    const CliRun run =
        run_cli(folder(), {"-q", "predict", "--no-pictures", "real/" + name + ".json", name});
    ASSERT_EQ(run.code, 0) << run.err;
    const json report = json::parse(bytes_of(folder() / name / "report.json"));
    EXPECT_EQ(report["element_quality"]["inverted"], 0);
    EXPECT_EQ(report["tets_inverted_by_the_motion"], 0);
    EXPECT_LT(report["relative_residual"].get<double>(), 1e-12);
    EXPECT_NEAR(report["landmarks"]["pogonion"]["ratio_to_bone"].get<double>(), chin, 0.03);
    EXPECT_LT(report["landmarks"]["nose_tip"]["ratio_to_bone"].get<double>(), 0.05);
    EXPECT_NEAR(report["segments"][0]["volume_mm3"].get<double>(), 62800, 500);
    fs::remove_all(folder() / name);
  }
  fs::remove_all(place);
}

TEST_F(Cli, APlanThatTheAnatomyDoesNotAllowIsCode5) {
  const std::string air = changed_case("air.json", [](json& c) {
    c["segment"]["box"] = {{"min", {-300, -300, 200}}, {"max", {-290, -290, 210}}};
  });
  expect_failure(5, {"segment"}, {"predict", air, "x"});

  // A region on the forehead, far from the segment.
  const json truth = json::parse(bytes_of(demo() / "case.json"))["photograph"]["transform"];
  Vector3d up;  // the patient's z in the photograph's frame
  for (std::size_t k = 0; k < 3; ++k)
    up[static_cast<int>(k)] = truth["rotation"][2][k].get<double>();
  const std::vector<Vector3d> face = vertices_of(demo() / "photograph/face.obj");
  double top = -1e9;
  for (const Vector3d& v : face) top = std::max(top, v.dot(up));
  std::string forehead;
  for (std::size_t v = 0; v < face.size(); ++v) {
    if (face[v].dot(up) > top - 30) forehead += std::to_string(v) + "\n";
  }
  temporary_->write("Fälle von heute/demo/forehead.txt", forehead);
  const std::string off = changed_case("off.json", [](json& c) {
    c["region"] = {{"vertices_file", "forehead.txt"}};
  });
  expect_failure(5, {"region", "no bone"}, {"predict", off, "x"});

  temporary_->write("Fälle von heute/demo/far.txt", "99999999");
  const std::string far = changed_case("far.json", [](json& c) {
    c["region"] = {{"vertices_file", "far.txt"}};
  });
  expect_failure(5, {"region", "99999999"}, {"predict", far, "x"});
}

TEST_F(Cli, RegisterFindsThePhotographsPlace) {
  json plan = json::parse(bytes_of(folder() / "demo/case.json"));
  plan["photograph"]["transform"] = {{"scale", 1},
                                     {"rotation", {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}},
                                     {"translation_mm", {80, -40, 95}}};
  // Landmarks that the case keeps judge; a half-picked one says nothing.
  const json true_place =
      json::parse(bytes_of(folder() / "demo/truth.json"))["lps_from_photograph"];
  Eigen::Matrix3d turn;
  for (int row = 0; row < 3; ++row) turn.row(row) = vector_of(true_place["rotation"][row]);
  const Eigen::Vector3d tip = vector_of(plan["landmarks"]["nose_tip"]);
  const Eigen::Vector3d own = turn.transpose() * (tip - vector_of(true_place["translation"]));
  plan["photograph"]["landmarks"] = {
      {"nose_tip", {{"scan", {own.x(), own.y(), own.z()}}, {"ct", plan["landmarks"]["nose_tip"]}}},
      {"nasion", {{"ct", {0, -100, 30}}}}};
  temporary_->write("Fälle von heute/demo/lost.json", plan.dump());
  const CliRun run = run_cli(folder(), {"register", "demo/lost.json", "found"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("median"), std::string::npos) << run.out;
  const json found = json::parse(bytes_of(folder() / "found/case.json"))["photograph"]["transform"];
  const json truth = json::parse(bytes_of(folder() / "demo/truth.json"))["lps_from_photograph"];
  EXPECT_EQ(found["scale"], 1);
  EXPECT_LT((vector_of(found["translation_mm"]) - vector_of(truth["translation"])).norm(), 0.2);
  for (int row = 0; row < 3; ++row) {
    EXPECT_LT((vector_of(found["rotation"][row]) - vector_of(truth["rotation"][row])).norm(), 2e-3);
  }
  EXPECT_EQ(run_cli(folder(), {"check", "found/case.json"}).code, 0);
  const json report = json::parse(bytes_of(folder() / "found/registration.json"));
  EXPECT_TRUE(report["doubts"].empty());
  EXPECT_LT(report["distance_mm"]["p95"], 0.6);
  ASSERT_EQ(report["landmarks_mm"].size(), 1U);
  EXPECT_LT(report["landmarks_mm"]["nose_tip"], 0.3);
  EXPECT_EQ(json::parse(bytes_of(folder() / "found/case.json"))["photograph"]["landmarks"],
            plan["photograph"]["landmarks"]);

  // What was measured is told also where it is refused: it says what to mend.
  const CliRun poor =
      run_cli(folder(), {"-q", "register", "demo/lost.json", "not-found", "--mm-per-unit", "1.4"});
  EXPECT_EQ(poor.code, 6);
  EXPECT_NE(poor.err.find("registration: is doubtful"), std::string::npos) << poor.err;
  EXPECT_NE(poor.err.find("--accept-doubts"), std::string::npos) << poor.err;
  EXPECT_NE(poor.out.find("doubt: "), std::string::npos) << poor.out;
  EXPECT_FALSE(fs::exists(folder() / "not-found"));
  EXPECT_EQ(run_cli(folder(), {"register", "demo/lost.json", "poor", "--mm-per-unit", "1.4",
                               "--accept-doubts"})
                .code,
            0);
  temporary_->write("Fälle von heute/marks", "nose 1 2 3 4 5");
  expect_failure(4, {"marks, line 1", "no landmark"},
                 {"register", "demo/lost.json", "x", "--landmarks", "marks"});
  temporary_->write("Fälle von heute/stable", "1 2 99999999");
  expect_failure(4, {"stable", "99999999"},
                 {"register", "demo/lost.json", "x", "--stable", "stable"});
  plan["photograph"]["stable_vertices"] = "0-9";
  temporary_->write("Fälle von heute/demo/few.json", plan.dump());
  expect_failure(4, {"stable region", "fewer than 50"}, {"register", "demo/few.json", "x"});
}

TEST_F(Cli, PhotographsPaintTheSkinOfTheCt) {
  const SkinSight skin(test::head_skin({}));
  const PhotoCamera camera = test::camera_from(0, 2, 0, 1200, 70, 400);
  const Photo photo = test::photograph(camera, skin, FacePaint(HeadModel(), 1));
  temporary_->write("Fälle von heute/vorn.png", png_of(photo));
  const auto truth = phantom_truth().landmarks;
  json marks, few;
  for (const char* name : {"nasion_soft", "nose_tip", "subnasale", "upper_lip", "pogonion_soft",
                           "menton_soft", "mouth_corner_left", "mouth_corner_right"}) {
    const Eigen::Vector2d at = camera.pixel(truth.at(name));
    marks["landmarks"][name] = {at.x(), at.y()};
  }
  few["landmarks"] = {{"nose_tip", {3, 4}}, {"ear", {5, 6}}};
  temporary_->write("Fälle von heute/vorn.json", marks.dump());
  temporary_->write("Fälle von heute/few.json", few.dump());
  const std::vector<std::string> begin{"photographs", "demo/case.json"};
  const auto with = [&](std::vector<std::string> rest) {
    rest.insert(rest.begin(), begin.begin(), begin.end());
    return rest;
  };
  const CliRun run =
      run_cli(folder(),
              with({"painted", "--photo", "vorn.png=vorn.json", "--landmarks", "demo/truth.json"}));
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("nose_tip"), std::string::npos) << run.out;
  const json report = json::parse(bytes_of(folder() / "painted/projection.json"));
  EXPECT_LT(report["photographs"][0]["camera"]["rms_mm"], 0.5);
  EXPECT_GT(report["seen_cm2"], 200);
  const json plan = json::parse(bytes_of(folder() / "painted/case.json"));
  EXPECT_EQ(plan["photograph"]["obj"], "photograph.obj");
  EXPECT_EQ(run_cli(folder(), {"check", "painted/case.json"}).code, 0);
  const CliRun surfaces = run_cli(folder(), {"surfaces", "painted/case.json", "painted-again"});
  EXPECT_EQ(surfaces.code, 0) << surfaces.err;
  EXPECT_EQ(bytes_of(folder() / "painted-again/face.obj"),
            bytes_of(folder() / "painted/photograph.obj"));

  expect_failure(4, {"vorn.json", "nasion_soft", "--landmarks"},
                 with({"x", "--photo", "vorn.png=vorn.json"}));
  expect_failure(4, {"few.json", "ear"}, with({"x", "--photo", "vorn.png=few.json"}));
  expect_failure(2, {"vorn.png", "names no landmarks"}, with({"x", "--photo", "vorn.png"}));
  expect_failure(4, {"none.png", "does not exist"}, with({"x", "--photo", "none.png=few.json"}));
  EXPECT_EQ(run_cli(folder(), with({"x"})).code, 2);
}

TEST_F(Cli, AnOutputThatExistsOrCannotBeMadeIsCode7) {
  temporary_->write("Fälle von heute/file", "mine");
  for (const char* verb : {"surfaces", "predict", "mesh"}) {
    expect_failure(7, {"file", "exists"}, {verb, "demo/case.json", "file"});
    expect_failure(7, {"none"}, {verb, "demo/case.json", "none/x"});
    expect_failure(7, {"file"}, {verb, "demo/case.json", "file/x"});
  }
  expect_failure(7, {"demo", "exists"}, {"demo-case", "demo"});
  EXPECT_EQ(bytes_of(folder() / "file"), "mine");
}

TEST_F(Cli, CtrlCIsCode8AndLeavesNothing) {
  for (const char* stage : {"bone surface", "region"}) {
    const std::vector<std::string> before = names_in(folder());
    bool sent = false;
    const CliRun run = run_cli(
        folder(), {"predict", "demo/case.json", "x"}, [&](pid_t child, const std::string& text) {
          if (sent || text.find(stage) == std::string::npos) return;
          EXPECT_GT(names_in(folder()).size(), before.size()) << "nothing is being written yet";
          sent = kill(child, SIGINT) == 0;
        });
    EXPECT_TRUE(sent) << "no stage named " << stage;
    EXPECT_EQ(run.code, 8) << run.err;
    EXPECT_NE(run.err.find("gnathion-cli: "), std::string::npos);
    EXPECT_EQ(names_in(folder()), before);
  }
}

}  // namespace
}  // namespace gnathion
