#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cmath>
#include <numbers>

namespace planetree::scene {

/// An eye and the plane of the picture before it. The default is that of the `.ray` format: the eye
/// at the origin, looking along -z, a picture of height and width 1 at distance 1.
///
/// The axes are used as given, not normalised.
struct View {
  Vec3d eye{0, 0, 0};
  Vec3d look{0, 0, -1};  ///< to the middle of the picture
  Vec3d u{1, 0, 0};      ///< across the picture, from its left edge to its right one
  Vec3d v{0, 1, 0};      ///< from its lower edge to its upper one

  /// The unit direction through a point of the picture: (0, 0) is its lower left corner, (1, 1) its
  /// upper right one.
  [[nodiscard]] Vec3d direction(double x, double y) const noexcept {
    return normalized(look + u * (x - 0.5) + v * (y - 0.5));
  }
  /// The width of the picture divided by its height.
  [[nodiscard]] double aspectRatio() const noexcept { return length(u) / length(v); }
};

}  // namespace planetree::scene
