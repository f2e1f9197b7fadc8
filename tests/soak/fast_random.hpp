#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cstddef>
#include <cstdint>

namespace planetree::test {

/// Random numbers for streams of rays: one word of state, so that each block of rays can have a
/// generator of its own. SplitMix64 of Steele, Lea and Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014.
class FastRandom {
 public:
  explicit FastRandom(std::uint64_t seed) noexcept : state_(seed * 0x9E37'79B9'7F4A'7C15u) {}

  std::uint64_t next() noexcept {
    std::uint64_t z = state_ += 0x9E37'79B9'7F4A'7C15u;
    z = (z ^ (z >> 30u)) * 0xBF58'476D'1CE4'E5B9u;
    z = (z ^ (z >> 27u)) * 0x94D0'49BB'1331'11EBu;
    return z ^ (z >> 31u);
  }
  /// In [0, 1).
  double unit() noexcept { return static_cast<double>(next() >> 11u) * 0x1p-53; }
  std::size_t below(std::size_t count) noexcept { return static_cast<std::size_t>(next() % count); }
  bool chance(double probability) noexcept { return unit() < probability; }
  /// In the cube from -1 to 1.
  Vec3d inCube() noexcept {
    const double x = 2.0 * unit() - 1.0;
    const double y = 2.0 * unit() - 1.0;
    const double z = 2.0 * unit() - 1.0;
    return {x, y, z};
  }

 private:
  std::uint64_t state_;
};

}  // namespace planetree::test
