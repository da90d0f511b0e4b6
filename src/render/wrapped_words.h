#pragma once

#include <string>

namespace gnathion {

/// UTF-8 text with its lines broken at blanks so that none has more than `most` characters, but for
/// words that alone are longer. Line breaks that are there stay. \pre most > 0
std::string wrapped(const std::string& text, int most);

}  // namespace gnathion
