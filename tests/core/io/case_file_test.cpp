#include "io/case_file.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <Eigen/Geometry>
#include <csignal>
#include <random>

#include "base/error.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using test::expect_error;
using test::TemporaryFolder;

/// A case in which no value is the default.
SurgicalCase full_case(const fs::path& folder) {
  SurgicalCase plan;
  plan.name = "Übung \"eins\"";
  plan.ct = {folder / "CT Größe 1", "1.2.826.0.1"};
  plan.bone.hu = 300;
  plan.bone.minimum_component_volume = 500;
  plan.skin.hu = -250;
  plan.skin.edge_mm = 3;
  plan.bone.remove_support = plan.skin.remove_support = false;
  plan.bone.crop = plan.skin.crop = LpsBox{{-80, -120, -100}, {80, 90, 100}};
  plan.segments.resize(1);
  plan.segments[0].cut = box_between({-60, -305, 322}, {65, -215, 369});
  Similarity transform;
  transform.scale = 50;
  transform.rotation = Eigen::AngleAxisd(0.3, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  transform.translation << 4, -61.25, 1. / 3;
  plan.photograph = PhotographSource{folder / "photo 1" / "né.obj", transform};
  plan.photograph->landmarks = {{"nasion", {Vector3d(0.1, 1. / 3, 2), Vector3d(4, -99.5, 30)}},
                                {"Punkt ü", {{}, Vector3d(1e-9, 2, 3)}},
                                {"chin", {Vector3d(7, 8, 9), {}}}};
  plan.photograph->stable_vertices = {0, 1, 2, 5};
  plan.region.reach_mm = 42;
  plan.region.vertices = {0, 7, 12};
  plan.region.lip_line = {{-24.5, -93, -41.9}, {0.1, -106.7, 1. / 3 - 42}, {24.5, -93, -41.9}};
  plan.hinge = HingeAxis{{-49.1, 1. / 3, 4}, {51, 0.1, 5}};
  plan.tissue = {.generator = Generator::paper,
                 .depth_mm = 6,
                 .bone_reach_mm = 15,
                 .edge_mm = 2.5,
                 .layer_edges = 1.5,
                 .released_mm = 4,
                 .slides_on_teeth = false,
                 .sliding_vertices = {3, 4},
                 .material = {0.5, 0.49},
                 .kinds = TissueKinds::from_ct,
                 .load = LoadModel::force,
                 .elements = Elements::linear,
                 .strain = Strain::small,
                 .tolerance_mm = 0.25};
  plan.segments[0].motion = {1, -2, 3.5, -4, 5, -6.25};
  plan.segments[0].pivot = Vector3d(0.1, -20, 33);
  plan.landmarks["Pog' weich"] = Vector3d(0, -100.7, -60);
  return plan;
}

void expect_equal(const std::optional<LpsBox>& a, const std::optional<LpsBox>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->min, b->min);
  EXPECT_EQ(a->max, b->max);
}

void expect_equal(const BoundedCut& a, const BoundedCut& b) {
  ASSERT_EQ(a.index(), b.index());
  if (const auto* box = std::get_if<BoxCut>(&a)) {
    const auto& other = std::get<BoxCut>(b);
    EXPECT_LT((box->centre - other.centre).norm(), 1e-12);
    EXPECT_LT((box->half_extents - other.half_extents).norm(), 1e-12);
    EXPECT_EQ(box->axes, other.axes);
    return;
  }
  const auto &p = std::get<PlateCut>(a), &q = std::get<PlateCut>(b);
  EXPECT_EQ(p.centre, q.centre);
  EXPECT_EQ(p.normal, q.normal);
  EXPECT_EQ(p.in_plane, q.in_plane);
  EXPECT_EQ(p.seed, q.seed);
  EXPECT_EQ(p.half_width, q.half_width);
  EXPECT_EQ(p.half_height, q.half_height);
  EXPECT_EQ(p.kerf, q.kerf);
}

