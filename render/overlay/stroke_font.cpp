#include "render/overlay/stroke_font.hpp"

#include "render/overlay/line_coverage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace planetree::render {

namespace {

constexpr double kPenWidth = 0.92;
constexpr double kLetterGap = 1.75;
constexpr double kBlankWidth = 1.6;

/// A character as the way of a pen: M moves it, L draws a straight line, Q a parabola with one
/// control point. x goes to the right, y up from the line that the text stands on, in units.
struct Glyph {
  char character;
  double width;
  std::string_view strokes;
};

constexpr std::array kGlyphs = {
    Glyph{'0', 4.2, "M2.1 7 Q4.2 7 4.2 3.5 Q4.2 0 2.1 0 Q0 0 0 3.5 Q0 7 2.1 7"},
    Glyph{'1', 2.2, "M0 5.6 L1.8 7 L1.8 0"},
    Glyph{'2', 4.2, "M0.2 5.4 Q0.4 7 2.1 7 Q4 7 4 5.2 Q4 3.9 2.6 2.6 L0 0 L4.2 0"},
    Glyph{'3', 4.2,
          "M0.3 5.8 Q0.7 7 2.1 7 Q3.9 7 3.9 5.3 Q3.9 3.7 1.6 3.7 Q4.2 3.7 4.2 1.9 Q4.2 0 2.1 0 "
          "Q0.4 0 0 1.4"},
    Glyph{'4', 4.2, "M3.3 0 L3.3 7 L0 2 L4.4 2"},
    Glyph{'5', 4.2,
          "M3.9 7 L0.8 7 L0.5 3.8 Q1.2 4.5 2.2 4.5 Q4.2 4.5 4.2 2.25 Q4.2 0 2.1 0 Q0.5 0 0 1.2"},
    Glyph{'6', 4.2,
          "M3.8 6.2 Q3.3 7 2.3 7 Q0 7 0 3 Q0 0 2.1 0 Q4.2 0 4.2 2.2 Q4.2 4.3 2.2 4.3 Q0.5 4.3 0 "
          "2.6"},
    Glyph{'7', 4.2, "M0 7 L4.2 7 L1.5 0"},
    Glyph{'8', 4.2,
          "M2.1 3.8 Q3.9 3.8 3.9 5.4 Q3.9 7 2.1 7 Q0.3 7 0.3 5.4 Q0.3 3.8 2.1 3.8 Q4.2 3.8 4.2 1.9 "
          "Q4.2 0 2.1 0 Q0 0 0 1.9 Q0 3.8 2.1 3.8"},
    Glyph{'9', 4.2,
          "M0.4 0.8 Q0.9 0 1.9 0 Q4.2 0 4.2 4 Q4.2 7 2.1 7 Q0 7 0 4.8 Q0 2.7 2 2.7 Q3.7 2.7 4.2 "
          "4.4"},
    Glyph{'a', 3.5,
          "M0.4 4.3 Q0.9 5 1.8 5 Q3.5 5 3.5 3.3 L3.5 0 M3.5 2.9 L1.9 2.9 Q0 2.9 0 1.45 Q0 0 1.5 0 "
          "Q3 0 3.5 1.6"},
    Glyph{'b', 3.9, "M0 7.4 L0 0 M0 2.5 Q0 5 2 5 Q3.9 5 3.9 2.5 Q3.9 0 2 0 Q0 0 0 2.5"},
    Glyph{'c', 3.4, "M3.5 4.1 Q3 5 2 5 Q0 5 0 2.5 Q0 0 2 0 Q3 0 3.5 0.9"},
    Glyph{'d', 3.9, "M3.9 7.4 L3.9 0 M3.9 2.5 Q3.9 5 1.9 5 Q0 5 0 2.5 Q0 0 1.9 0 Q3.9 0 3.9 2.5"},
    Glyph{'e', 3.9, "M0 2.7 L3.9 2.7 Q3.9 5 2 5 Q0 5 0 2.5 Q0 0 2.1 0 Q3.1 0 3.7 0.9"},
    Glyph{'f', 2.1, "M2.6 7.2 Q0.9 7.5 0.9 5.8 L0.9 0 M-0.2 5 L2.3 5"},
    Glyph{'g', 3.9,
          "M3.9 5 L3.9 -0.4 Q3.9 -2.3 1.9 -2.3 Q0.8 -2.3 0.3 -1.6 M3.9 2.5 Q3.9 5 1.9 5 Q0 5 0 2.5 "
          "Q0 0 1.9 0 Q3.9 0 3.9 2.5"},
    Glyph{'h', 3.6, "M0 7.4 L0 0 M0 2.8 Q0.3 5 1.9 5 Q3.6 5 3.6 3 L3.6 0"},
    Glyph{'i', 0.0, "M0 5 L0 0 M0 7 L0 7"},
    Glyph{'j', 0.7, "M0.7 5 L0.7 -1 Q0.7 -2.3 -0.5 -2.3 M0.7 7 L0.7 7"},
    Glyph{'k', 3.4, "M0 7.4 L0 0 M3.2 5 L0 2 M1.3 3.2 L3.5 0"},
    Glyph{'l', 0.0, "M0 7.4 L0 0"},
    Glyph{'m', 5.8,
          "M0 5 L0 0 M0 2.8 Q0.2 5 1.6 5 Q2.9 5 2.9 3.2 L2.9 0 M2.9 2.8 Q3.1 5 4.5 5 Q5.8 5 5.8 "
          "3.2 L5.8 0"},
    Glyph{'n', 3.6, "M0 5 L0 0 M0 2.8 Q0.3 5 1.9 5 Q3.6 5 3.6 3 L3.6 0"},
    Glyph{'o', 3.9, "M1.95 5 Q3.9 5 3.9 2.5 Q3.9 0 1.95 0 Q0 0 0 2.5 Q0 5 1.95 5"},
    Glyph{'p', 3.9, "M0 5 L0 -2.3 M0 2.5 Q0 5 2 5 Q3.9 5 3.9 2.5 Q3.9 0 2 0 Q0 0 0 2.5"},
    Glyph{'q', 3.9, "M3.9 5 L3.9 -2.3 M3.9 2.5 Q3.9 5 1.9 5 Q0 5 0 2.5 Q0 0 1.9 0 Q3.9 0 3.9 2.5"},
    Glyph{'r', 2.0, "M0 5 L0 0 M0 2.6 Q0.3 5 2.2 4.9"},
    Glyph{'s', 3.2,
          "M3.1 4.2 Q2.7 5 1.7 5 Q0.2 5 0.2 3.8 Q0.2 2.8 1.7 2.55 Q3.3 2.3 3.3 1.25 Q3.3 0 1.7 0 "
          "Q0.5 0 0 0.9"},
    Glyph{'t', 2.1, "M0.9 6.6 L0.9 1.4 Q0.9 -0.2 2.4 0.1 M-0.2 5 L2.2 5"},
    Glyph{'u', 3.6, "M0 5 L0 2 Q0 0 1.7 0 Q3.3 0 3.6 2.2 M3.6 5 L3.6 0"},
    Glyph{'v', 3.6, "M0 5 L1.8 0 L3.6 5"},
    Glyph{'w', 5.4, "M0 5 L1.35 0 L2.7 5 L4.05 0 L5.4 5"},
    Glyph{'x', 3.4, "M0 5 L3.4 0 M3.4 5 L0 0"},
    Glyph{'y', 3.6, "M0 5 L1.8 0 M3.6 5 L1.3 -1.6 Q0.9 -2.4 0 -2.2"},
    Glyph{'z', 3.4, "M0 5 L3.3 5 L0 0 L3.5 0"},
    Glyph{'A', 4.8, "M0 0 L2.4 7 L4.8 0 M0.8 2.3 L4 2.3"},
    Glyph{
        'B', 4.1,
        "M0 0 L0 7 L2 7 Q3.8 7 3.8 5.35 Q3.8 3.7 2 3.7 L0 3.7 M2 3.7 Q4.1 3.7 4.1 1.85 Q4.1 0 2 0 "
        "L0 0"},
    Glyph{'C', 4.8, "M4.8 5.7 Q4.1 7 2.7 7 Q0 7 0 3.5 Q0 0 2.7 0 Q4.1 0 4.8 1.3"},
    Glyph{'D', 4.6, "M0 0 L0 7 L1.6 7 Q4.6 7 4.6 3.5 Q4.6 0 1.6 0 L0 0"},
    Glyph{'E', 3.8, "M3.8 7 L0 7 L0 0 L3.8 0 M0 3.7 L3.3 3.7"},
    Glyph{'F', 3.6, "M3.6 7 L0 7 L0 0 M0 3.6 L3.1 3.6"},
    Glyph{'G', 5.0, "M4.8 5.7 Q4.1 7 2.7 7 Q0 7 0 3.5 Q0 0 2.7 0 Q4.2 0 5 1 L5 3.2 L3 3.2"},
    Glyph{'H', 4.6, "M0 0 L0 7 M4.6 0 L4.6 7 M0 3.7 L4.6 3.7"},
    Glyph{'I', 0.0, "M0 0 L0 7"},
    Glyph{'J', 2.8, "M2.8 7 L2.8 2 Q2.8 0 1.3 0 Q0.1 0 0 1.3"},
    Glyph{'K', 4.3, "M0 0 L0 7 M4.1 7 L0 2.6 M1.5 4.2 L4.3 0"},
    Glyph{'L', 3.5, "M0 7 L0 0 L3.5 0"},
    Glyph{'M', 5.6, "M0 0 L0 7 L2.8 1.8 L5.6 7 L5.6 0"},
    Glyph{'N', 4.6, "M0 0 L0 7 L4.6 0 L4.6 7"},
    Glyph{'O', 5.4, "M2.7 7 Q5.4 7 5.4 3.5 Q5.4 0 2.7 0 Q0 0 0 3.5 Q0 7 2.7 7"},
    Glyph{'P', 4.0, "M0 0 L0 7 L2 7 Q4 7 4 5.1 Q4 3.2 2 3.2 L0 3.2"},
    Glyph{'Q', 5.4, "M2.7 7 Q5.4 7 5.4 3.5 Q5.4 0 2.7 0 Q0 0 0 3.5 Q0 7 2.7 7 M3.3 1.7 L5.4 -0.6"},
    Glyph{'R', 4.2, "M0 0 L0 7 L2 7 Q3.9 7 3.9 5.2 Q3.9 3.4 2 3.4 L0 3.4 M2 3.4 L4.2 0"},
    Glyph{'S', 4.1,
          "M3.9 5.8 Q3.3 7 2.1 7 Q0.2 7 0.2 5.3 Q0.2 4 2.1 3.65 Q4.1 3.2 4.1 1.8 Q4.1 0 2.1 0 "
          "Q0.6 0 0 1.3"},
    Glyph{'T', 4.6, "M0 7 L4.6 7 M2.3 7 L2.3 0"},
    Glyph{'U', 4.5, "M0 7 L0 2.4 Q0 0 2.25 0 Q4.5 0 4.5 2.4 L4.5 7"},
    Glyph{'V', 4.6, "M0 7 L2.3 0 L4.6 7"},
    Glyph{'W', 6.8, "M0 7 L1.7 0 L3.4 7 L5.1 0 L6.8 7"},
    Glyph{'X', 4.4, "M0 0 L4.4 7 M0 7 L4.4 0"},
    Glyph{'Y', 4.6, "M0 7 L2.3 3.5 L4.6 7 M2.3 3.5 L2.3 0"},
    Glyph{'Z', 4.4, "M0 7 L4.4 7 L0 0 L4.4 0"},
    Glyph{'_', 3.6, "M0 -0.6 L3.6 -0.6"},
    Glyph{'.', 0.0, "M0 0.1 L0 0.1"},
    Glyph{',', 0.2, "M0.2 0.1 L0 -1.2"},
    Glyph{':', 0.0, "M0 0.1 L0 0.1 M0 3.9 L0 3.9"},
    Glyph{'+', 3.6, "M0 2.6 L3.6 2.6 M1.8 4.4 L1.8 0.8"},
    Glyph{'-', 2.4, "M0 2.6 L2.4 2.6"},
    Glyph{'=', 3.6, "M0 3.5 L3.6 3.5 M0 1.7 L3.6 1.7"},
    Glyph{'/', 2.6, "M0 -0.8 L2.6 7.4"},
    Glyph{'(', 1.3, "M1.4 7.8 Q-1.2 3 1.4 -1.8"},
    Glyph{')', 1.3, "M-0.1 7.8 Q2.5 3 -0.1 -1.8"},
};

const Glyph* glyphOf(char character) noexcept {
  const auto* const glyph =
      std::find_if(kGlyphs.begin(), kGlyphs.end(),
                   [character](const Glyph& g) { return g.character == character; });
  return glyph == kGlyphs.end() ? nullptr : glyph;
}

/// Reads the strokes of a glyph.
class StrokeReader {
 public:
  explicit StrokeReader(std::string_view strokes) noexcept : rest_(strokes) {}

