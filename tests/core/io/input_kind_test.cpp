#include "io/input_kind.h"

#include <gtest/gtest.h>

#include <utility>

#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace gnathion {
namespace {

using test::expect_error;
using test::TemporaryFolder;

TEST(InputKind, IsToldByTheName) {
  const TemporaryFolder folder;
  EXPECT_EQ(input_kind(folder.path()), InputKind::dicom_folder);
  const std::pair<const char*, InputKind> names[] = {
      {"a.json", InputKind::case_file}, {"a.gnathion.json", InputKind::case_file},
      {"A.OBJ", InputKind::photograph}, {"a.mha", InputKind::volume},
      {"a.mhd", InputKind::volume},     {"a.nrrd", InputKind::volume},
      {"a.nhdr", InputKind::volume},    {"a.nii", InputKind::volume},
      {"a.b.NII.GZ", InputKind::volume}};
  for (const auto& [name, kind] : names) {
    EXPECT_EQ(input_kind(folder.write(name, "x")), kind) << name;
  }
}

TEST(InputKind, OthersAreRefusedWithWhatToDo) {
  const TemporaryFolder folder;
  expect_error(ErrorKind::input, {"absent.json", "does not exist"},
               [&] { input_kind(folder / "absent.json"); });
  expect_error(ErrorKind::input, {"a.dcm", "folder that holds the series"},
               [&] { input_kind(folder.write("a.dcm", "x")); });
  expect_error(ErrorKind::input, {"a.gz", ".nii.gz"},
               [&] { input_kind(folder.write("a.gz", "x")); });
  expect_error(ErrorKind::input, {"letter.docx", ".json"},
               [&] { input_kind(folder.write("letter.docx", "x")); });
}

}  // namespace
}  // namespace gnathion
