#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

/// Whether a triangle and a box touch, decided without any rounding: coordinates are integers of
/// 128 bits. Shares nothing with the library's clipping.
namespace planetree::test {

__extension__ typedef __int128 Int128;  // NOLINT: __extension__ needs a typedef

/// A number as a count of units of 2^-bits. Throws for one that is finer than the unit, so that a
/// judgement is either exact or none.
[[nodiscard]] inline Int128 inUnits(double number, int bits) {
  int exponent = 0;
  const double mantissa = std::frexp(number, &exponent);
  const auto digits = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
  const int shift = exponent - 53 + bits;
  if (shift >= 0)
    return Int128{digits} << shift;
  const Int128 unit = Int128{1} << -shift;
  if (shift < -62 || Int128{digits} % unit != 0)
    throw std::range_error("a coordinate is finer than the judge's unit");
  return Int128{digits} / unit;
}

/// What counts as touching.
enum class Contact : std::uint8_t {
  Interior,  ///< the triangle and the open box share a point
  Closed,    ///< the triangle and the closed box share a point
};

/// Corners are multiples of 2^-kCornerBits, walls of boxes of 2^-kWallBits. The separating axis
/// test of Akenine-Moeller, "Fast 3D triangle-box overlap testing", Journal of Graphics Tools 2001,
/// on integers. Exact for boxes with an interior; axes of length zero, which triangles without area
/// have, separate nothing and are passed over.
template <int kCornerBits, int kWallBits>
class OverlapJudge {
 public:
  template <class T>
  explicit OverlapJudge(const std::array<Vec3<T>, 3>& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (const Axis axis : kAxes) {
        corners_[i][indexOf(axis)] = inUnits(static_cast<double>(corners[i][axis]), kCornerBits);
      }
    }
  }

  /// The box may be grown by a margin on all sides, a multiple of 2^-kWallBits.
  [[nodiscard]] bool touches(const Box3& box, Contact contact, double margin = 0.0) const {
    const Int128 growth = inUnits(margin, kWallBits);
    Triple lower;
    Triple upper;
    for (const Axis axis : kAxes) {
      lower[indexOf(axis)] = inUnits(static_cast<double>(box.lower[axis]), kWallBits) - growth;
      upper[indexOf(axis)] = inUnits(static_cast<double>(box.upper[axis]), kWallBits) + growth;
    }
    const auto isApartAlong = [&](const Triple& axis) {
      return isSeparatedBy(axis, lower, upper, contact);
    };
    const Triple edges[3] = {difference(1, 0), difference(2, 1), difference(0, 2)};
    const Triple units[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Triple& unit : units) {
      if (isApartAlong(unit))
        return false;
      for (const Triple& edge : edges) {
        if (isApartAlong(cross(unit, edge)))
          return false;
      }
    }
    return !isApartAlong(cross(edges[0], edges[1]));
  }

 private:
  using Triple = std::array<Int128, 3>;

  [[nodiscard]] static std::size_t indexOf(Axis axis) { return static_cast<std::size_t>(axis); }

  [[nodiscard]] Triple difference(std::size_t to, std::size_t from) const {
    Triple edge;
    for (std::size_t i = 0; i < 3; ++i)
      edge[i] = corners_[to][i] - corners_[from][i];
    return edge;
  }

  [[nodiscard]] static Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  [[nodiscard]] bool isSeparatedBy(const Triple& axis, const Triple& lower, const Triple& upper,
                                   Contact contact) const {
    if (axis == Triple{})
      return false;
    Int128 boxMin = 0;
    Int128 boxMax = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      boxMin += axis[i] * (axis[i] > 0 ? lower[i] : upper[i]);
      boxMax += axis[i] * (axis[i] > 0 ? upper[i] : lower[i]);
    }
    std::array<Int128, 3> heights{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t i = 0; i < 3; ++i)
        heights[corner] += axis[i] * corners_[corner][i] * kWallUnitsPerCornerUnit;
    }
    const Int128 min = std::min({heights[0], heights[1], heights[2]});
    const Int128 max = std::max({heights[0], heights[1], heights[2]});
    return contact == Contact::Interior ? max <= boxMin || min >= boxMax
                                        : max < boxMin || min > boxMax;
  }

  static_assert(kWallBits >= kCornerBits);
  static constexpr Int128 kWallUnitsPerCornerUnit = Int128{1} << (kWallBits - kCornerBits);

  std::array<Triple, 3> corners_;
};

}  // namespace planetree::test
