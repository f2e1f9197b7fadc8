#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cstddef>
#include <limits>
#include <type_traits>

namespace planetree {

/// A ray: the points `origin + t * direction` for t in the closed interval [tMin, tMax].
///
/// The direction need not be of unit length; every t of the library is in units of its length.
/// A ray whose direction is zero, or with a NaN or infinity anywhere but in tMin and tMax, misses
/// everything, and so does one with tMin > tMax or a NaN in either. tMin may be negative and tMax
/// infinite. See docs/limits.md for the range of coordinates in which no hit is missed.
///
/// The layout is eight scalars in this order, so an array of N rays is an N x 8 array.
template <class T>
struct Ray {
  Vec3<T> origin;
  Vec3<T> direction;
  T tMin = T(0);
  T tMax = std::numeric_limits<T>::infinity();

  [[nodiscard]] constexpr Vec3<T> at(T t) const noexcept { return origin + direction * t; }
};

using Rayf = Ray<float>;
using Rayd = Ray<double>;

static_assert(std::is_standard_layout_v<Rayf> && std::is_trivially_copyable_v<Rayf>);
static_assert(sizeof(Rayf) == 8 * sizeof(float) && sizeof(Rayd) == 8 * sizeof(double));
static_assert(offsetof(Rayf, origin) == 0 && offsetof(Rayf, direction) == 12);
static_assert(offsetof(Rayf, tMin) == 24 && offsetof(Rayf, tMax) == 28);
static_assert(offsetof(Rayd, direction) == 24 && offsetof(Rayd, tMin) == 48);
static_assert(offsetof(Rayd, tMax) == 56);

}  // namespace planetree
