#pragma once

#include "render/image.hpp"
#include "render/point2.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace planetree::render {

/// Where in a pixel the depth of the surface is known: one place for each row and each column of a
/// grid, so that outlines of any direction come out smooth.
inline constexpr std::array<Point2, 4> kDepthPlaces = {
    {{0.375, 0.125}, {0.875, 0.375}, {0.625, 0.875}, {0.125, 0.625}}};

/// How far away the first surface is, along the view direction, at some places of each pixel.
class SurfaceDepths {
 public:
  using Depths = std::array<float, kDepthPlaces.size()>;

  explicit SurfaceDepths(ImageSize size) : size_(size), depths_(size.pixelCount(), nowhere()) {}

  [[nodiscard]] const ImageSize& size() const noexcept { return size_; }

  [[nodiscard]] Depths& at(std::uint32_t x, std::uint32_t y) noexcept {
    return depths_[static_cast<std::size_t>(y) * size_.width + x];
  }
  [[nodiscard]] const Depths& at(std::uint32_t x, std::uint32_t y) const noexcept {
    return depths_[static_cast<std::size_t>(y) * size_.width + x];
  }

  /// The part of a pixel in which no surface is nearer than this depth.
  [[nodiscard]] float visiblePart(std::uint32_t x, std::uint32_t y, double depth) const noexcept {
    int visible = 0;
    for (const float surface : at(x, y))
      visible += depth <= static_cast<double>(surface) ? 1 : 0;
    return static_cast<float>(visible) / static_cast<float>(kDepthPlaces.size());
  }

 private:
  static Depths nowhere() noexcept {
    Depths depths;
    depths.fill(std::numeric_limits<float>::infinity());
    return depths;
  }

  ImageSize size_;
  std::vector<Depths> depths_;
};

}  // namespace planetree::render
