#include "render/overlay/heat_legend.hpp"

#include "render/colour_map.hpp"
#include "render/overlay/stroke_font.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>

namespace planetree::render {

namespace {

constexpr Rgb8 kPaper{255, 255, 255};
constexpr Rgb8 kInk{38, 38, 38};
constexpr Rgb8 kFrame{90, 90, 90};

constexpr std::string_view kTitle = "steps per ray: split nodes visited + objects tested";
constexpr std::string_view kShortTitle = "split nodes + objects per ray";

// Lengths in units of the text.
constexpr double kMargin = 8.0;
constexpr double kLineHeight = 13.0;
constexpr double kBarHeight = 9.0;
constexpr double kTickLength = 2.5;
constexpr double kColumnGap = 14.0;  ///< between title and numbers
constexpr double kLabelGap = 8.0;    ///< between labels

/// A number with at most one digit behind the point.
std::string numberText(double value) {
  std::array<char, 64> text{};
  const bool isWhole = std::fabs(value - std::round(value)) < 0.05 || value >= 1e4;
  const int length = std::snprintf(text.data(), text.size(), isWhole ? "%.0f" : "%.1f", value);
  return {text.data(), static_cast<std::size_t>(length)};
}

/// The step between marks: 1, 2 or 5 times a power of ten, no finer than the scale's end divided by
/// the number of labels.
double tickStep(double end, int labelCount) noexcept {
  const double finest = end / labelCount;
  double step = std::pow(10.0, std::floor(std::log10(finest)));
  for (const double factor : {2.0, 2.5, 2.0}) {
    if (step >= finest)
      break;
    step *= factor;
  }
  return step;
}

/// Where everything is, in pixels of the strip below the picture.
struct Layout {
  TextSize text;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::string_view title;
  std::string numbers;    ///< lowest, mean and highest pixel
  bool isOneLine = true;  ///< title and numbers side by side

