#include "io/files.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::expect_error;
using test::TemporaryFolder;

int entries_of(const fs::path& folder) {
  int count = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder)) ++count;
  return count;
}

TEST(TextFile, ComesBackToTheByte) {
  const TemporaryFolder folder;
  const std::string text("line\r\nsecond\0third\n", 19);
  write_text_file(folder / "a b.txt", text);
  EXPECT_EQ(read_text_file(folder / "a b.txt"), text);
}

TEST(TextFile, RefusesWhatIsMissingEmptyOrNoFile) {
  const TemporaryFolder folder;
  folder.write("empty", "");
  expect_error(ErrorKind::input, {"none"}, [&] { read_text_file(folder / "none"); });
  expect_error(ErrorKind::input, {"empty"}, [&] { read_text_file(folder / "empty"); });
  expect_error(ErrorKind::input, {folder.path().string()}, [&] { read_text_file(folder.path()); });
  expect_error(ErrorKind::output, {"none/a.txt"},
               [&] { write_text_file(folder / "none/a.txt", "text"); });
}

TEST(TextFile, AFullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  expect_error(ErrorKind::output, {"/dev/full"}, [] { write_text_file("/dev/full", "text"); });
}

TEST(Sha256, OfAKnownText) {
  const TemporaryFolder folder;
  EXPECT_EQ(sha256_of(folder.write("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of(folder.write("empty", "")),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  expect_error(ErrorKind::input, {"none"}, [&] { sha256_of(folder / "none"); });
}

TEST(Sha256, OfAFolderDependsOnContentsAndNamesButNotOnItsPlace) {
  const TemporaryFolder first, second;
  for (const TemporaryFolder* folder : {&first, &second}) {
    folder->write("b", "2");
    folder->write("sub/a", "1");
  }
  const std::string hash = sha256_of(first.path());
  EXPECT_EQ(sha256_of(second.path()), hash);
  second.write("sub/a", "3");
  EXPECT_NE(sha256_of(second.path()), hash);
  second.write("sub/a", "1");
  fs::rename(second / "b", second / "c");
  EXPECT_NE(sha256_of(second.path()), hash);
}

TEST(NewFolder, AppearsWholeOnPublish) {
  const TemporaryFolder parent;
  const fs::path target = parent / "Ergebnis für später";
  {
    NewFolder folder(target);
    write_text_file(folder.path() / "a.txt", "a");
    EXPECT_FALSE(fs::exists(target));
    folder.publish();
  }
  EXPECT_EQ(bytes_of(target / "a.txt"), "a");
  EXPECT_EQ(entries_of(parent.path()), 1);
}

TEST(NewFolder, LeavesNothingWithoutPublish) {
  const TemporaryFolder parent;
  try {
    const NewFolder folder(parent / "out");
    write_text_file(folder.path() / "a.txt", "a");
    throw Error(ErrorKind::numeric, "solver", "stopped", "try again");
  } catch (const Error&) {
    EXPECT_EQ(entries_of(parent.path()), 0);
  }
}

TEST(NewFolder, TakesASlashAtTheEnd) {
  const TemporaryFolder parent;
  NewFolder(parent.path() / "out/").publish();
  EXPECT_TRUE(fs::is_directory(parent / "out"));
}

TEST(NewFolder, RefusesATargetThatExists) {
  const TemporaryFolder parent;
  fs::create_directory(parent / "folder");
  parent.write("file", "text");
  fs::create_symlink("nowhere", parent / "link");
  for (const char* name : {"folder", "file", "link"}) {
    expect_error(ErrorKind::output, {name, "exists"}, [&] { NewFolder(parent / name); });
  }
  EXPECT_EQ(entries_of(parent.path()), 3);
  EXPECT_EQ(bytes_of(parent / "file"), "text");
}

TEST(NewFolder, RefusesATargetThatCameIntoBeingMeanwhile) {
  const TemporaryFolder parent;
  {
    NewFolder folder(parent / "out");
    parent.write("out/theirs", "theirs");
    expect_error(ErrorKind::output, {"out"}, [&] { folder.publish(); });
  }
  EXPECT_EQ(entries_of(parent.path()), 1);
  EXPECT_EQ(bytes_of(parent / "out/theirs"), "theirs");
}

TEST(NewFolder, RefusesAParentThatIsMissingOrNotWritable) {
  const TemporaryFolder parent;
  parent.write("file", "text");
  expect_error(ErrorKind::output, {"none"}, [&] { NewFolder(parent / "none/out"); });
  expect_error(ErrorKind::output, {"file"}, [&] { NewFolder(parent / "file/out"); });
  expect_error(ErrorKind::output, {"/proc"}, [] { NewFolder("/proc/out"); });
  expect_error(ErrorKind::output, {"no name"}, [] { NewFolder(""); });
}

TEST(NewFolder, DoesNotPublishWhatAKilledProgramLeftBehind) {
  const TemporaryFolder parent;
  // A program of the same number, as happens in containers, was killed while it wrote.
  const fs::path left = [&] { return NewFolder(parent / "out").path(); }();
  fs::create_directory(left);
  write_text_file(left / "stale", "stale");
  NewFolder folder(parent / "out");
  folder.publish();
  EXPECT_EQ(entries_of(parent / "out"), 0);
}

}  // namespace
}  // namespace gnathion
