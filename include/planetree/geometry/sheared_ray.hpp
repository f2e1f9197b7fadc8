#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/geometry/vec3.hpp>

#include <cmath>
#include <limits>

namespace planetree {

/// A ray with what the triangle test needs of it: the axes permuted so that the direction is
/// largest along the third, and the shear that turns the direction into that axis. Made once per
/// ray.
template <class T>
struct ShearedRay {
  Ray<T> ray;
  Axis kx = Axis::X;
  Axis ky = Axis::Y;
  Axis kz = Axis::Z;
  T shearX = T(0);
  T shearY = T(0);

  explicit ShearedRay(const Ray<T>& from) noexcept : ray(from) {
    const Vec3<T>& d = ray.direction;
    const T x = std::fabs(d.x);
    const T y = std::fabs(d.y);
    const T z = std::fabs(d.z);
    kz = x > y ? (x > z ? Axis::X : Axis::Z) : (y > z ? Axis::Y : Axis::Z);
    kx = kz == Axis::X ? Axis::Y : kz == Axis::Y ? Axis::Z : Axis::X;
    ky = kx == Axis::X ? Axis::Y : kx == Axis::Y ? Axis::Z : Axis::X;
    // A direction that points nowhere makes the shear NaN, and with it every test a miss.
    const T along = std::isfinite(d[kz]) ? d[kz] : std::numeric_limits<T>::quiet_NaN();
    shearX = d[kx] / along;
    shearY = d[ky] / along;
  }
};

}  // namespace planetree
