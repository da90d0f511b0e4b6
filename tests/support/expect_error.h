#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"

namespace gnathion::test {

/// Runs `work`, which must throw an Error of this kind whose message holds all of `parts`.
template <typename Work>
void expect_error(ErrorKind kind, const std::vector<std::string>& parts, Work work) {
  try {
    work();
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_FALSE(error.remedy().empty());
    for (const std::string& part : parts) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
          << "no \"" << part << "\" in: " << error.what();
    }
  }
}

}  // namespace gnathion::test
