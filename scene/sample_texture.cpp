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

/// `place` is counted in texels, 0.5 being the middle of the first.
template <class Within>
Neighbours neighboursAt(double place, std::uint32_t count, const Within& within) noexcept {
  const double first = std::floor(place - 0.5);
  return {within(first, count), within(first + 1.0, count),
          static_cast<float>(place - 0.5 - first)};
}

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

template <class Within>
Vec3d bilinear(const Texture& texture, double u, double v, const Within& within) noexcept {
  const Neighbours x = neighboursAt(u * texture.width(), texture.width(), within);
  const Neighbours y = neighboursAt((1.0 - v) * texture.height(), texture.height(), within);
  const auto row = [&](std::uint32_t at) {
    return texture.texel(x.first, at) * (1.0f - x.part) + texture.texel(x.second, at) * x.part;
  };
  return Vec3d(row(y.first) * (1.0f - y.part) + row(y.second) * y.part);
}

}  // namespace

Vec3d Texture::at(double u, double v) const noexcept {
  // Without the whole part first: a large number of texels is no exact one.
  const auto part = [](double x) { return x - std::floor(x); };
  return bilinear(*this, part(finite(u)), part(finite(v)), repeated);
}

Vec3d Texture::clampedAt(double u, double v) const noexcept {
  return bilinear(*this, finite(u), finite(v), clamped);
}

}  // namespace planetree::scene
