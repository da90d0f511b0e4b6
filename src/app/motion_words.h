#pragma once

#include <QString>

#include "plan/jaw_motion.h"

namespace gnathion {

/// A motion as a surgeon says it: "6 mm forward, 2° chin up"; "not moved".
QString motion_words(const JawMotion& motion);

/// A landmark's key as a label: "mouth_corner_left" gives "Mouth corner left".
QString landmark_words(const std::string& key);

}  // namespace gnathion
