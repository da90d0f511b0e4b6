#pragma once

#include <QColor>
#include <QPalette>

class QAction;

namespace gnathion {

/// The colours of the window.
enum class Theme {
  system,  ///< the desktop's
  light,
  dark,
};

/// The one that was chosen last.
Theme chosen_theme();
/// Changes all windows at once, and is remembered. Needs a QApplication.
void choose_theme(Theme theme);
/// As it was chosen last; to be called once, before any window is made.
void start_theme();
/// One of three actions, checked by what is chosen.
void connect_theme_actions(QAction& system, QAction& light, QAction& dark);

/// For words that warn, legible on the palette's window colour.
QColor warning_colour(const QPalette& palette);

}  // namespace gnathion
