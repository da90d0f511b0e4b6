#pragma once

#include "bench/report.h"

namespace gnathion::bench {

/// Where the milliseconds of a frame go while a segment is dragged, software OpenGL, 1280×800: the
/// last case's bones under its CT's skin in fine triangles, whole and as the window draws it.
void report_frames(const Report& report, const std::vector<std::string>& cases);

}  // namespace gnathion::bench