void expect_equal(const SurgicalCase& a, const SurgicalCase& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.ct.path, b.ct.path);
  EXPECT_EQ(a.ct.series_uid, b.ct.series_uid);
  EXPECT_EQ(a.bone.hu, b.bone.hu);
  EXPECT_EQ(a.bone.minimum_component_volume, b.bone.minimum_component_volume);
  EXPECT_EQ(a.bone.remove_support, b.bone.remove_support);
  EXPECT_EQ(a.skin.hu, b.skin.hu);
  EXPECT_EQ(a.skin.edge_mm, b.skin.edge_mm);
  EXPECT_EQ(a.skin.remove_support, b.skin.remove_support);
  expect_equal(a.bone.crop, b.bone.crop);
  expect_equal(a.skin.crop, b.skin.crop);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t s = 0; s < a.segments.size(); ++s) {
    EXPECT_EQ(a.segments[s].name, b.segments[s].name);
    expect_equal(a.segments[s].cut, b.segments[s].cut);
    EXPECT_EQ(a.segments[s].motion, b.segments[s].motion);
    EXPECT_EQ(a.segments[s].pivot, b.segments[s].pivot);
  }
  ASSERT_EQ(a.photograph.has_value(), b.photograph.has_value());
  if (a.photograph) {
    EXPECT_EQ(a.photograph->obj, b.photograph->obj);
    const auto &s = a.photograph->lps_from_photograph, &t = b.photograph->lps_from_photograph;
    EXPECT_EQ(s.scale, t.scale);
    EXPECT_EQ(s.rotation, t.rotation);
    EXPECT_EQ(s.translation, t.translation);
    EXPECT_EQ(a.photograph->landmarks, b.photograph->landmarks);
    EXPECT_EQ(a.photograph->stable_vertices, b.photograph->stable_vertices);
  }
  EXPECT_EQ(a.region.reach_mm, b.region.reach_mm);
  EXPECT_EQ(a.region.vertices, b.region.vertices);
  EXPECT_EQ(a.region.lip_line, b.region.lip_line);
  EXPECT_EQ(a.hinge, b.hinge);
  EXPECT_EQ(a.tissue.generator, b.tissue.generator);
  EXPECT_EQ(a.tissue.depth_mm, b.tissue.depth_mm);
  EXPECT_EQ(a.tissue.bone_reach_mm, b.tissue.bone_reach_mm);
  EXPECT_EQ(a.tissue.released_mm, b.tissue.released_mm);
  EXPECT_EQ(a.tissue.material.young_MPa, b.tissue.material.young_MPa);
  EXPECT_EQ(a.tissue.material.poisson, b.tissue.material.poisson);
  EXPECT_EQ(a.tissue.load, b.tissue.load);
  EXPECT_EQ(a.tissue.edge_mm, b.tissue.edge_mm);
  EXPECT_EQ(a.tissue.layer_edges, b.tissue.layer_edges);
  EXPECT_EQ(a.tissue.slides_on_teeth, b.tissue.slides_on_teeth);
  EXPECT_EQ(a.tissue.sliding_vertices, b.tissue.sliding_vertices);
  EXPECT_EQ(a.tissue.kinds, b.tissue.kinds);
  EXPECT_EQ(a.tissue.elements, b.tissue.elements);
  EXPECT_EQ(a.tissue.strain, b.tissue.strain);
  EXPECT_EQ(a.tissue.tolerance_mm, b.tissue.tolerance_mm);
  EXPECT_EQ(a.landmarks, b.landmarks);
}

TEST(CaseFile, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  const fs::path file = folder / "Fall Müller 1.json";
  const SurgicalCase plan = full_case(folder.path());
  write_case_file(plan, file);
  expect_equal(read_case_file(file), plan);
}

TEST(CaseFile, APlateAndTheDefaultsComeBackToo) {
  const TemporaryFolder folder;
  SurgicalCase plan;
  plan.ct.path = folder / "ct.nii.gz";
  plan.segments.resize(1);
  plan.segments[0].cut =
      PlateCut{{1, -100, -70}, {0, 0.2, 1}, {1, 0, 0}, 40, 25, 0.75, {0, -100, -80}};
  write_case_file(plan, folder / "case.json");
  expect_equal(read_case_file(folder / "case.json"), plan);
}

TEST(CaseFile, SeveralSegmentsComeBackInOrder) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  plan.segments[0].name = "mandible";
  PlannedSegment chin{"chin", box_between({-20, -300, 320}, {20, -250, 340}), {}, {}};
  chin.motion.forward_mm = 4;
  plan.segments.push_back(chin);
  write_case_file(plan, folder / "case.json");
  expect_equal(read_case_file(folder / "case.json"), plan);
}

TEST(CaseFile, RefusesSegmentsThatContradictEachOther) {
  const std::string head = R"({"gnathion_case": 1, "ct": {"path": "ct"}, )";
  const std::string box = R"("box": {"min": [0, 0, 0], "max": [1, 1, 1]}})";
  const std::vector<std::pair<std::string, std::string>> bad{
      {R"("segments": [3])", "segments[0]"},
      {R"("segments": [{)" + box + "]", "segments[0].name"},
      {R"("segments": [{"name": "a", )" + box + R"(, {"name": "a", )" + box + "]",
       "segments[1].name"},
      {R"("segments": [{"name": "a", )" + box + R"(], "motion": {"up_mm": 1})", "segments"},
      {R"("segments": [{"name": "a", "motion": {"up": 1}, )" + box + "]", "segments[0].motion.up"}};
  for (const auto& [text, subject] : bad) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("case.json", head + text + "}");
    expect_error(ErrorKind::case_file, {subject.c_str()}, [&] { read_case_file(file); });
  }
}

