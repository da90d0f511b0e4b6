#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "base/error.h"
#include "io/case_file.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using nlohmann::json;
using test::bytes_of;
using test::expect_error;
using test::TemporaryFolder;

void expect_same(const PlanHistory& a, const PlanHistory& b) {
  ASSERT_EQ(a.steps().size(), b.steps().size());
  EXPECT_EQ(a.position(), b.position());
  for (std::size_t s = 0; s < a.steps().size(); ++s) {
    EXPECT_EQ(a.steps()[s].name, b.steps()[s].name);
    EXPECT_EQ(*a.steps()[s].plan, *b.steps()[s].plan) << "step " << s;
  }
}

/// Plans that differ in everything that a surgeon can change.
class RandomPlans {
 public:
  explicit RandomPlans(fs::path folder) : folder_(std::move(folder)) { plan_.ct.path = folder_; }

  SurgicalCase next() {
    constexpr std::array kChanges{&RandomPlans::change_surfaces,   &RandomPlans::change_segments,
                                  &RandomPlans::change_photograph, &RandomPlans::change_picks,
                                  &RandomPlans::change_lists,      &RandomPlans::change_tissue,
                                  &RandomPlans::change_landmarks,  &RandomPlans::change_motion};
    (this->*kChanges[random_() % kChanges.size()])();
    return plan_;
  }

 private:
  double number() { return std::uniform_real_distribution<double>(-100, 100)(random_); }
  double positive() { return std::uniform_real_distribution<double>(1e-3, 100)(random_); }
  bool coin() { return random_() % 2 == 0; }
  Vector3d vector() { return {number(), number(), number()}; }
  Eigen::Matrix3d rotation() {
    return Eigen::AngleAxisd(number(), vector().normalized()).toRotationMatrix();
  }
  std::optional<LpsBox> crop() {
    const Vector3d at = vector();
    const LpsBox box{at, at + Vector3d(positive(), positive(), positive())};
    return coin() ? std::optional(box) : std::nullopt;
  }

  void change_surfaces() {
    plan_.ct.path = folder_ / (coin() ? "ct" : "other");
    plan_.ct.series_uid = coin() ? std::optional<std::string>("1.2.3") : std::nullopt;
    plan_.bone = {number(), positive(), coin(), crop()};
    plan_.skin = {number(), positive(), coin(), positive(), positive(), crop()};
  }
  void change_segments() {
    if (!plan_.segments.empty() && coin()) {
      plan_.segments.erase(plan_.segments.begin());
      return;
    }
    PlannedSegment segment;
    if (coin() || !plan_.segments.empty()) segment.name = "piece " + std::to_string(++made_);
    if (coin()) {
      segment.cut = BoxCut{vector(),
                           coin() ? rotation() : Eigen::Matrix3d(Eigen::Matrix3d::Identity()),
                           {positive(), positive(), positive()}};
    } else {
      segment.cut =
          PlateCut{vector(), vector(), vector(), positive(), positive(), positive(), vector()};
    }
    if (coin()) segment.pivot = vector();
    plan_.segments.push_back(segment);
  }
  void change_motion() {
    for (PlannedSegment& segment : plan_.segments) {
      segment.motion = {number(), number(), number(), number(), number(), number()};
    }
  }
  void change_photograph() {
    if (coin()) {
      plan_.photograph.reset();
    } else {
      plan_.photograph = PhotographSource{folder_ / "né.obj", {positive(), rotation(), vector()}};
    }
  }
  void change_picks() {
    if (!plan_.photograph) return;
    auto& landmarks = plan_.photograph->landmarks;
    if (!landmarks.empty() && coin()) {
      landmarks.erase(landmarks.begin());
      return;
    }
    PickedPlace& place = landmarks["ein Punkt ü" + std::to_string(++made_)];
    if (coin()) place.photograph = vector();
    if (coin() || !place.photograph) place.lps = vector();
    plan_.photograph->stable_vertices = list(plan_.photograph->stable_vertices);
  }
  std::vector<int> list(const std::vector<int>& old) {
    std::vector<int> list = old;
    switch (random_() % 4) {
      case 0:
        list.clear();
        break;
      case 1:
        std::shuffle(list.begin(), list.end(), random_);
        break;
      default:
        for (int i = 0; i < 20; ++i) list.push_back(static_cast<int>(random_() % 300));
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
        break;
    }
    return list;
  }
  void change_lists() {
    plan_.region.vertices = list(plan_.region.vertices);
    plan_.tissue.sliding_vertices = list(plan_.tissue.sliding_vertices);
  }
  void change_tissue() {
    plan_.region.reach_mm = positive();
    plan_.region.erased = coin();
    plan_.region.lip_line.clear();
    if (coin()) plan_.region.lip_line = {vector(), vector(), vector()};
    plan_.hinge.reset();
    if (coin()) plan_.hinge = HingeAxis{{-positive(), 0, 1}, {20 + positive(), 2, 3}};
    plan_.tissue.depth_mm = positive();
    plan_.tissue.slides_on_teeth = coin();
    plan_.tissue.material.young_MPa = positive();
    plan_.tissue.kinds = coin() ? TissueKinds::from_ct : TissueKinds::homogeneous;
    plan_.tissue.strain = coin() ? Strain::large : Strain::automatic;
  }
  void change_landmarks() {
    if (!plan_.landmarks.empty() && coin()) {
      plan_.landmarks.erase(plan_.landmarks.begin());
    } else {
      plan_.landmarks["ein Punkt ü" + std::to_string(++made_)] = vector();
    }
  }

