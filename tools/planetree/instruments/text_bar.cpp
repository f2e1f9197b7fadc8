#include "instruments/text_bar.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace planetree::tool {

namespace {

constexpr std::array kEighths = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};

// Every character begins with a byte that is not of the form 10xxxxxx.
bool beginsCharacter(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
}

std::string blanks(std::string_view text, std::size_t width) {
  const std::size_t taken = columnCount(text);
  return std::string(width > taken ? width - taken : 0, ' ');
}

}  // namespace

std::string textBar(double value, double highest, std::size_t width) {
  if (!(value > 0.0) || !(highest > 0.0))
    return "";
  const double share = std::min(value / highest, 1.0);
  const auto eighths = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lround(8.0 * share * static_cast<double>(width))));
  std::string bar;
  for (std::size_t column = 0; column < eighths / 8; ++column)
    bar += "█";
  return bar + kEighths[eighths % 8];
}

std::size_t columnCount(std::string_view text) noexcept {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), beginsCharacter));
}

std::string shortened(std::string_view text, std::size_t width) {
  std::string kept(text);
  if (columnCount(text) <= width)
    return kept;
  while (columnCount(kept) >= width) {
    while (!beginsCharacter(kept.back()))
      kept.pop_back();
    kept.pop_back();
  }
  return kept + "…";
}

std::string padded(std::string text, std::size_t width) {
  return text.append(blanks(text, width));
}

std::string paddedLeft(const std::string& text, std::size_t width) {
  return blanks(text, width) + text;
}

}  // namespace planetree::tool
