#pragma once

#include "scene/affine.hpp"

#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>
#include <planetree/shape/cone.hpp>
#include <planetree/shape/sphere.hpp>

#include <optional>

namespace planetree::scene {

/// A sphere or cone under a map that makes another kind of shape of it: an ellipsoid, an elliptic
/// or a slanted cone. Rays are carried into its own space, and there asked in double; `t` is the
/// same in both, as the direction is not normalised.
///
/// Hits are those of the shape but for the normal, which is carried back.
template <class Local>
class TransformedShape {
 public:
  using Scalar = float;

  /// `toLocal` is the inverse of `placement`.
  TransformedShape(const Local& local, const Affine& placement, const Affine& toLocal) noexcept
      : local_(local), placement_(placement), toLocal_(toLocal) {}

  /// The smallest box, but for rounding outward.
  [[nodiscard]] Box3 bounds() const noexcept;
  [[nodiscard]] std::optional<Hitf> intersect(const Rayf& ray, float tMin,
                                              float tMax) const noexcept;

 private:
  Local local_;
  Affine placement_;
  Affine toLocal_;
};

using Ellipsoid = TransformedShape<Sphere<double>>;
using TransformedCone = TransformedShape<Cone<double>>;

extern template class TransformedShape<Sphere<double>>;
extern template class TransformedShape<Cone<double>>;

}  // namespace planetree::scene
