#include "imaging/series_use.h"

#include <gtest/gtest.h>

namespace gnathion {
namespace {

TEST(SeriesUse, OnlyCtVolumesAreUsable) {
  SeriesSummary series;
  series.modality = "CT";
  series.slices = 3;
  EXPECT_EQ(use_of(series), SeriesUse::usable);
  series.slices = 2;
  EXPECT_EQ(use_of(series), SeriesUse::too_few);
  series.slices = 200;
  series.modality = "MR";
  EXPECT_EQ(use_of(series), SeriesUse::not_ct);
  series.modality = "";
  EXPECT_EQ(use_of(series), SeriesUse::not_ct);
}

}  // namespace
}  // namespace gnathion
