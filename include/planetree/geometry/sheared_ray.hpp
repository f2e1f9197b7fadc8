#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/geometry/vec3.hpp>

#include <cmath>
#include <cstddef>
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
    const T components[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    const T x = std::fabs(components[0]);
    const T y = std::fabs(components[1]);
    const T z = std::fabs(components[2]);
    // Which axis it is no branch can foresee, so there is none.
    const auto isYOverX = static_cast<unsigned>(!(x > y));
    const auto isZOverBoth = static_cast<unsigned>(!((x > y ? x : y) > z));
    kz = static_cast<Axis>(2u * isZOverBoth + (isYOverX & ~isZOverBoth));
    kx = nextAxis(kz);
    ky = nextAxis(kx);
    const auto component = [&](Axis axis) { return components[static_cast<std::size_t>(axis)]; };
    // A direction that points nowhere makes the shear NaN, and with it every test a miss.
    const T along =
        std::isfinite(component(kz)) ? component(kz) : std::numeric_limits<T>::quiet_NaN();
    shearX = component(kx) / along;
    shearY = component(ky) / along;
  }
};

}  // namespace planetree
