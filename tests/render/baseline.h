#pragma once

#include <gtest/gtest.h>
#include <filesystem>
#include <string>

#include "render/picture.h"

namespace gnathion::test {

/// How two pictures of one size differ.
struct PictureDifference {
  double mean = 0;        ///< mean absolute difference of a channel, 0..255
  double far_pixels = 0;  ///< fraction of pixels with a channel more than 32 apart
};
PictureDifference difference(const Picture& a, const Picture& b);

/// Succeeds when the picture equals the stored PNG but for what another processor's rounding does
/// (mean ≤ 0.8, far pixels ≤ 0.4 %). A missing, unreadable or differing baseline fails; then the
/// candidate and, when there are two pictures to compare, their difference are saved in
/// `candidates`, and the message names them. A baseline is accepted by copying the candidate over
/// it, after looking at it.
testing::AssertionResult matches_baseline(const Picture& picture,
                                          const std::filesystem::path& baseline,
                                          const std::filesystem::path& candidates);

/// The same for tests/baselines/<name>.png, candidates in the build folder.
testing::AssertionResult matches_baseline(const Picture& picture, const std::string& name);

}  // namespace gnathion::test