  [[nodiscard]] double pixels(double units) const noexcept { return units * text.unit; }
  [[nodiscard]] double titleLine() const noexcept { return pixels(kMargin + kDigitHeight - 1.0); }
  [[nodiscard]] double numberLine() const noexcept {
    return isOneLine ? titleLine() : titleLine() + pixels(kLineHeight - 1.0);
  }
  [[nodiscard]] std::uint32_t barTop() const noexcept {
    return static_cast<std::uint32_t>(std::lround(numberLine() + pixels(5.5)));
  }
  [[nodiscard]] std::uint32_t barEnd() const noexcept {
    return barTop() + static_cast<std::uint32_t>(std::lround(pixels(kBarHeight)));
  }
  [[nodiscard]] std::uint32_t barLeft() const noexcept {
    return static_cast<std::uint32_t>(std::lround(pixels(kMargin)));
  }
  /// Behind it there is room for the arrow.
  [[nodiscard]] std::uint32_t barRight() const noexcept {
    return width - static_cast<std::uint32_t>(std::lround(pixels(kMargin + kBarHeight / 2.0)));
  }
  [[nodiscard]] double labelLine() const noexcept {
    return barEnd() + pixels(kTickLength + 1.5 + kDigitHeight);
  }
};

/// Letters about as high as a sixtieth of the picture, and never so small that they cannot be read.
/// Fifths of a pixel make a small x end on a whole one.
TextSize textSize(const ImageSize& picture) noexcept {
  constexpr double kPixelsPerUnit = 520.0;
  constexpr double kSmallest = 1.2;
  const double side = std::sqrt(static_cast<double>(picture.pixelCount()));
  return {std::max(kSmallest, std::round(5.0 * side / kPixelsPerUnit) / 5.0)};
}

Layout makeLayout(const ImageSize& picture, const ValueRange& range) {
  Layout layout;
  layout.text = textSize(picture);
  layout.title = kTitle;
  layout.numbers = "min " + numberText(range.lowest) + "   mean " + numberText(range.mean) +
                   "   max " + numberText(range.highest);
  const double margins = layout.pixels(2.0 * kMargin);
  const double numbers = textWidth(layout.numbers, layout.text) + margins;
  const double both = textWidth(kTitle, layout.text) + layout.pixels(kColumnGap) + numbers;
  layout.isOneLine = both <= picture.width;
  if (textWidth(kTitle, layout.text) + margins > picture.width)
    layout.title = kShortTitle;
  const double least = std::max(textWidth(kShortTitle, layout.text) + margins, numbers);
  layout.width = std::max(picture.width, static_cast<std::uint32_t>(std::ceil(least)));
  layout.height =
      static_cast<std::uint32_t>(std::ceil(layout.labelLine() + layout.pixels(kMargin - 1.0)));
  return layout;
}

void fill(Image& image, std::uint32_t x, std::uint32_t y, std::uint32_t endX, std::uint32_t endY,
          const Rgb8& colour) {
  for (std::uint32_t row = y; row < endY; ++row) {
    for (std::uint32_t column = x; column < endX; ++column)
      image.at(column, row) = colour;
  }
}

void drawBar(Image& strip, const Layout& layout, bool hasArrow) {
  const std::uint32_t left = layout.barLeft();
  const std::uint32_t right = layout.barRight();
  const std::uint32_t top = layout.barTop();
  const std::uint32_t end = layout.barEnd();
  fill(strip, left - 1, top - 1, right + 1, end + 1, kFrame);
  for (std::uint32_t x = left; x < right; ++x) {
    const float value = (static_cast<float>(x - left) + 0.5f) / static_cast<float>(right - left);
    fill(strip, x, top, x + 1, end, quantized(infernoColour(value)));
  }
  if (!hasArrow)
    return;
  // A triangle of the brightest colour, as high as the bar and half as long.
  const std::uint32_t height = end - top;
  for (std::uint32_t row = 0; row < height; ++row) {
    const std::uint32_t fromTip = std::min(row, height - 1 - row);
    fill(strip, right, top + row, right + fromTip + 1, top + row + 1,
         quantized(infernoColour(1.0f)));
    fill(strip, right + fromTip + 1, top + row, right + fromTip + 2, top + row + 1, kFrame);
  }
}

void drawTicks(Image& strip, const Layout& layout, const ValueRange& range) {
  const double left = layout.barLeft();
  const double length = layout.barRight() - left;
  const double labelWidth =
      textWidth(numberText(range.brightest) + "+", layout.text) + layout.pixels(kLabelGap);
  const int labelCount = std::max(1, static_cast<int>(length / labelWidth));
  for (const Tick& tick : scaleTicks(range, std::min(labelCount, 10))) {
    const double x = left + tick.value / range.brightest * length;
    const auto column = std::min(static_cast<std::uint32_t>(x), layout.barRight());
    const auto thickness = static_cast<std::uint32_t>(std::max(1.0, layout.pixels(0.5)));
    fill(strip, column, layout.barEnd(), column + thickness,
         layout.barEnd() + static_cast<std::uint32_t>(layout.pixels(kTickLength)), kFrame);
    const double width = textWidth(tick.label, layout.text);
    const double edge = left / 2.0;
    const double start = std::clamp(x - width / 2.0, edge, layout.width - edge - width);
    drawText(strip, {start, layout.labelLine()}, layout.text, tick.label, kInk);
  }
}

Image drawStrip(const Layout& layout, const ValueRange& range) {
  Image strip({layout.width, layout.height});
  std::fill(strip.pixels.begin(), strip.pixels.end(), kPaper);
  const double margin = layout.pixels(kMargin);
  drawText(strip, {margin, layout.titleLine()}, layout.text, layout.title, kInk);
  const double numbersWidth = textWidth(layout.numbers, layout.text);
  const double numbersX = layout.isOneLine ? layout.width - margin - numbersWidth : margin;
  drawText(strip, {numbersX, layout.numberLine()}, layout.text, layout.numbers, kInk);
  drawBar(strip, layout, range.highest > range.brightest);
  drawTicks(strip, layout, range);
  return strip;
}

void copy(const Image& from, Image& to, std::uint32_t left, std::uint32_t top) {
  for (std::uint32_t y = 0; y < from.size.height; ++y) {
    for (std::uint32_t x = 0; x < from.size.width; ++x)
      to.at(left + x, top + y) = from.at(x, y);
  }
}

}  // namespace

std::vector<Tick> scaleTicks(const ValueRange& range, int labelCount) {
  const double end = range.brightest;
  const double step = std::max(tickStep(end, labelCount), 1e-9);
  std::vector<Tick> ticks;
  // The end has a mark of its own, which must not run into another one.
  for (int i = 0; i == 0 || i * step < end - 0.7 * end / labelCount; ++i)
    ticks.push_back({i * step, numberText(i * step)});
  ticks.push_back({end, numberText(end) + (range.highest > end ? "+" : "")});
  return ticks;
}

Image withHeatLegend(const Image& picture, const ValueRange& range) {
  const Layout layout = makeLayout(picture.size, range);
  Image image({layout.width, picture.size.height + layout.height});
  std::fill(image.pixels.begin(), image.pixels.end(), kPaper);
  copy(picture, image, (layout.width - picture.size.width) / 2, 0);
  copy(drawStrip(layout, range), image, 0, picture.size.height);
  return image;
}

}  // namespace planetree::render