TEST(CaseFile, TheOnlySegmentKeepsItsName) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  plan.segments[0].name = "mandible";
  write_case_file(plan, folder / "case.json");
  expect_equal(read_case_file(folder / "case.json"), plan);
}

TEST(CaseFile, RefusesWhatForceTransferHasNot) {
  for (const char* wish : {R"("elements": "quadratic")", R"("strain": "large")"}) {
    const TemporaryFolder folder;
    const fs::path file = folder.write(
        "case.json", R"({"gnathion_case": 1, "ct": {"path": "ct"}, "tissue": {"load": "force", )" +
                         std::string(wish) +
                         R"(}, "segment": {"box": {"min": [0, 0, 0], "max": [1, 2, 4]}}})");
    expect_error(ErrorKind::case_file, {"tissue.", "force transfer", "displacement"},
                 [&] { read_case_file(file); });
  }
}

TEST(CaseFile, MovesWithItsFilesWhenTheyLieBesideIt) {
  const TemporaryFolder folder;
  const fs::path before = folder / "before", after = folder / "after";
  fs::create_directory(before);
  SurgicalCase plan = full_case(before);
  plan.ct.path = folder / "elsewhere";
  write_case_file(plan, before / "case.json");
  fs::rename(before, after);
  const SurgicalCase read = read_case_file(after / "case.json");
  EXPECT_EQ(read.photograph->obj, after / "photo 1" / "né.obj");
  EXPECT_EQ(read.region.vertices, plan.region.vertices);
  EXPECT_EQ(read.ct.path, folder / "elsewhere") << "what lies outside the folder stays there";
}

TEST(CaseFile, PathsAreRelativeToItsFolder) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a/case.json", R"({"gnathion_case": 1, "ct": {"path": "../ct"},
        "segment": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}},
        "photograph": {"obj": "/abs/face.obj"}})");
  const SurgicalCase plan = read_case_file(file);
  EXPECT_EQ(plan.ct.path, folder.path() / "a" / ".." / "ct");
  EXPECT_EQ(plan.photograph->obj, "/abs/face.obj");
}

TEST(CaseFile, WhatIsNotGivenHasTheDefault) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("case.json", R"({"gnathion_case": 1, "ct": {"path": "ct"},
        "segment": {"box": {"min": [0, 0, 0], "max": [1, 2, 4]}}, "tissue": {"poisson": 0.4}})");
  SurgicalCase plan;
  plan.ct.path = folder / "ct";
  plan.segments.resize(1);
  plan.segments[0].cut = box_between({0, 0, 0}, {1, 2, 4});
  plan.tissue.material.poisson = 0.4;
  expect_equal(read_case_file(file), plan);
}

TEST(CaseFile, MayHaveNoSegmentYet) {
  const TemporaryFolder folder;
  for (const char* none : {"", R"(, "segments": [])"}) {
    const fs::path file = folder.write(
        "case.json", R"({"gnathion_case": 1, "ct": {"path": "ct"})" + std::string(none) + "}");
    EXPECT_TRUE(read_case_file(file).segments.empty());
  }
  SurgicalCase plan = full_case(folder.path());
  plan.segments.clear();
  write_case_file(plan, folder / "case.json");
  EXPECT_EQ(read_case_file(folder / "case.json"), plan);
}

TEST(CaseFile, ATurnedBoxComesBackToTheBit) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  BoxCut box{{1. / 3, -280.7, 345.123456789},
             Eigen::AngleAxisd(0.7, Vector3d(1, -2, 0.3).normalized()).toRotationMatrix(),
             {10.1, 1. / 7, 30}};
  plan.segments[0].cut = box;
  write_case_file(plan, folder / "case.json");
  EXPECT_EQ(read_case_file(folder / "case.json"), plan);
  box.axes.col(2) *= -1;
  plan.segments[0].cut = box;
  write_case_file(plan, folder / "case.json");
  const auto back = std::get<BoxCut>(read_case_file(folder / "case.json").segments[0].cut);
  EXPECT_EQ(back.axes.col(2), Vector3d(-box.axes.col(2))) << "a mirrored box is the same box";
}

