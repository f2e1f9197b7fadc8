#include "render/sample_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planetree::render {

namespace {

constexpr std::uint32_t reverseBits(std::uint32_t x) noexcept {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00FF00FFu) << 8) | ((x & 0xFF00FF00u) >> 8);
  x = ((x & 0x0F0F0F0Fu) << 4) | ((x & 0xF0F0F0F0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xCCCCCCCCu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xAAAAAAAAu) >> 1);
}

/// Owen scrambling of the bits of `x`: whether a bit flips depends on the seed and on the bits
/// above it. The constants are those of Burley 2020.
constexpr std::uint32_t scramble(std::uint32_t x, std::uint32_t seed) noexcept {
  x = reverseBits(x);
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return reverseBits(x);
}

/// The second dimension of Sobol's sequence; the first is `reverseBits`.
constexpr std::uint32_t sobolSecond(std::uint32_t index) noexcept {
  std::uint32_t result = 0;
  for (std::uint32_t direction = 1u << 31; index != 0; index >>= 1) {
    if ((index & 1u) != 0)
      result ^= direction;
    direction ^= direction >> 1;
  }
  return result;
}

/// A hash with well mixed bits: the finaliser of splitmix64 (Steele, Lea and Flood, "Fast
/// splittable pseudorandom number generators", OOPSLA 2014).
constexpr std::uint32_t mixed(std::uint64_t x) noexcept {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::uint32_t>((x ^ (x >> 31)) >> 32);
}

constexpr double unitInterval(std::uint32_t bits) noexcept {
  return bits * 0x1p-32;
}

/// The point with this index of one scrambled sequence among many.
Point2 scrambledSobol(std::uint32_t index, std::uint64_t sequence) noexcept {
  const std::uint32_t shuffled = scramble(index, mixed(3 * sequence));
  return {unitInterval(scramble(reverseBits(shuffled), mixed(3 * sequence + 1))),
          unitInterval(scramble(sobolSecond(shuffled), mixed(3 * sequence + 2)))};
}

/// Every second bit, from bit 0 on, is one of the lower 16 bits of `x`.
constexpr std::uint32_t spreadBits(std::uint32_t x) noexcept {
  x &= 0x0000FFFFu;
  x = (x | (x << 8)) & 0x00FF00FFu;
  x = (x | (x << 4)) & 0x0F0F0F0Fu;
  x = (x | (x << 2)) & 0x33333333u;
  return (x | (x << 1)) & 0x55555555u;
}

constexpr std::uint32_t mortonIndex(std::uint32_t x, std::uint32_t y) noexcept {
  return spreadBits(x) | (spreadBits(y) << 1);
}

}  // namespace

SamplePoint SamplePoints::at(std::uint32_t pixelX, std::uint32_t pixelY,
                             std::uint32_t sample) const noexcept {
  // Beyond 2^32 points in a picture the index wraps around, and far-off pixels share their points.
  const std::uint32_t index = mortonIndex(pixelX, pixelY) * samplesPerPixel_ + sample;
  SamplePoint point{.film = scrambledSobol(index, 2 * seed_), .directions = {}};
  for (std::uint32_t i = 0; i < kDirectionsPerSample; ++i) {
    point.directions[i] = scrambledSobol(index * kDirectionsPerSample + i, 2 * seed_ + 1);
  }
  return point;
}

Vec3f cosineDistributed(const Vec3f& normal, const Point2& point) noexcept {
  // A uniform point of the unit disk, lifted onto the hemisphere, is distributed by the cosine
  // (Malley's method).
  const double radius = std::sqrt(point.x);
  const double angle = 2.0 * std::numbers::pi * point.y;
  const double x = radius * std::cos(angle);
  const double y = radius * std::sin(angle);
  const double z = std::sqrt(std::max(0.0, 1.0 - point.x));

  // Two vectors at right angles to the normal: Duff et al., "Building an orthonormal basis,
  // revisited", JCGT 2017.
  const Vec3d n(normal);
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  const Vec3d tangent{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  const Vec3d bitangent{b, sign + n.y * n.y * a, -n.y};
  return Vec3f(normalized(tangent * x + bitangent * y + n * z));
}

}  // namespace planetree::render
