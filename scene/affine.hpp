#pragma once

#include <planetree/geometry/vec3.hpp>

#include <array>
#include <optional>

namespace planetree::scene {

/// An affine map of space: a matrix of three columns and a shift. `a * b` does `b` first, as with
/// matrices that are applied to columns. The default is the identity.
class Affine {
 public:
  Affine() = default;
  /// The images of the axes, and of the origin.
  Affine(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& origin) noexcept
      : columns_{x, y, z}, origin_(origin) {}

  [[nodiscard]] static Affine translation(const Vec3d& by) noexcept;
  [[nodiscard]] static Affine scaling(const Vec3d& factors) noexcept;
  /// Counter-clockwise as seen from the tip of `axis`, which need not have unit length but must
  /// not be zero.
  [[nodiscard]] static Affine rotation(const Vec3d& axis, double radians) noexcept;
  /// By a unit quaternion, the scalar last.
  [[nodiscard]] static Affine rotation(const std::array<double, 4>& quaternion) noexcept;

  [[nodiscard]] Vec3d point(const Vec3d& p) const noexcept { return vector(p) + origin_; }
  [[nodiscard]] Vec3d vector(const Vec3d& v) const noexcept {
    return columns_[0] * v.x + columns_[1] * v.y + columns_[2] * v.z;
  }
  /// A normal, carried by the inverse transpose but for its length. It keeps pointing away from
  /// what it pointed away from, also where the map mirrors.
  [[nodiscard]] Vec3d normal(const Vec3d& n) const noexcept;

  [[nodiscard]] const Vec3d& column(std::size_t axis) const noexcept { return columns_[axis]; }
  [[nodiscard]] const Vec3d& origin() const noexcept { return origin_; }
  [[nodiscard]] double determinant() const noexcept;
  [[nodiscard]] bool isFinite() const noexcept;
  /// Whether it presses space flat, as far as can be told: entries that are off by some units in
  /// their last places could be those of a map that does.
  [[nodiscard]] bool isSingular() const noexcept;

  /// Nothing if the map is singular or its inverse is not finite.
  [[nodiscard]] std::optional<Affine> inverse() const noexcept;

  /// The factor by which all lengths grow if the map keeps angles (it may mirror); else nothing.
  /// Rounding of some units in the last place is forgiven.
  [[nodiscard]] std::optional<double> uniformScale() const noexcept;

  [[nodiscard]] friend Affine operator*(const Affine& a, const Affine& b) noexcept {
    return {a.vector(b.columns_[0]), a.vector(b.columns_[1]), a.vector(b.columns_[2]),
            a.point(b.origin_)};
  }
  friend bool operator==(const Affine&, const Affine&) noexcept = default;

 private:
  std::array<Vec3d, 3> columns_{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  Vec3d origin_{0, 0, 0};
};

}  // namespace planetree::scene
