#include "scene/affine.hpp"

#include <cmath>
#include <limits>

namespace planetree::scene {

namespace {

bool isFinite(const Vec3d& v) noexcept {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

Affine Affine::translation(const Vec3d& by) noexcept {
  Affine map;
  map.origin_ = by;
  return map;
}

Affine Affine::scaling(const Vec3d& factors) noexcept {
  return {{factors.x, 0, 0}, {0, factors.y, 0}, {0, 0, factors.z}, {}};
}

Affine Affine::rotation(const Vec3d& axis, double radians) noexcept {
  const Vec3d half = normalized(axis) * std::sin(radians / 2);
  return rotation(std::array{half.x, half.y, half.z, std::cos(radians / 2)});
}

Affine Affine::rotation(const std::array<double, 4>& quaternion) noexcept {
  const auto [x, y, z, w] = quaternion;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
          {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
          {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
          {}};
}

Vec3d Affine::normal(const Vec3d& n) const noexcept {
  // The cofactors are the inverse transpose times the determinant, and exist for singular maps too.
  const Vec3d carried = cross(columns_[1], columns_[2]) * n.x +
                        cross(columns_[2], columns_[0]) * n.y +
                        cross(columns_[0], columns_[1]) * n.z;
  return determinant() < 0.0 ? -carried : carried;
}

double Affine::determinant() const noexcept {
  return dot(columns_[0], cross(columns_[1], columns_[2]));
}

bool Affine::isFinite() const noexcept {
  return scene::isFinite(columns_[0]) && scene::isFinite(columns_[1]) &&
         scene::isFinite(columns_[2]) && scene::isFinite(origin_);
}

bool Affine::isSingular() const noexcept {
  // The sum of the sizes of the six products that the determinant is made of. What rounding does to
  // it is a part of that: see docs/numerics.md, section 8. Unlike the product of the lengths of the
  // columns it shrinks with a row as well as with a column, so that flat but good maps stay good.
  constexpr double kTolerance = 16.0 * std::numeric_limits<double>::epsilon();
  const auto size = [](const Vec3d& v) {
    return Vec3d{std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
  };
  const Vec3d x = size(columns_[0]);
  const Vec3d y = size(columns_[1]);
  const Vec3d z = size(columns_[2]);
  const double sum =
      x.x * (y.y * z.z + y.z * z.y) + x.y * (y.z * z.x + y.x * z.z) + x.z * (y.x * z.y + y.y * z.x);
  return !(std::fabs(determinant()) > kTolerance * sum);
}

std::optional<Affine> Affine::inverse() const noexcept {
  if (isSingular())
    return std::nullopt;
  const double factor = 1.0 / determinant();
  const Vec3d row0 = cross(columns_[1], columns_[2]) * factor;
  const Vec3d row1 = cross(columns_[2], columns_[0]) * factor;
  const Vec3d row2 = cross(columns_[0], columns_[1]) * factor;
  Affine result({row0.x, row1.x, row2.x}, {row0.y, row1.y, row2.y}, {row0.z, row1.z, row2.z}, {});
  result.origin_ = -result.vector(origin_);
  if (!result.isFinite())
    return std::nullopt;
  return result;
}

std::optional<double> Affine::uniformScale() const noexcept {
  constexpr double kTolerance = 1e-12;
  const double squared = dot(columns_[0], columns_[0]);
  if (!(squared > 0.0) || !std::isfinite(squared))
    return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(dot(columns_[i], columns_[i]) - squared) > kTolerance * squared ||
        std::fabs(dot(columns_[i], columns_[(i + 1) % 3])) > kTolerance * squared)
      return std::nullopt;
  }
  return std::sqrt(squared);
}

}  // namespace planetree::scene