TEST(CaseFile, ABoxAlongThePatientsAxesIsWrittenByItsCornersWhereTheyGiveItBack) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  write_case_file(plan, folder / "case.json");
  EXPECT_NE(test::bytes_of(folder / "case.json").find("\"max\""), std::string::npos);
  EXPECT_EQ(test::bytes_of(folder / "case.json").find("half_extents_mm"), std::string::npos);
  int by_centre = 0;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-300, 300), half(0.01, 90);
  for (int i = 0; i < 200; ++i) {
    const auto vector = [&](auto& of) { return Vector3d(of(random), of(random), of(random)); };
    plan.segments[0].cut = BoxCut{vector(place), Eigen::Matrix3d::Identity(), vector(half)};
    write_case_file(plan, folder / "case.json");
    EXPECT_EQ(read_case_file(folder / "case.json"), plan);
    const std::string text = test::bytes_of(folder / "case.json");
    EXPECT_EQ(text.find("\"axes\""), std::string::npos);
    by_centre += text.find("half_extents_mm") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(by_centre, 0) << "or this test shows nothing of rounding";
}

TEST(CaseFile, ReadsATurnedBoxAsThreeDirectionsOfItsEdges) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("case.json", R"({"gnathion_case": 1, "ct": {"path": "ct"},
        "segment": {"box": {"centre": [1, 2, 3], "half_extents_mm": [10, 20, 30],
                            "axes": [[0, 1, 0], [0, 0, 1], [1, 0, 0]]}}})");
  const auto box = std::get<BoxCut>(read_case_file(file).segments[0].cut);
  EXPECT_EQ(Vector3d(box.axes.col(0)), Vector3d::UnitY());
  EXPECT_EQ(Vector3d(box.axes.col(1)), Vector3d::UnitZ());
  EXPECT_EQ(Vector3d(box.axes.col(2)), Vector3d::UnitX());
  EXPECT_EQ(box.half_extents, Vector3d(10, 20, 30));
}

TEST(CaseFile, KeepsWhatSetsTheTwoSurfacesApart) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  plan.skin.opening_radius_mm = 4.5;
  plan.skin.closing_radius_mm = 0;
  const LpsBox other{{-1, -2, -3}, {4, 5, 6}};
  for (const bool bone_has_support : {false, true}) {
    plan.bone.remove_support = bone_has_support;
    for (const std::optional<LpsBox>& crop : {std::optional<LpsBox>(), std::optional(other)}) {
      plan.bone.crop = crop;
      write_case_file(plan, folder / "case.json");
      EXPECT_EQ(read_case_file(folder / "case.json"), plan);
      std::swap(plan.bone.crop, plan.skin.crop);
      write_case_file(plan, folder / "case.json");
      EXPECT_EQ(read_case_file(folder / "case.json"), plan);
      std::swap(plan.bone.crop, plan.skin.crop);
    }
  }
}

TEST(CaseFile, KeepsListsOfVerticesInItselfInTheirOrder) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  plan.region.vertices = {12, 13, 14, 500, 499, 7, 7, 0};
  write_case_file(plan, folder / "case.json");
  EXPECT_EQ(read_case_file(folder / "case.json"), plan);
  EXPECT_NE(test::bytes_of(folder / "case.json").find("\"12-14 500 499 7 7 0\""),
            std::string::npos);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "one file";
}

TEST(CaseFile, SaysWhenItCannotBeWritten) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  expect_error(ErrorKind::output, {"none/case.json"},
               [&] { write_case_file(plan, folder / "none/case.json"); });
  fs::create_directory(folder / "folder.json");
  expect_error(ErrorKind::output, {"folder.json"},
               [&] { write_case_file(plan, folder / "folder.json"); });
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "nothing left behind";
}

