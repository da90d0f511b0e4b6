#pragma once

#include <functional>

#include "base/progress.h"

namespace gnathion {

/// Calls work(row) for every row in [0, count) on the machine's threads, at most `threads` (0: as
/// many as there are cores). Rows must be independent. Throws Error(cancelled) when the user
/// cancels, and what `work` throws.
void for_each_row(int count, unsigned threads, Progress& progress,
                  const std::function<void(int)>& work);

}  // namespace gnathion
