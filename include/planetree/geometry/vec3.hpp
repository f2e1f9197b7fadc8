#pragma once

#include <planetree/geometry/axis.hpp>

#include <cmath>

namespace planetree {

/// A point or a direction of three scalars (float or double), stored as x, y, z without padding.
template <class T>
struct Vec3 {
  T x{};
  T y{};
  T z{};

  [[nodiscard]] constexpr T operator[](Axis axis) const noexcept {
    return axis == Axis::X ? x : axis == Axis::Y ? y : z;
  }
  [[nodiscard]] constexpr T& operator[](Axis axis) noexcept {
    return axis == Axis::X ? x : axis == Axis::Y ? y : z;
  }

  /// The same vector in another precision, each component rounded to nearest.
  template <class U>
  [[nodiscard]] explicit constexpr operator Vec3<U>() const noexcept {
    return {static_cast<U>(x), static_cast<U>(y), static_cast<U>(z)};
  }

  friend constexpr bool operator==(const Vec3&, const Vec3&) noexcept = default;
  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Vec3 operator-(const Vec3& a) noexcept { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(const Vec3& a, T s) noexcept {
    return {a.x * s, a.y * s, a.z * s};
  }
  friend constexpr Vec3 operator*(T s, const Vec3& a) noexcept { return a * s; }
  friend constexpr Vec3 operator/(const Vec3& a, T s) noexcept {
    return {a.x / s, a.y / s, a.z / s};
  }
};

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

template <class T>
[[nodiscard]] constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
[[nodiscard]] constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
[[nodiscard]] T length(const Vec3<T>& a) noexcept {
  return std::sqrt(dot(a, a));
}

/// The unit vector along `a`. Scaling by the largest component first keeps tiny and huge vectors
/// from under- or overflowing. The zero vector, and one that is not finite, is returned as it is.
template <class T>
[[nodiscard]] Vec3<T> normalized(const Vec3<T>& a) noexcept {
  const T largest = std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z)));
  if (!(largest > T(0)) || !std::isfinite(largest))
    return a;
  const Vec3<T> scaled = a / largest;
  return scaled / length(scaled);
}

template <class T>
[[nodiscard]] bool isFinite(const Vec3<T>& a) noexcept {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace planetree
