#pragma once

#include <QString>

namespace gnathion {

/// Why no window can be opened, with what to do; empty when one can. Asked before a QApplication is
/// made, which would end the process without a display, as VTK would.
QString display_problem();

/// Chooses X11 with GLX, which VTK's windows need, and the surface format of the 3D view. Before a
/// QApplication is made.
void prepare_graphics();

/// Why the display cannot draw the 3D view; empty when it can. Needs a QApplication.
QString graphics_problem();

/// Decimal points everywhere: in what the window shows and takes, and in what the C library reads
/// and writes. A comma that is typed counts as a point. After a QApplication is made, which takes
/// the user's locale.
void use_c_numbers();

}  // namespace gnathion
