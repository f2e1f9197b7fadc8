#pragma once

#include "render/image.hpp"
#include "render/point2.hpp"

#include <string_view>

/// Text in pictures. The letters are pen strokes, drawn like every other line: they are sharp at
/// any size and the same on every machine, which a font of the system is not.
namespace planetree::render {

/// How large text is: a small x is five units high, a digit seven, and the tail of a g goes two and
/// a half below the line.
struct TextSize {
  double unit = 1.0;  ///< in pixels
};

inline constexpr double kDigitHeight = 7.0;  ///< in units

/// How many pixels wide the text is.
[[nodiscard]] double textWidth(std::string_view text, TextSize size) noexcept;

/// Draws text that begins at `origin`, on the line. Letters of English, digits and the marks of
/// "+-.,:/()=_" are known; other characters leave a blank.
void drawText(Image& image, const Point2& origin, TextSize size, std::string_view text,
              const Rgb8& colour);

}  // namespace planetree::render
