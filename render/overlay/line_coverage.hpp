#pragma once

#include "render/image.hpp"
#include "render/point2.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace planetree::render {

/// A straight line in a picture, in pixels from its upper left corner.
struct Line2 {
  Point2 a;
  Point2 b;
};

namespace detail {

/// The pixels of a row (or the rows) that touch an interval, as begin and end.
inline std::pair<std::uint32_t, std::uint32_t> touchedPixels(double lowest, double highest,
                                                             std::uint32_t count) noexcept {
  const auto most = static_cast<double>(count);
  return {static_cast<std::uint32_t>(std::clamp(std::floor(lowest), 0.0, most)),
          static_cast<std::uint32_t>(std::clamp(std::ceil(highest), 0.0, most))};
}

/// The x of a line between two heights, as lowest and highest.
inline std::pair<double, double> extentBetween(const Line2& line, double top,
                                               double bottom) noexcept {
  const double height = line.b.y - line.a.y;
  const auto xAt = [&](double y) {
    const double along = std::clamp((y - line.a.y) / height, 0.0, 1.0);
    return line.a.x + along * (line.b.x - line.a.x);
  };
  // A level line has all its points at one height.
  return height == 0.0 ? std::minmax({line.a.x, line.b.x}) : std::minmax({xAt(top), xAt(bottom)});
}

}  // namespace detail

/// Calls `plot(x, y, coverage, along)` for each pixel that a line with round ends touches. The
/// coverage falls off over the width of one pixel around the edge of the line, by the distance from
/// the middle of the pixel, which is then nearest to the point `along` the way from a (0) to b (1).
/// A point is a dot.
template <class Plot>
void forEachCoveredPixel(const Line2& line, double width, const ImageSize& size, const Plot& plot) {
  const double reach = 0.5 * width + 0.5;
  const Point2 way{line.b.x - line.a.x, line.b.y - line.a.y};
  const double squaredLength = way.x * way.x + way.y * way.y;
  const auto [top, bottom] = std::minmax({line.a.y, line.b.y});
  const auto [firstY, endY] = detail::touchedPixels(top - reach, bottom + reach, size.height);
  for (std::uint32_t y = firstY; y < endY; ++y) {
    const double middleY = y + 0.5;
    const auto [left, right] = detail::extentBetween(line, middleY - reach, middleY + reach);
    const auto [firstX, endX] = detail::touchedPixels(left - reach, right + reach, size.width);
    for (std::uint32_t x = firstX; x < endX; ++x) {
      const Point2 fromA{x + 0.5 - line.a.x, middleY - line.a.y};
      const double along =
          squaredLength > 0.0
              ? std::clamp((fromA.x * way.x + fromA.y * way.y) / squaredLength, 0.0, 1.0)
              : 0.0;
      const double distance = std::hypot(fromA.x - along * way.x, fromA.y - along * way.y);
      const double coverage = std::min(reach - distance, 1.0);
      if (coverage > 0.0)
        plot(x, y, coverage, along);
    }
  }
}

}  // namespace planetree::render
