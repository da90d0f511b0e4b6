#include "io/own_inputs.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::expect_error;
using test::TemporaryFolder;

/// Two steps on images in folder/cache: the second has a photograph as well.
PlanHistory cached_history(const TemporaryFolder& folder) {
  folder.write("cache/ct/slice", "voxels");
  folder.write("cache/photograph/face.obj", "v 0 0 0");
  folder.write("cache/photograph/face.png", "colours");
  folder.write("cache/truth.json", "no input");
  SurgicalCase plan;
  plan.ct.path = folder / "cache/ct";
  PlanHistory history("Open", plan);
  plan.photograph = PhotographSource{folder / "cache/photograph/face.obj", {}};
  history.push("Add", plan);
  return history;
}

TEST(OwnInputs, PathsAreWithinByName) {
  EXPECT_TRUE(lies_within("/a/b/c", "/a/b"));
  EXPECT_TRUE(lies_within("/a/b/../b/c", "/a/./b"));
  EXPECT_FALSE(lies_within("/a/b", "/a/b"));
  EXPECT_FALSE(lies_within("/a/bc", "/a/b"));
  EXPECT_FALSE(lies_within("/a/b/../c", "/a/b"));
  EXPECT_FALSE(lies_within("", "/a"));
  EXPECT_FALSE(lies_within("/a", ""));
}

TEST(OwnInputs, CopiesOutliveTheOriginals) {
  const TemporaryFolder folder;
  const PlanHistory history = cached_history(folder);
  copy_inputs(history, folder / "cache", folder / "own");
  const PlanHistory own = with_copied_inputs(history, folder / "cache", folder / "own");
  fs::remove_all(folder / "cache");
  EXPECT_EQ(bytes_of(own.plan().ct.path / "slice"), "voxels");
  EXPECT_EQ(bytes_of(own.plan().photograph->obj), "v 0 0 0");
  EXPECT_EQ(bytes_of(own.plan().photograph->obj.parent_path() / "face.png"), "colours");
  EXPECT_FALSE(fs::exists(folder / "own/truth.json"));
  ASSERT_EQ(own.steps().size(), 2U);
  EXPECT_EQ(own.position(), 1U);
  EXPECT_EQ(own.steps()[0].plan->ct.path, folder / "own/ct");
  EXPECT_EQ(own.steps()[1].name, "Add");
}

TEST(OwnInputs, WhatLiesElsewhereStays) {
  const TemporaryFolder folder;
  SurgicalCase plan;
  plan.ct.path = "/elsewhere/ct";
  EXPECT_EQ(with_copied_inputs(plan, folder / "cache", folder / "own"), plan);
}

TEST(OwnInputs, FailureLeavesNothing) {
  const TemporaryFolder folder;
  const PlanHistory history = cached_history(folder);
  fs::remove_all(folder / "cache/ct");
  expect_error(ErrorKind::input, {"cache/ct", "open the case again"},
               [&] { copy_inputs(history, folder / "cache", folder / "own"); });
  EXPECT_FALSE(fs::exists(folder / "own"));
  fs::create_directory(folder / "own");
  expect_error(ErrorKind::output, {"own", "exists"},
               [&] { copy_inputs(history, folder / "cache", folder / "own"); });
}

}  // namespace
}  // namespace gnathion
