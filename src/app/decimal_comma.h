#pragma once

namespace gnathion {

/// Takes a comma that is typed into a number for its decimal point, in every window from now on.
/// Numbers have points here in every language, and a box that ignored the comma of another keyboard
/// or habit would read 1,5 as 15. Needs a QApplication.
void accept_decimal_comma();

}  // namespace gnathion