/// As on a disk with room for a few bytes.
class FewBytes {
 public:
  explicit FewBytes(rlim_t most) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit few{most, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &few);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FewBytes() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FewBytes(const FewBytes&) = delete;
  FewBytes& operator=(const FewBytes&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(CaseFile, AFullDiskLeavesTheOldFileAsItWas) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  write_case_file(plan, folder / "case.json");
  const std::string before = test::bytes_of(folder / "case.json");
  plan.name = "another";
  {
    const FewBytes room(100);
    expect_error(ErrorKind::output, {"case.json", "unchanged"},
                 [&] { write_case_file(plan, folder / "case.json"); });
  }
  EXPECT_EQ(test::bytes_of(folder / "case.json"), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "nothing left behind";
}

TEST(CaseFile, AReplacedFileKeepsItsRightsAndTheLinkThatLeadsToIt) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  write_case_file(plan, folder / "case.json");
  fs::permissions(folder / "case.json", fs::perms(0640));
  fs::create_directory(folder / "elsewhere");
  fs::create_symlink("../case.json", folder / "elsewhere/link.json");
  plan.name = "another";
  write_case_file(plan, folder / "elsewhere/link.json");
  EXPECT_TRUE(fs::is_symlink(folder / "elsewhere/link.json"));
  EXPECT_EQ(fs::status(folder / "case.json").permissions(), fs::perms(0640));
  EXPECT_NE(test::bytes_of(folder / "case.json").find("another"), std::string::npos);
}

/// A section of a case file that is wrong, and the key that the message must name.
struct BadCase {
  std::string section, content, key;
};

std::string case_text(const BadCase& bad) {
  std::map<std::string, std::string> sections{
      {"gnathion_case", "1"},
      {"ct", R"({"path": "ct"})"},
      {"segment", R"({"box": {"min": [0, 0, 0], "max": [1, 1, 1]}})"}};
  sections[bad.section] = bad.content;
  std::string text = "{";
  for (const auto& [name, content] : sections) {
    if (content.empty()) continue;
    text += (text == "{" ? "\"" : ",\n \"") + name + "\": " + content;
  }
  return text + "}\n";
}

void expect_refused(const BadCase& bad) {
  SCOPED_TRACE(bad.section + " " + bad.content);
  const TemporaryFolder folder;
  const fs::path file = folder.write("case.json", case_text(bad));
  expect_error(ErrorKind::case_file, {"case.json: " + bad.key + ":"},
               [&] { read_case_file(file); });
}

const std::string plate_start =
    R"({"plate": {"centre": [0, 0, 0], "normal": [0, 0, 1], "seed": [0, 0, -9], )";
const std::string plate = plate_start + R"("width_direction": [1, 0, 0])";

TEST(CaseFile, TheTestsOwnPlateIsGood) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(
      read_case_file(folder.write("case.json", case_text({"segment", plate + "}}", ""}))));
}

TEST(CaseFile, RefusesEveryUnknownKeyWithItsPath) {
  for (const BadCase& bad : std::vector<BadCase>{
           {"motions", "{}", "motions"},
           {"ct", R"({"path": "ct", "uid": "1"})", "ct.uid"},
           {"ct", R"({"path": "ct", "crop": {"min": [0,0,0], "max": [1,1,1], "hu": 1}})",
            "ct.crop.hu"},
           {"bone", R"({"HU": 3})", "bone.HU"},
           {"skin", R"({"smooth": 3})", "skin.smooth"},
           {"segment", R"({"box": {"min": [0,0,0], "max": [1,1,1]}, "kerf": 1})", "segment.kerf"},
           {"segment", R"({"box": {"min": [0,0,0], "max": [1,1,1], "turn": 1}})",
            "segment.box.turn"},
           {"segment",
            R"({"box": {"centre": [0,0,0], "half_extents_mm": [1,1,1], "min": [0,0,0]}})",
            "segment.box.min"},
           {"segment", plate + R"(, "kerf": 2}})", "segment.plate.kerf"},
           {"photograph", R"({"obj": "a", "mtl": "b"})", "photograph.mtl"},
           {"photograph", R"({"obj": "a", "transform": {"translation": [0,0,0]}})",
            "photograph.transform.translation"},
           {"photograph", R"({"obj": "a", "landmarks": {"nasion": {"skin": [1, 2, 3]}}})",
            "photograph.landmarks.nasion.skin"},
           {"photograph", R"({"obj": "a", "landmarks": {"n": {"ct": [1, 2, 3], "lps": 1}}})",
            "photograph.landmarks.n.lps"},
           {"photograph", R"({"obj": "a", "stable": "1-3"})", "photograph.stable"},
           {"region", R"({"reach": 3})", "region.reach"},
           {"tissue", R"({"young_modulus": 3})", "tissue.young_modulus"},
           {"motion", R"({"forward": 3})", "motion.forward"}}) {
    expect_refused(bad);
  }
}

