#include "scene/transformed_shape.hpp"

#include <array>
#include <cmath>

namespace planetree::scene {

namespace {

/// Grows the box by center - extent and center + extent.
void extend(Box3& box, const Vec3d& center, const Vec3d& extent) noexcept {
  box.extend(center - extent);
  box.extend(center + extent);
}

/// How far the points a x + b y + c z with x^2 + y^2 + z^2 = 1 reach along each axis: the lengths
/// of the rows.
Vec3d reach(const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept {
  const auto row = [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); };
  return {row(a.x, b.x, c.x), row(a.y, b.y, c.y), row(a.z, b.z, c.z)};
}

Box3 boundsOf(const Sphere<double>& sphere, const Affine& placement) noexcept {
  const double r = sphere.radius;
  Box3 box;
  extend(box, placement.point(sphere.center),
         reach(placement.column(0) * r, placement.column(1) * r, placement.column(2) * r));
  return box;
}

/// The shape lies between its two rims, which are circles around z in its own space.
Box3 boundsOf(const Cone<double>& cone, const Affine& placement) noexcept {
  Box3 box;
  const std::array rims = {std::pair(cone.base, cone.bottomRadius),
                           std::pair(cone.base + cone.axis, cone.topRadius)};
  for (const auto& [center, radius] : rims) {
    extend(box, placement.point(center),
           reach(placement.column(0) * radius, placement.column(1) * radius, {}));
  }
  return box;
}

}  // namespace

template <class Local>
Box3 TransformedShape<Local>::bounds() const noexcept {
  return boundsOf(local_, placement_);
}

template <class Local>
std::optional<Hitf> TransformedShape<Local>::intersect(const Rayf& ray, float tMin,
                                                       float tMax) const noexcept {
  const Ray<double> localRay{.origin = toLocal_.point(Vec3d(ray.origin)),
                             .direction = toLocal_.vector(Vec3d(ray.direction))};
  // The interval is that of floats: a double between two of them would be found again, or skipped,
  // when the search goes on behind a hit. So all roots are rounded before they are compared.
  for (double from = -INFINITY;;) {
    const std::optional<Hitd> hit = local_.intersect(localRay, from, INFINITY);
    if (!hit)
      return std::nullopt;
    const auto t = static_cast<float>(hit->t);
    if (t > tMax)
      return std::nullopt;
    if (t >= tMin) {
      return Hitf{.t = t,
                  .u = static_cast<float>(hit->u),
                  .v = static_cast<float>(hit->v),
                  .normal = Vec3f(normalized(placement_.normal(hit->normal))),
                  .part = hit->part};
    }
    from = std::nextafter(hit->t, INFINITY);
  }
}

template class TransformedShape<Sphere<double>>;
template class TransformedShape<Cone<double>>;

}  // namespace planetree::scene
