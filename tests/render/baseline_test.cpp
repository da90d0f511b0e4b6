#include "render/baseline.h"

#include <gtest/gtest.h>

namespace gnathion::test {
namespace {

class Baseline : public testing::Test {
 protected:
  Baseline() {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~Baseline() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("gnathion_baseline_" + std::to_string(::getpid()));
  Picture grey{20, 10, std::vector<std::uint8_t>(600, 128)};
};

TEST_F(Baseline, MissingOneFailsAndSavesTheCandidate) {
  EXPECT_FALSE(matches_baseline(grey, folder / "a.png", folder / "candidates"));
  EXPECT_EQ(read_picture_file(folder / "candidates" / "a.png"), grey);
}

TEST_F(Baseline, EqualOneSucceedsAndSavesNothing) {
  write_png(grey, folder / "a.png");
  EXPECT_TRUE(matches_baseline(grey, folder / "a.png", folder / "candidates"));
  EXPECT_FALSE(std::filesystem::exists(folder / "candidates" / "a.png"));
}

TEST_F(Baseline, FewFarPixelsFailAndSaveTheDifference) {
  write_png(grey, folder / "a.png");
  Picture other = grey;
  other.rgb[3 * 7] = 200;  // one of 200 pixels: 0.5 %
  EXPECT_FALSE(matches_baseline(other, folder / "a.png", folder / "candidates"));
  EXPECT_EQ(read_picture_file(folder / "candidates" / "a.png"), other);
  const Picture shown = read_picture_file(folder / "candidates" / "a.difference.png");
  EXPECT_EQ(shown.rgb[3 * 7], 0);
  EXPECT_EQ(shown.rgb[3 * 8], 255);
}

TEST_F(Baseline, SlightChangeEverywhereFails) {
  write_png(grey, folder / "a.png");
  Picture other = grey;
  for (auto& channel : other.rgb) ++channel;
  EXPECT_FALSE(matches_baseline(other, folder / "a.png", folder / "candidates"));
}

TEST_F(Baseline, AnotherSizeFails) {
  write_png(grey, folder / "a.png");
  EXPECT_FALSE(matches_baseline(Picture{10, 20, grey.rgb}, folder / "a.png", folder / "c"));
}

}  // namespace
}  // namespace gnathion::test