  fs::path folder_;
  SurgicalCase plan_;
  std::mt19937 random_{5};
  int made_ = 0;
};

TEST(CaseHistory, ComesBackToTheBitWhereverOneStands) {
  const TemporaryFolder folder;
  RandomPlans plans(folder.path());
  PlanHistory history("Import \"the CT\"", plans.next());
  for (int i = 0; i < 150; ++i) history.push("Step ü " + std::to_string(i), plans.next());
  ASSERT_GT(history.steps().size(), 100u);
  for (std::size_t position = 0; position < history.steps().size(); position += 7) {
    const PlanHistory here(history.steps(), position);
    write_case_history(here, folder / "case.json");
    expect_same(read_case_history(folder / "case.json"), here);
    EXPECT_EQ(read_case_file(folder / "case.json"), here.plan());
  }
}

TEST(CaseHistory, SavedAgainIsTheSameFile) {
  const TemporaryFolder folder;
  RandomPlans plans(folder.path());
  PlanHistory history("Open", plans.next());
  for (int i = 0; i < 20; ++i) history.push("Step", plans.next());
  history.undo();
  write_case_history(history, folder / "case.json");
  const std::string first = bytes_of(folder / "case.json");
  write_case_history(read_case_history(folder / "case.json"), folder / "case.json");
  EXPECT_EQ(bytes_of(folder / "case.json"), first);
}

TEST(CaseHistory, OfAFileWithoutOneIsTheCaseAlone) {
  const TemporaryFolder folder;
  SurgicalCase plan;
  plan.ct.path = folder / "ct";
  write_case_file(plan, folder / "case.json");
  const PlanHistory history = read_case_history(folder / "case.json");
  EXPECT_EQ(history.steps().size(), 1u);
  EXPECT_EQ(history.steps()[0].name, "Open");
  EXPECT_EQ(history.plan(), plan);
}

TEST(CaseHistory, StartsFromVerticesInAFileBesideTheCase) {
  const TemporaryFolder folder;
  folder.write("region.txt", "1 2 3");
  const fs::path file = folder.write("case.json", R"({"gnathion_case": 1, "ct": {"path": "ct"},
      "region": {"vertices_file": "region.txt"},
      "history": {"position": 1, "steps": [{"name": "a", "region": {"removed": "3"}},
                                           {"name": "b"}]}})");
  const PlanHistory history = read_case_history(file);
  EXPECT_EQ(history.plan().region.vertices, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(history.steps()[0].plan->region.vertices, (std::vector<int>{1, 2}));
}

