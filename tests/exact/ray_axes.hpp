#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cmath>

namespace planetree::test {

/// The axes as a ray sees them: it runs along z more than along the others.
struct RayAxes {
  Axis x;
  Axis y;
  Axis z;

  /// Of axes along which the direction is equally large the last one, as the library has it.
  explicit RayAxes(const Vec3d& direction) noexcept : x(Axis::X), y(Axis::Y), z(Axis::X) {
    for (const Axis axis : kAxes) {
      if (std::fabs(direction[axis]) >= std::fabs(direction[z]))
        z = axis;
    }
    x = nextAxis(z);
    y = nextAxis(x);
  }
};

}  // namespace planetree::test
