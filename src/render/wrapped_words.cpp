#include "render/wrapped_words.h"

#include <sstream>

namespace gnathion {
namespace {

int characters(const std::string& word) {
  int count = 0;
  for (const char c : word) {
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) ++count;  // no continuation byte
  }
  return count;
}

}  // namespace

std::string wrapped(const std::string& text, int most) {
  std::istringstream lines(text);
  std::string result, line, word;
  while (std::getline(lines, line)) {
    if (!result.empty()) result += '\n';
    std::istringstream words(line);
    int filled = 0;
    while (words >> word) {
      const int length = characters(word);
      if (filled > 0) {
        const bool fits = filled + 1 + length <= most;
        result += fits ? ' ' : '\n';
        filled = fits ? filled + 1 : 0;
      }
      result += word;
      filled += length;
    }
  }
  return result;
}

}  // namespace gnathion
