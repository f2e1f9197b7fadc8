#pragma once

#include <planetree/geometry/ray.hpp>
#include <planetree/geometry/vec3.hpp>

#include "exact/ray_axes.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace planetree::test {

/// Rules out, in double, most triangles that are not near: one whose shadow in the sheared plane a
/// line keeps away from the ray by more than `margin`. Sheared corners are off by a few 2^-53 D
/// here, of which the margin has to have room for some dozens.
class NearFilter {
 public:
  NearFilter(const Rayd& ray, double margin) noexcept
      : origin_(ray.origin),
        axes_(ray.direction),
        shearX_(ray.direction[axes_.x] / ray.direction[axes_.z]),
        shearY_(ray.direction[axes_.y] / ray.direction[axes_.z]),
        margin_(margin) {}

  [[nodiscard]] bool mayBeNear(const std::array<Vec3d, 3>& corners) const noexcept {
    std::array<double, 3> x;
    std::array<double, 3> y;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d relative = corners[i] - origin_;
      x[i] = relative[axes_.x] - shearX_ * relative[axes_.z];
      y[i] = relative[axes_.y] - shearY_ * relative[axes_.z];
    }
    if (isKeptAway(x, y, 1.0, 0.0) || isKeptAway(x, y, 0.0, 1.0))
      return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (isKeptAway(x, y, y[i] - y[next], x[next] - x[i]))
        return false;
    }
    return true;
  }

 private:
  [[nodiscard]] bool isKeptAway(const std::array<double, 3>& x, const std::array<double, 3>& y,
                                double normalX, double normalY) const noexcept {
    const double reach = margin_ * (std::fabs(normalX) + std::fabs(normalY));
    int before = 0;
    int behind = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double along = normalX * x[i] + normalY * y[i];
      before += along > reach ? 1 : 0;
      behind += along < -reach ? 1 : 0;
    }
    return before == 3 || behind == 3;
  }

  Vec3d origin_;
  RayAxes axes_;
  double shearX_;
  double shearY_;
  double margin_;
};

}  // namespace planetree::test