  /// The next letter, or 0 at the end.
  char command() noexcept {
    skipBlanks();
    if (rest_.empty())
      return 0;
    const char letter = rest_.front();
    rest_.remove_prefix(1);
    return letter;
  }

  Point2 point() noexcept {
    const double x = number();
    return {x, number()};
  }

 private:
  void skipBlanks() noexcept {
    while (!rest_.empty() && rest_.front() == ' ')
      rest_.remove_prefix(1);
  }

  /// Such as 4, -0.5 or 1.45: all that the table above has.
  double number() noexcept {
    skipBlanks();
    const bool isNegative = rest_.front() == '-';
    if (isNegative)
      rest_.remove_prefix(1);
    double value = 0.0;
    double digitValue = 0.0;  // of the next digit behind the point
    for (; !rest_.empty(); rest_.remove_prefix(1)) {
      const char c = rest_.front();
      if (c == '.')
        digitValue = 0.1;
      else if (c < '0' || c > '9')
        break;
      else if (digitValue == 0.0)
        value = 10.0 * value + (c - '0');
      else {
        value += digitValue * (c - '0');
        digitValue /= 10.0;
      }
    }
    return isNegative ? -value : value;
  }

  std::string_view rest_;
};

/// How much of each pixel ink covers. Strokes that cross do not get darker there.
class Ink {
 public:
  explicit Ink(ImageSize size) : size_(size), coverages_(size.pixelCount()) {}

