#pragma once

#include <cstddef>

#include "render/face_scene.h"

namespace gnathion {

/// How the n-th segment of a plan is shown, everywhere. Eight looks that stay apart for the common
/// colour-vision deficiencies (after Okabe and Ito 2008), then they begin again; none is red, which
/// is for what must not be cut.
BoneLook look_of_segment(std::size_t segment);

}  // namespace gnathion
