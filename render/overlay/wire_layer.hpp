#pragma once

#include "render/camera.hpp"
#include "render/image.hpp"
#include "render/light.hpp"
#include "render/overlay/surface_depths.hpp"

#include <planetree/geometry/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace planetree::render {

/// How wires look.
struct WireStyle {
  Vec3f colour;         ///< in linear light
  double width = 1.0;   ///< in pixels, at any distance
  float seen = 1.0f;    ///< how much of what is behind a wire it covers
  float hidden = 0.2f;  ///< the same where a surface is in front of the wire
};

/// Straight lines in space, drawn over a picture and hidden by its surfaces: what is behind one
/// shines faintly through it. Lines that cover each other count once, so the layer does not depend
/// on their order.
class WireLayer {
 public:
  WireLayer(ImageSize size, const WireStyle& style)
      : style_(style), size_(size), coverages_(size.pixelCount()) {}

  /// Draws the line from a to b, or what of it lies in the picture. `depths` has the layer's size.
  void draw(const Vec3d& a, const Vec3d& b, const PinholeCamera& camera,
            const SurfaceDepths& depths);

  [[nodiscard]] Light light(std::uint32_t x, std::uint32_t y) const noexcept;

 private:
  struct Coverage {
    float seen = 0.0f;
    float hidden = 0.0f;
  };

  [[nodiscard]] std::size_t index(std::uint32_t x, std::uint32_t y) const noexcept {
    return static_cast<std::size_t>(y) * size_.width + x;
  }

  WireStyle style_;
  ImageSize size_;
  std::vector<Coverage> coverages_;
};

}  // namespace planetree::render
