#include "base/progress.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/error.h"
#include "support/expect_error.h"

namespace gnathion {
namespace {

TEST(Progress, NamesStagesWhenTheyBeginAndTimesThemWhenTheyEnd) {
  std::vector<std::string> heard;
  Progress progress([&](const std::string& stage) { heard.push_back(stage); });
  {
    const auto outer = progress.stage("outer");
    {
      const auto inner = progress.stage("inner");
      std::this_thread::sleep_for(std::chrono::milliseconds(3));
      EXPECT_EQ(heard, (std::vector<std::string>{"outer", "inner"}));
      EXPECT_TRUE(progress.stage_times().empty());
    }
  }
  const std::vector<StageTime> times = progress.stage_times();
  ASSERT_EQ(times.size(), 2U);
  EXPECT_EQ(times[0].name, "inner");
  EXPECT_EQ(times[1].name, "outer");
  EXPECT_GE(times[0].seconds, 0.003);
  EXPECT_GE(times[1].seconds, times[0].seconds);
}

TEST(Progress, KeepsAndTellsNotices) {
  std::string heard;
  Progress progress({}, [&](const std::string& notice) { heard = notice; });
  progress.notice("resampled");
  EXPECT_EQ(heard, "resampled");
  EXPECT_EQ(progress.notices(), std::vector<std::string>{"resampled"});
}

TEST(Progress, ACancelFromAnotherThreadEndsTheWork) {
  Progress progress;
  EXPECT_NO_THROW(progress.check());
  std::thread([&] { progress.cancel(); }).join();
  EXPECT_TRUE(progress.is_cancelled());
  test::expect_error(ErrorKind::cancelled, {"stopped"}, [&] { progress.check(); });
  test::expect_error(ErrorKind::cancelled, {"stopped"}, [&] { (void)progress.stage("next"); });
  EXPECT_TRUE(progress.stage_times().empty()) << "a stage that never began has a time";
}

}  // namespace
}  // namespace gnathion