  void draw(const Line2& line, double width) {
    forEachCoveredPixel(line, width, size_,
                        [this](std::uint32_t x, std::uint32_t y, double coverage, double) {
                          float& pixel = coverages_[static_cast<std::size_t>(y) * size_.width + x];
                          pixel = std::max(pixel, static_cast<float>(coverage));
                        });
  }

  void paint(Image& image, const Rgb8& colour) const {
    for (std::size_t i = 0; i < coverages_.size(); ++i) {
      if (coverages_[i] > 0.0f)
        image.pixels[i] = mixed(image.pixels[i], colour, coverages_[i]);
    }
  }

 private:
  static Rgb8 mixed(const Rgb8& below, const Rgb8& above, float weight) noexcept {
    const auto channel = [weight](std::uint8_t a, std::uint8_t b) {
      return static_cast<std::uint8_t>(
          std::lround(static_cast<float>(a) + weight * static_cast<float>(b - a)));
    };
    return {channel(below.red, above.red), channel(below.green, above.green),
            channel(below.blue, above.blue)};
  }

  ImageSize size_;
  std::vector<float> coverages_;
};

/// A pen that draws one glyph.
class Pen {
 public:
  Pen(Ink& ink, const Point2& origin, TextSize size) noexcept
      : ink_(ink), origin_(origin), unit_(size.unit) {}