/// Three steps, the second of which is present.
PlanHistory three_steps(const fs::path& folder) {
  SurgicalCase plan;
  plan.ct.path = folder / "ct";
  plan.region.vertices = {1, 2, 3, 4, 5, 6, 7, 8, 20};
  PlanHistory history("Open", plan);
  plan.region.vertices = {1, 2, 3, 4, 5, 6, 7, 8, 9, 20};
  history.push("Paint", plan);
  plan.bone.hu = 300;
  history.push("Level", plan);
  history.undo();
  return history;
}

TEST(CaseHistory, MovesWithTheCase) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "before");
  write_case_history(three_steps(folder / "before"), folder / "before/case.json");
  fs::rename(folder / "before", folder / "after");
  const PlanHistory history = read_case_history(folder / "after/case.json");
  for (const PlanStep& step : history.steps()) EXPECT_EQ(step.plan->ct.path, folder / "after/ct");
}

TEST(CaseHistory, APathMendedByHandIsMendedInEveryStep) {
  const TemporaryFolder folder;
  write_case_history(three_steps(folder.path()), folder / "case.json");
  json object = json::parse(bytes_of(folder / "case.json"));
  object["ct"]["path"] = "/mnt/ct";
  folder.write("case.json", object.dump());
  const PlanHistory history = read_case_history(folder / "case.json");
  for (const PlanStep& step : history.steps()) {
    EXPECT_EQ(step.plan->ct.path, "/mnt/ct");
  }
}

TEST(CaseHistory, ABrokenOneIsRefusedNamingTheStepAndThePlanIsStillRead) {
  const TemporaryFolder folder;
  const PlanHistory whole = three_steps(folder.path());
  write_case_history(whole, folder / "case.json");
  const json good = json::parse(bytes_of(folder / "case.json"));
  const std::vector<std::pair<std::string, std::function<void(json&)>>> faults{
      {"history.position", [](json& h) { h["position"] = 3; }},
      {"history.position", [](json& h) { h["position"] = -1; }},
      {"history.position", [](json& h) { h["position"] = 0.5; }},
      {"history.position", [](json& h) { h["position"] = "1"; }},
      {"history.position", [](json& h) { h.erase("position"); }},
      {"history.position", [](json& h) { h["steps"].clear(); }},
      {"history.steps", [](json& h) { h["steps"] = 3; }},
      {"history.steps[2]", [](json& h) { h["steps"][2] = 3; }},
      {"history.stepping", [](json& h) { h["stepping"] = 3; }},
      {"history.steps[0].name", [](json& h) { h["steps"][0].erase("name"); }},
      {"history.steps[1].changes", [](json& h) { h["steps"][1]["changes"] = json::object(); }},
      {"history.steps[2].change", [](json& h) { h["steps"][2]["change"] = 1; }},
      {"history.steps[2].changes", [](json& h) { h["steps"][2]["changes"] = 1; }},
      {"history.steps[2].changes.bone.hu",
       [](json& h) { h["steps"][2]["changes"]["bone"]["hu"] = "high"; }},
      {"history.steps[2].changes.bone.HU",
       [](json& h) { h["steps"][2]["changes"]["bone"]["HU"] = 1; }},
      {"history.steps[2].changes.ct", [](json& h) { h["steps"][2]["changes"]["ct"] = nullptr; }},
      {"history.steps[2].changes.history",
       [](json& h) { h["steps"][2]["changes"]["history"] = json::object(); }},
      {"history.steps[2].changes",
       [](json& h) { h["steps"][2]["changes"]["region"]["vertices"] = "1 2"; }},
      {"history.steps[0].region", [](json& h) { h["steps"][0]["region"]["removed"] = "11"; }},
      {"history.steps[0].region", [](json& h) { h["steps"][0]["region"]["added"] = "3"; }},
      {"history.steps[0].region.removed",
       [](json& h) { h["steps"][0]["region"]["removed"] = "x"; }},
      {"history.steps[0].region.add", [](json& h) { h["steps"][0]["region"]["add"] = "1"; }},
      {"history.steps[2].sliding", [](json& h) { h["steps"][2]["sliding"] = "1-3"; }},
      {"history.steps[2].stable",
       [](json& h) { h["steps"][2]["stable"]["added"] = "1-3"; }}};  // and no photograph
  for (const auto& [key, spoil] : faults) {
    SCOPED_TRACE(key);
    json bad = good;
    spoil(bad["history"]);
    const fs::path file = folder.write("bad.json", bad.dump());
    expect_error(ErrorKind::case_file, {"bad.json: " + key + ":"},
                 [&] { read_case_history(file); });
    EXPECT_EQ(read_case_file(file), whole.plan());
  }
}

