#include "support/text_lines.hpp"

namespace planetree::detail {

std::string quoted(std::string_view word) {
  constexpr std::size_t kLongest = 32;
  std::string text = "\"";
  for (const char c : word.substr(0, kLongest)) {
    const bool isPrintable = c >= ' ' && c <= '~';
    text += isPrintable ? c : '?';
  }
  if (word.size() > kLongest)
    text += "...";
  return text + "\"";
}

}  // namespace planetree::detail
