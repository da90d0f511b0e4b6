#include "base/error.h"

#include <gtest/gtest.h>

namespace gnathion {
namespace {

TEST(Error, SaysSubjectProblemAndRemedyInOneLine) {
  const Error error(ErrorKind::input, "face.obj", "it has no faces", "export it again");
  EXPECT_STREQ(error.what(), "face.obj: it has no faces; export it again");
  EXPECT_EQ(error.kind(), ErrorKind::input);
  EXPECT_EQ(error.subject(), "face.obj");
  EXPECT_EQ(error.problem(), "it has no faces");
  EXPECT_EQ(error.remedy(), "export it again");
}

TEST(Error, KindsAreTheDocumentedExitCodes) {
  EXPECT_EQ(static_cast<int>(ErrorKind::usage), 2);
  EXPECT_EQ(static_cast<int>(ErrorKind::case_file), 3);
  EXPECT_EQ(static_cast<int>(ErrorKind::input), 4);
  EXPECT_EQ(static_cast<int>(ErrorKind::anatomy), 5);
  EXPECT_EQ(static_cast<int>(ErrorKind::numeric), 6);
  EXPECT_EQ(static_cast<int>(ErrorKind::output), 7);
  EXPECT_EQ(static_cast<int>(ErrorKind::cancelled), 8);
}

}  // namespace
}  // namespace gnathion
