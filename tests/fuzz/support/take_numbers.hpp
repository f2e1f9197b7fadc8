#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/geometry/vec3.hpp>

#include "support/byte_stream.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace planetree::fuzz {

/// Coordinates of one input. Raw bits alone would hardly ever meet: most of them are out of all
/// range, and no two are equal. So an input chooses how its bytes are to be understood.
template <class T>
class NumberTaker {
 public:
  explicit NumberTaker(ByteStream& input) noexcept
      : input_(input), kind_(static_cast<Kind>(input.takeBelow(6))) {
    const int exponent = static_cast<int>(input.takeBelow(64)) - 32;
    // Mostly of a size at which all is well.
    scale_ = std::ldexp(T(1), input.takeBelow(4) == 0 ? exponent : 0);
  }

  [[nodiscard]] T take() noexcept {
    switch (kind_) {
      case Kind::Grid:
        return scale_ * T(static_cast<std::int8_t>(input_.takeByte())) / T(32);
      case Kind::AlmostGrid:
        return almostGrid();
      case Kind::Fine:
        return scale_ * T(input_.take<std::int16_t>()) / T(4096);
      case Kind::Signed: {
        // Zeros of both signs.
        const auto bits = input_.takeByte();
        return std::copysign(scale_ * T(bits & 0x7Fu) / T(16), (bits & 0x80u) != 0 ? T(-1) : T(1));
      }
      case Kind::Special:
        return special();
      case Kind::Raw:
        break;
    }
    return input_.take<T>();
  }

  [[nodiscard]] Vec3<T> takeVector() noexcept {
    const T x = take();
    const T y = take();
    const T z = take();
    return {x, y, z};
  }

 private:
  enum class Kind : std::uint8_t { Grid, AlmostGrid, Fine, Signed, Special, Raw };

  /// A place of a coarse grid, or one of its next neighbours.
  T almostGrid() noexcept {
    const T at = scale_ * T(static_cast<int>(input_.takeBelow(16)) - 8) / T(4);
    const auto steps = static_cast<int>(input_.takeBelow(7)) - 3;
    T nudged = at;
    for (int i = 0; i < std::abs(steps); ++i)
      nudged = std::nextafter(
          nudged, steps < 0 ? -std::numeric_limits<T>::max() : std::numeric_limits<T>::max());
    return nudged;
  }

  T special() noexcept {
    using Limits = std::numeric_limits<T>;
    const std::array<T, 16> values = {T(0),
                                      T(-0.0),
                                      T(1),
                                      T(-1),
                                      T(0.5),
                                      Limits::denorm_min(),
                                      -Limits::denorm_min(),
                                      Limits::min(),
                                      Limits::max(),
                                      -Limits::max(),
                                      Limits::infinity(),
                                      Limits::quiet_NaN(),
                                      T(0x1p30),
                                      T(-0x1p-30),
                                      T(0x1p40),
                                      T(3.4028234663852886e38)};
    return values[input_.takeBelow(16)];
  }

  ByteStream& input_;
  Kind kind_;
  T scale_ = T(1);
};

/// A ray, mostly over its whole length.
template <class T>
[[nodiscard]] Ray<T> takeRay(ByteStream& input, NumberTaker<T>& numbers) {
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  const unsigned kind = input.takeBelow(8);
  Ray<T> ray{.origin = numbers.takeVector(), .direction = numbers.takeVector()};
  // From a point towards another one: such rays meet what lies there.
  if ((kind & 4u) != 0)
    ray.direction = ray.direction - ray.origin;
  if ((kind & 3u) == 1)
    ray.tMin = -kInfinity;
  if ((kind & 3u) == 2)
    ray.tMax = numbers.take();
  if ((kind & 3u) == 3) {
    ray.tMin = numbers.take();
    ray.tMax = numbers.take();
  }
  return ray;
}

}  // namespace planetree::fuzz