  void draw(const Glyph& glyph) {
    StrokeReader strokes(glyph.strokes);
    Point2 at;
    for (char command = strokes.command(); command != 0; command = strokes.command()) {
      const Point2 next = strokes.point();
      if (command == 'L')
        drawLine(at, next);
      if (command != 'Q') {
        at = next;
        continue;
      }
      const Point2 end = strokes.point();
      drawCurve(at, next, end);
      at = end;
    }
  }

 private:
  [[nodiscard]] Point2 pixel(const Point2& point) const noexcept {
    return {origin_.x + point.x * unit_, origin_.y - point.y * unit_};
  }

  void drawLine(const Point2& a, const Point2& b) {
    ink_.draw({pixel(a), pixel(b)}, std::max(1.0, kPenWidth * unit_));
  }

  void drawCurve(const Point2& begin, const Point2& control, const Point2& end) {
    constexpr int kPieces = 12;
    Point2 at = begin;
    for (int i = 1; i <= kPieces; ++i) {
      const double t = static_cast<double>(i) / kPieces;
      const double a = (1.0 - t) * (1.0 - t);
      const double b = 2.0 * t * (1.0 - t);
      const double c = t * t;
      const Point2 next{a * begin.x + b * control.x + c * end.x,
                        a * begin.y + b * control.y + c * end.y};
      drawLine(at, next);
      at = next;
    }
  }

  Ink& ink_;
  Point2 origin_;
  double unit_;
};

double advance(char character) noexcept {
  const Glyph* const glyph = glyphOf(character);
  return kLetterGap + (glyph == nullptr ? kBlankWidth : glyph->width);
}

/// The middle of the nearest pixel: upright strokes there are one sharp column.
double snapped(double place) noexcept {
  return std::floor(place) + 0.5;
}

}  // namespace

double textWidth(std::string_view text, TextSize size) noexcept {
  double width = text.empty() ? 0.0 : -kLetterGap;
  for (const char character : text)
    width += advance(character);
  return width * size.unit;
}

void drawText(Image& image, const Point2& origin, TextSize size, std::string_view text,
              const Rgb8& colour) {
  Ink ink(image.size);
  double x = origin.x;
  for (const char character : text) {
    if (const Glyph* const glyph = glyphOf(character))
      Pen(ink, {snapped(x), snapped(origin.y)}, size).draw(*glyph);
    x += advance(character) * size.unit;
  }
  ink.paint(image, colour);
}

}  // namespace planetree::render