TEST(CaseFile, RefusesEveryWrongTypeWithItsPath) {
  for (const BadCase& bad : std::vector<BadCase>{
           {"gnathion_case", "\"1\"", "gnathion_case"},
           {"gnathion_case", "2", "gnathion_case"},
           {"name", "7", "name"},
           {"ct", "\"ct\"", "ct"},
           {"ct", R"({"path": 3})", "ct.path"},
           {"ct", R"({"path": "ct", "series_uid": 1.2})", "ct.series_uid"},
           {"ct", R"({"path": "ct", "remove_support": "yes"})", "ct.remove_support"},
           {"ct", R"({"path": "ct", "crop": [0, 1]})", "ct.crop"},
           {"ct", R"({"path": "ct", "crop": {"min": [0, 0], "max": [1, 1, 1]}})", "ct.crop.min"},
           {"bone", "[]", "bone"},
           {"bone", R"({"hu": "250"})", "bone.hu"},
           {"bone", R"({"smallest_piece_mm3": true})", "bone.smallest_piece_mm3"},
           {"skin", R"({"hu": null})", "skin.hu"},
           {"skin", R"({"edge_mm": [2]})", "skin.edge_mm"},
           {"segment", "7", "segment"},
           {"segment", R"({"box": 1})", "segment.box"},
           {"segment", R"({"box": {"min": [0, 0, "0"], "max": [1, 1, 1]}})", "segment.box.min"},
           {"segment", R"({"plate": []})", "segment.plate"},
           {"segment", plate + R"(, "kerf_mm": "1"}})", "segment.plate.kerf_mm"},
           {"photograph", "\"face.obj\"", "photograph"},
           {"photograph", R"({"obj": ["a"]})", "photograph.obj"},
           {"photograph", R"({"obj": "a", "transform": [1]})", "photograph.transform"},
           {"photograph", R"({"obj": "a", "transform": {"scale": "50"}})",
            "photograph.transform.scale"},
           {"photograph", R"({"obj": "a", "transform": {"rotation": [1, 0, 0]}})",
            "photograph.transform.rotation"},
           {"photograph", R"({"obj": "a", "transform": {"translation_mm": 3}})",
            "photograph.transform.translation_mm"},
           {"photograph", R"({"obj": "a", "landmarks": [1, 2, 3]})", "photograph.landmarks"},
           {"photograph", R"({"obj": "a", "landmarks": {"nasion": [1, 2, 3]}})",
            "photograph.landmarks.nasion"},
           {"photograph", R"({"obj": "a", "landmarks": {"nasion": {"scan": [1, 2]}}})",
            "photograph.landmarks.nasion.scan"},
           {"photograph", R"({"obj": "a", "landmarks": {"nasion": {"ct": ["1", 2, 3]}}})",
            "photograph.landmarks.nasion.ct"},
           {"photograph", R"({"obj": "a", "stable_vertices": [1, 2]})",
            "photograph.stable_vertices"},
           {"region", "35", "region"},
           {"region", R"({"reach_mm": "35"})", "region.reach_mm"},
           {"region", R"({"vertices_file": [1, 2]})", "region.vertices_file"},
           {"region", R"({"vertices": [1, 2]})", "region.vertices"},
           {"region", R"({"lip_line": [0, 0, 0]})", "region.lip_line"},
           {"region", R"({"lip_line": {"x": 1}})", "region.lip_line"},
           {"region", R"({"lip_line": [[0, 0, 0], [1, 2]]})", "region.lip_line"},
           {"region", R"({"lip_line": [[0, 0, 0], [1, 2, "3"]]})", "region.lip_line"},
           {"region", R"({"lip_line": [[0, 0, 0]]})", "region.lip_line"},
           {"hinge", "[1, 2, 3]", "hinge"},
           {"hinge", R"({"right": [-50, 0, 0]})", "hinge.left"},
           {"hinge", R"({"right": [50, 0, 0], "left": [-50, 0, 0]})", "hinge.left"},
           {"history", "[]", "history"},
           {"tissue", R"({"generator": 1})", "tissue.generator"},
           {"tissue", R"({"load": false})", "tissue.load"},
           {"tissue", R"({"depth_mm": "8"})", "tissue.depth_mm"},
           {"tissue", R"({"bone_reach_mm": {}})", "tissue.bone_reach_mm"},
           {"tissue", R"({"released_mm": "x"})", "tissue.released_mm"},
           {"tissue", R"({"young_MPa": "1"})", "tissue.young_MPa"},
           {"tissue", R"({"poisson": "0.46"})", "tissue.poisson"},
           {"motion", "[8]", "motion"},
           {"motion", R"({"forward_mm": "8"})", "motion.forward_mm"},
           {"motion", R"({"up_mm": true})", "motion.up_mm"},
           {"motion", R"({"left_mm": null})", "motion.left_mm"},
           {"motion", R"({"pitch_deg": []})", "motion.pitch_deg"},
           {"motion", R"({"roll_deg": {}})", "motion.roll_deg"},
           {"motion", R"({"yaw_deg": "1"})", "motion.yaw_deg"},
           {"motion", R"({"pivot": [1, 2, 3, 4]})", "motion.pivot"},
           {"landmarks", R"({"chin": 3})", "landmarks.chin"}}) {
    expect_refused(bad);
  }
}

