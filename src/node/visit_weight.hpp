#pragma once

#include <planetree/geometry/box3.hpp>

namespace planetree::detail {

/// How often rays meet a convex box inside the bounds of a tree, as a number to compare boxes by.
///
/// Of rays that come from outside, its surface area tells (MacDonald and Booth, "Heuristics for ray
/// tracing using space subdivision", 1990). But cameras stand in rooms, and rays are reflected
/// there: a ray also meets the box that it starts in, which of all origins in the tree its share of
/// the volume tells. Of rays with a mean length l and origins everywhere in the tree, of volume V,
/// a box of area A' and volume V' meets (V' + A' l / 4) / V (Santalo, "Integral geometry and
/// geometric probability", 1976), so that next to A' the volume counts 4 / l. The mean chord of the
/// tree is 4 V / A; rays are taken to reach a quarter as far before something stops them.
class VisitWeight {
 public:
  /// Area alone: all rays come from outside.
  VisitWeight() = default;
  /// For boxes in a tree with these bounds.
  explicit VisitWeight(const Box3& tree) noexcept {
    const double volume = volumeOf(tree);
    if (volume > 0.0)
      weightOfVolume_ = kChordsPerRay * tree.surfaceArea() / volume;
  }

  [[nodiscard]] double operator()(const Box3& box) const noexcept {
    return box.surfaceArea() + ofOrigins(box);
  }
  /// The part of it that rays have which start in the box.
  [[nodiscard]] double ofOrigins(const Box3& box) const noexcept {
    return weightOfVolume_ * volumeOf(box);
  }

 private:
  static constexpr double kChordsPerRay = 4.0;

  [[nodiscard]] static double volumeOf(const Box3& box) noexcept {
    if (box.isEmpty())
      return 0.0;
    const Vec3d size = static_cast<Vec3d>(box.upper) - static_cast<Vec3d>(box.lower);
    return size.x * size.y * size.z;
  }

  double weightOfVolume_ = 0.0;
};

}  // namespace planetree::detail
