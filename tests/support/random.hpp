#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

namespace planetree::test {

/// The seed of a random test: fixed, so that a failure can be repeated, unless the environment
/// variable PLANETREE_TEST_SEED names another. Tests print it with their failures.
inline std::uint64_t testSeed() {
  const char* seed = std::getenv("PLANETREE_TEST_SEED");
  return seed ? std::strtoull(seed, nullptr, 10) : 20'061u;
}

inline std::string describeSeed() {
  return "seed " + std::to_string(testSeed()) + " (PLANETREE_TEST_SEED sets another)";
}

/// Random numbers that are the same everywhere: the standard fixes the engine, but not the
/// distributions.
class Random {
 public:
  explicit Random(std::uint64_t salt = 0) : engine_(testSeed() * 1'000'003u + salt) {}

  /// In [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool chance(double probability) { return unit() < probability; }

  template <class T>
  Vec3<T> pointIn(const Vec3d& lower, const Vec3d& upper) {
    return {static_cast<T>(between(lower.x, upper.x)), static_cast<T>(between(lower.y, upper.y)),
            static_cast<T>(between(lower.z, upper.z))};
  }

  /// Uniform on the unit sphere.
  Vec3d direction() {
    while (true) {
      const Vec3d point = pointIn<double>({-1, -1, -1}, {1, 1, 1});
      const double squared = dot(point, point);
      if (squared > 1e-4 && squared <= 1.0)
        return normalized(point);
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace planetree::test
