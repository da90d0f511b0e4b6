#pragma once

#include <QString>
#include <QStringList>

#include "bone/collision.h"
#include "plan/jaw_motion.h"

namespace gnathion {

/// A motion as a surgeon says it: "6 mm forward, 2° chin up"; "not moved". To the hundredth, as
/// the numbers are shown.
QString motion_words(const JawMotion& motion);

/// "Chin runs 1.8 mm into the fixed bone (left)". segments: their names; middle_x: the head's, mm.
QString collision_words(const Collision& collision, const QStringList& segments, double middle_x);

/// A landmark's key as a label: "mouth_corner_left" gives "Mouth corner left".
QString landmark_words(const std::string& key);

}  // namespace gnathion