TEST(CaseFile, RefusesValuesOutOfRangeWithTheKeysPath) {
  for (const BadCase& bad : std::vector<BadCase>{
           {"ct", R"({"path": "ct", "crop": {"min": [0, 0, 0], "max": [1, 0, 1]}})", "ct.crop.min"},
           {"bone", R"({"smallest_piece_mm3": 0})", "bone.smallest_piece_mm3"},
           {"skin", R"({"edge_mm": -2})", "skin.edge_mm"},
           {"segment", R"({"box": {"min": [0, 0, 2], "max": [1, 1, 1]}})", "segment.box.min"},
           {"segment", plate + R"(, "half_width_mm": 0}})", "segment.plate.half_width_mm"},
           {"segment", plate + R"(, "half_height_mm": -1}})", "segment.plate.half_height_mm"},
           {"segment", plate + R"(, "kerf_mm": 0}})", "segment.plate.kerf_mm"},
           {"segment", plate_start + R"("width_direction": [0, 0, -2]}})",
            "segment.plate.width_direction"},
           {"photograph", R"({"obj": "a", "transform": {"scale": 0}})",
            "photograph.transform.scale"},
           {"photograph", R"({"obj": "a", "landmarks": {"nasion": {}}})",
            "photograph.landmarks.nasion.scan"},
           {"photograph", R"({"obj": "a", "stable_vertices": "9-3"})",
            "photograph.stable_vertices"},
           {"photograph", R"({"obj": "a", "stable_vertices": "-3"})", "photograph.stable_vertices"},
           {"photograph", R"({"obj": "a", "stable_vertices": ""})", "photograph.stable_vertices"},
           {"skin", R"({"opening_radius_mm": -1})", "skin.opening_radius_mm"},
           {"segment", R"({"box": {"centre": [0,0,0], "half_extents_mm": [1,0,1]}})",
            "segment.box.half_extents_mm"},
           {"region", R"({"reach_mm": 0})", "region.reach_mm"},
           {"region", R"({"vertices": "1 two"})", "region.vertices"},
           {"region", R"({"vertices": "-3"})", "region.vertices"},
           {"region", R"({"vertices": "9-3"})", "region.vertices"},
           {"region", R"({"vertices": "1-2-3"})", "region.vertices"},
           {"region", R"({"vertices": "0-2147483647"})", "region.vertices"},
           {"region", R"({"vertices": ""})", "region.vertices"},
           {"region", R"({"vertices": "1", "vertices_file": "region.txt"})", "region.vertices"},
           {"tissue", R"({"sliding_vertices": "1 2147483648"})", "tissue.sliding_vertices"},
           {"tissue", R"({"generator": "tetgen"})", "tissue.generator"},
           {"tissue", R"({"load": "pressure"})", "tissue.load"},
           {"tissue", R"({"depth_mm": 0})", "tissue.depth_mm"},
           {"tissue", R"({"bone_reach_mm": -20})", "tissue.bone_reach_mm"},
           {"tissue", R"({"released_mm": -1})", "tissue.released_mm"},
           {"tissue", R"({"young_MPa": 0})", "tissue.young_MPa"},
           {"tissue", R"({"young_MPa": -1})", "tissue.young_MPa"},
           {"tissue", R"({"poisson": 0.5})", "tissue.poisson"},
           {"tissue", R"({"poisson": 0.7})", "tissue.poisson"},
           {"tissue", R"({"poisson": -0.1})", "tissue.poisson"}}) {
    expect_refused(bad);
  }
}

TEST(CaseFile, RefusesATransformThatIsNoRotation) {
  for (const char* rows : {"[[1, 0, 0], [0, 1, 0], [0, 0, -1]]",    // a mirror
                           "[[50, 0, 0], [0, 50, 0], [0, 0, 50]]",  // a scale
                           "[[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]"}) {
    expect_refused({"photograph",
                    R"({"obj": "a", "transform": {"rotation": )" + std::string(rows) + "}}",
                    "photograph.transform.rotation"});
  }
}

TEST(CaseFile, RefusesAxesOfABoxThatAreNoRotation) {
  for (const char* axes : {"[[1, 0, 0], [0, 1, 0], [0, 0, -1]]",  // a mirror
                           "[[2, 0, 0], [0, 1, 0], [0, 0, 1]]",
                           "[[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]", "[[1, 0, 0], [0, 1, 0]]"}) {
    expect_refused({"segment",
                    R"({"box": {"centre": [0,0,0], "half_extents_mm": [1,1,1], "axes": )" +
                        std::string(axes) + "}}",
                    "segment.box.axes"});
  }
}

TEST(CaseFile, RefusesBothCutsAndNone) {
  expect_refused(
      {"segment", R"({"box": {"min": [0,0,0], "max": [1,1,1]}, "plate": {}})", "segment.box"});
  expect_refused({"segment", "{}", "segment.box"});
}