TEST(CaseHistory, OfADamagedFileIsReadOrRefusedWithTheFilesName) {
  const TemporaryFolder folder;
  RandomPlans plans(folder.path());
  PlanHistory history("Open", plans.next());
  for (int i = 0; i < 12; ++i) history.push("Step", plans.next());
  history.undo();
  write_case_history(history, folder / "case.json");
  const std::string good = bytes_of(folder / "case.json");
  std::mt19937 random(8);
  const std::string marks = "0-9 \"{}[],.:en";
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    std::string bad = good;
    for (auto n = random() % 3 + 1; n > 0; --n) {
      bad[random() % bad.size()] = marks[random() % marks.size()];
    }
    if (round % 10 == 0) bad.resize(random() % bad.size() + 1);  // a copy that broke off
    const fs::path file = folder.write("bad.json", bad);
    try {
      read_case_history(file);
    } catch (const Error& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("bad.json"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(CaseHistory, TellsOnlyHowStepsDiffer) {
  const TemporaryFolder folder;
  write_case_history(three_steps(folder.path()), folder / "case.json");
  const json steps = json::parse(bytes_of(folder / "case.json"))["history"]["steps"];
  EXPECT_EQ(steps[0], json::parse(R"({"name": "Open", "region": {"removed": "9"}})"));
  EXPECT_EQ(steps[1], json::parse(R"({"name": "Paint"})"));
  EXPECT_EQ(steps[2], json::parse(R"({"name": "Level", "changes": {"bone": {"hu": 300.0}}})"));
}

TEST(CaseHistory, SaysWhenANameCannotBeWritten) {
  const TemporaryFolder folder;
  PlanHistory history = three_steps(folder.path());
  SurgicalCase plan = history.plan();
  plan.name = "M\xfcller";  // Latin-1
  history.push("Rename", plan);
  history.undo();
  expect_error(ErrorKind::output, {"case.json", "UTF-8"},
               [&] { write_case_history(history, folder / "case.json"); });
  EXPECT_FALSE(fs::exists(folder / "case.json"));
}

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(CaseHistory, IsSmallAndQuickForFiveHundredStrokesOfABrush) {
  constexpr int kFace = 100000, kRegion = 20000, kStroke = 700, kSteps = 500;
  // Vertices that are neighbours on a face need not be in its file: numbers without any order.
  std::vector<int> numbers(kFace);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::mt19937 random(6);
  std::shuffle(numbers.begin(), numbers.end(), random);
  const TemporaryFolder folder;
  SurgicalCase plan;
  plan.ct.path = folder / "ct";
  const auto painted = [&](int from) {
    std::vector<int> region(numbers.begin() + from, numbers.begin() + from + kRegion);
    std::sort(region.begin(), region.end());
    return region;
  };
  plan.region.vertices = painted(0);
  PlanHistory history("Open", plan);
  for (int step = 1; step < kSteps; ++step) {
    plan.region.vertices = painted(step % 2 * kStroke / 2 + step % 100 * kStroke);
    history.push("Paint", plan);
  }
  for (int i = 0; i < kSteps / 2; ++i) history.undo();
  const fs::path file = folder / "case.json";
  const double writing = seconds([&] { write_case_history(history, file); });
  std::optional<PlanHistory> back;
  const double reading = seconds([&] { back = read_case_history(file); });
  expect_same(*back, history);
  const double mega_bytes = static_cast<double>(fs::file_size(file)) / 1e6;
  std::cout << kSteps << " steps, " << kRegion << " vertices, " << kStroke
            << " new in each: " << mega_bytes << " MB, written in " << writing << " s, read in "
            << reading << " s\n";
  EXPECT_LT(mega_bytes, 10);
  EXPECT_LT(writing, 2);
  EXPECT_LT(reading, 2);
}

}  // namespace
}  // namespace gnathion
