#include "imaging/series_use.h"

namespace gnathion {

SeriesUse use_of(const SeriesSummary& series) {
  constexpr int fewest_slices = 3;  // an even step between slices cannot be told from fewer
  if (series.modality != "CT") return SeriesUse::not_ct;
  return series.slices < fewest_slices ? SeriesUse::too_few : SeriesUse::usable;
}

}  // namespace gnathion
