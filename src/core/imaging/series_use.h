#pragma once

#include "imaging/dicom_series.h"

namespace gnathion {

/// Whether a series can become a case, and why not.
enum class SeriesUse {
  usable,
  not_ct,   ///< its values are no Hounsfield units
  too_few,  ///< a scout view or a single slice: no volume
};

/// By its summary alone; reading may still find fault with it.
SeriesUse use_of(const SeriesSummary& series);

}  // namespace gnathion