TEST(CaseFile, RefusesMissingKeysWithTheirPath) {
  expect_refused({"gnathion_case", "", "gnathion_case"});
  expect_refused({"ct", "", "ct"});
  expect_refused({"ct", "{}", "ct.path"});
  expect_refused({"segment", R"({"box": {"centre": [0, 0, 0]}})", "segment.box.half_extents_mm"});
  expect_refused({"segment", R"({"box": {"min": [0, 0, 0]}})", "segment.box.max"});
  expect_refused({"segment", plate_start + R"("kerf_mm": 1}})", "segment.plate.width_direction"});
  expect_refused({"photograph", "{}", "photograph.obj"});
}

TEST(CaseFile, RefusesAMotionOfNothing) {
  const TemporaryFolder folder;
  const fs::path file = folder.write(
      "case.json", R"({"gnathion_case": 1, "ct": {"path": "ct"}, "motion": {"up_mm": 1}})");
  expect_error(ErrorKind::case_file, {"case.json: motion:", "no segment"},
               [&] { read_case_file(file); });
}

TEST(CaseFile, RefusesEmptyNamesOfFiles) {
  expect_refused({"ct", R"({"path": ""})", "ct.path"});
  expect_refused({"ct", R"({"path": "ct", "series_uid": ""})", "ct.series_uid"});
  expect_refused({"photograph", R"({"obj": ""})", "photograph.obj"});
  expect_refused({"region", R"({"vertices_file": ""})", "region.vertices_file"});
}

TEST(CaseFile, RefusesAKeyThatIsGivenTwice) {
  expect_refused({"motion", R"({"up_mm": 3, "left_mm": 1, "up_mm": 4})", "up_mm"});
  expect_refused({"motion", "{}, \"motion\": {}", "motion"});
  const TemporaryFolder folder;
  EXPECT_NO_THROW(read_case_file(folder.write(
      "case.json", case_text({"landmarks", R"({"min": [0, 0, 0], "path": [1, 1, 1]})", ""}))))
      << "the same key in two objects is good";
}

TEST(CaseFile, SaysWhenANameCannotBeWritten) {
  const TemporaryFolder folder;
  SurgicalCase plan = full_case(folder.path());
  plan.ct.path = folder / "M\xfcller";  // Latin-1
  expect_error(ErrorKind::output, {"case.json", "UTF-8"},
               [&] { write_case_file(plan, folder / "case.json"); });
}

TEST(CaseFile, RefusesWhatIsNoJsonObjectNamingThePlace) {
  const TemporaryFolder folder;
  expect_error(ErrorKind::input, {"none.json"}, [&] { read_case_file(folder / "none.json"); });
  expect_error(ErrorKind::input, {folder.path().string()}, [&] { read_case_file(folder.path()); });
  for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
           {"{\n \"ct\": {,}}", "line 2, column 9"},
           {"[1]", "object"},
           {"{\"name\": \"a\xff\"}", "UTF-8"},
           {"{\"motion\": {\"forward_mm\": 1e999}}", "1e999"},
           {"{} {}", "line 1"}}) {
    SCOPED_TRACE(text);
    const fs::path file = folder.write("case.json", text);
    expect_error(ErrorKind::case_file, {"case.json", part}, [&] { read_case_file(file); });
  }
}

class VerticesFile : public ::testing::Test {
 protected:
  std::vector<int> read(const std::string& text) {
    folder_.write("region.txt", text);
    const fs::path file =
        folder_.write("case.json", case_text({"region", R"({"vertices_file": "region.txt"})", ""}));
    return read_case_file(file).region.vertices;
  }
  TemporaryFolder folder_;
};

TEST_F(VerticesFile, HoldsNumbersSeparatedBySpacesOrLines) {
  EXPECT_EQ(read("3 1\r\n4\n\t1 5"), (std::vector<int>{3, 1, 4, 1, 5}));
}

TEST_F(VerticesFile, RefusesEverythingElse) {
  for (const char* bad : {"1 two 3", "1 2.5", "1 2 -", "1 2 99999999999", "0x10"}) {
    SCOPED_TRACE(bad);
    expect_error(ErrorKind::input, {"region.txt", "whole number"}, [&] { read(bad); });
  }
  expect_error(ErrorKind::input, {"region.txt", "no vertex"}, [&] { read(" \n"); });
  fs::remove(folder_ / "region.txt");
  const fs::path file = folder_ / "case.json";
  expect_error(ErrorKind::input, {"region.txt"}, [&] { read_case_file(file); });
}

}  // namespace
}  // namespace gnathion
