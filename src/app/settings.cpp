#include "app/settings.h"

namespace gnathion {

QSettings window_settings() {
  return {QSettings::IniFormat, QSettings::UserScope, "gnathion", "gnathion"};
}

}  // namespace gnathion
