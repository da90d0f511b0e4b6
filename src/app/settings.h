#pragma once

#include <QSettings>

namespace gnathion {

/// What the window remembers between two starts: gnathion.ini in the user's configuration folder.
QSettings window_settings();

}  // namespace gnathion
