#include "scene/texture.hpp"

#include <algorithm>
#include <cmath>

namespace planetree::scene {

namespace {

/// Two neighbouring texels of a row or column, and how far to go from the first to the second.
struct Neighbours {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  float part = 0.0f;
};

std::uint32_t repeated(double texel, std::uint32_t count) noexcept {
  const double inside = texel - count * std::floor(texel / count);
  return std::min(static_cast<std::uint32_t>(inside), count - 1);
}

std::uint32_t clamped(double texel, std::uint32_t count) noexcept {
  return static_cast<std::uint32_t>(std::clamp(texel, 0.0, static_cast<double>(count - 1)));
}

double finite(double number) noexcept {
  return std::isfinite(number) ? number : 0.0;
}

/// `place` is from 0 to 1 within the image.
Neighbours neighboursAt(double place, std::uint32_t count, bool isRepeated) noexcept {
  // Without the whole part first: a large number of texels is no exact one.
  const double within = finite(place) - (isRepeated ? std::floor(finite(place)) : 0.0);
  // In texels, from the middle of the first.
  const double texels = within * count - 0.5;
  const double first = std::floor(texels);
  const auto texel = isRepeated ? repeated : clamped;
  return {texel(first, count), texel(first + 1.0, count), static_cast<float>(texels - first)};
}

}  // namespace

Vec3d Texture::at(double u, double v, TextureEdges edges) const noexcept {
  const Neighbours x = neighboursAt(u, width(), edges != TextureEdges::Clamped);
  const Neighbours y = neighboursAt(1.0 - v, height(), edges == TextureEdges::Repeated);
  const auto row = [&](std::uint32_t line) {
    return texel(x.first, line) * (1.0f - x.part) + texel(x.second, line) * x.part;
  };
  return Vec3d(row(y.first) * (1.0f - y.part) + row(y.second) * y.part);
}

}  // namespace planetree::scene
