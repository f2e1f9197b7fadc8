#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace planetree::bench {

/// Random numbers that are the same everywhere: the standard fixes the engine, but not the
/// distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1).
  [[nodiscard]] double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  [[nodiscard]] double between(double low, double high) { return low + (high - low) * unit(); }
  [[nodiscard]] std::uint64_t below(std::uint64_t count) { return engine_() % count; }

  /// Uniform on the unit sphere (Archimedes: uniform along an axis).
  [[nodiscard]] Vec3d direction() {
    const double z = between(-1.0, 1.0);
    return onCircle(std::sqrt(1.0 - z * z), z);
  }

  /// On the unit hemisphere around +z, with a density that grows with the cosine: uniform on the
  /// disk below (Malley's method; Pharr, Jakob, Humphreys, "Physically based rendering", 2023).
  [[nodiscard]] Vec3d cosineDirection() {
    const double squared = unit();
    return onCircle(std::sqrt(squared), std::sqrt(1.0 - squared));
  }

 private:
  Vec3d onCircle(double radius, double z) {
    const double angle = 2.0 * std::numbers::pi * unit();
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }

  std::mt19937_64 engine_;
};

}  // namespace planetree::bench
