#include <planetree/mesh/triangle_intersection.hpp>

#include "mesh/exact_arithmetic.hpp"
#include "mesh/float_normal.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace planetree {
namespace {

/// A corner as the ray sees it: the ray is the third axis, its origin the origin.
template <class T>
struct ShearedCorner {
  T x;
  T y;
  T z;
};

/// A double that is too small counts as zero: products of smaller ones would lose bits by underflow
/// or vanish, weights would be wrong, and t could lie anywhere. It is far below all that is rounded
/// off, and the same for all triangles at a corner.
template <class T>
T withoutUnderflow(T coordinate) noexcept {
  if constexpr (std::is_same_v<T, double>)
    return std::fabs(coordinate) < 0x1p-400 ? 0.0 : coordinate;
  return coordinate;
}

template <class T>
ShearedCorner<T> shearCorner(const ShearedRay<T>& ray, const Vec3<T>& corner) noexcept {
  const Vec3<T> relative = corner - ray.ray.origin;
  const T z = relative[ray.kz];
  return {withoutUnderflow(relative[ray.kx] - ray.shearX * z),
          withoutUnderflow(relative[ray.ky] - ray.shearY * z), z};
}

/// The weights of the corners, not yet divided by their sum.
template <class W>
struct Weights {
  W a;
  W b;
  W c;

  [[nodiscard]] bool hasZero() const noexcept { return a == W(0) || b == W(0) || c == W(0); }
  /// The origin lies outside the projected triangle if two edges see it on different sides.
  [[nodiscard]] bool hasMixedSigns() const noexcept {
    return (a < W(0) || b < W(0) || c < W(0)) && (a > W(0) || b > W(0) || c > W(0));
  }
};

template <class T>
Weights<T> roundedWeights(const ShearedCorner<T>& a, const ShearedCorner<T>& b,
                          const ShearedCorner<T>& c) noexcept {
  return {c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x};
}

template <class T>
Weights<double> accurateWeights(const ShearedCorner<T>& a, const ShearedCorner<T>& b,
                                const ShearedCorner<T>& c) noexcept {
  return {detail::differenceOfProducts(c.x, b.y, c.y, b.x),
          detail::differenceOfProducts(a.x, c.y, a.y, c.x),
          detail::differenceOfProducts(b.x, a.y, b.y, a.x)};
}

/// The sign of the edge function from p to q, never zero unless the edge is a point: as seen not
/// from the origin, but from the point (e, e^2) beside it, for e that tends to zero. There the
/// function is `weight - e (q.y - p.y) + e^2 (q.x - p.x)`, so that the first of these terms that is
/// not zero decides. It changes its sign with the direction of the edge, and compares coordinates
/// that are the same for all triangles at a corner.
template <class T>
int signBesideOrigin(double weight, const ShearedCorner<T>& p, const ShearedCorner<T>& q) noexcept {
  if (weight != 0.0)
    return weight > 0.0 ? 1 : -1;
  if (p.y != q.y)
    return q.y < p.y ? 1 : -1;
  return q.x > p.x ? 1 : q.x < p.x ? -1 : 0;
}

/// Whether the point beside the origin lies inside the projected triangle.
template <class T>
bool containsPointBesideOrigin(const Weights<double>& weights, const ShearedCorner<T>& a,
                               const ShearedCorner<T>& b, const ShearedCorner<T>& c) noexcept {
  const int side = signBesideOrigin(weights.a, c, b);
  return side != 0 && side == signBesideOrigin(weights.b, a, c) &&
         side == signBesideOrigin(weights.c, b, a);
}

}  // namespace

template <class T>
std::optional<TriangleIntersection<T>> intersectTriangle(const ShearedRay<T>& ray, const Vec3<T>& a,
                                                         const Vec3<T>& b, const Vec3<T>& c, T tMin,
                                                         T tMax, EdgeRule rule) noexcept {
  const ShearedCorner<T> shearedA = shearCorner(ray, a);
  const ShearedCorner<T> shearedB = shearCorner(ray, b);
  const ShearedCorner<T> shearedC = shearCorner(ray, c);

  // Rounding is monotonic, so the sign of the difference of two rounded products is never wrong; it
  // can only vanish. Hence the cheap weights decide unless one of them is zero.
  const Weights<T> rounded = roundedWeights(shearedA, shearedB, shearedC);
  const bool decided = !rounded.hasZero();
  if (decided && rounded.hasMixedSigns())
    return std::nullopt;

  // Few triangles come this far. Their weights must be accurate relative to themselves: the rounded
  // ones would let t wander along a sliver, away from the cells that hold the point that is hit.
  const Weights<double> weights = accurateWeights(shearedA, shearedB, shearedC);
  if (!decided && weights.hasMixedSigns())
    return std::nullopt;
  const double sum = weights.a + weights.b + weights.c;
  if (sum == 0.0)
    return std::nullopt;

  if (rule == EdgeRule::HalfOpen && !decided &&
      !containsPointBesideOrigin(weights, shearedA, shearedB, shearedC))
    return std::nullopt;

  const double z = weights.a * static_cast<double>(shearedA.z) +
                   weights.b * static_cast<double>(shearedB.z) +
                   weights.c * static_cast<double>(shearedC.z);
  const auto t = static_cast<T>(z / (sum * static_cast<double>(ray.ray.direction[ray.kz])));
  // A NaN fails both comparisons.
  if (!(t >= tMin && t <= tMax))
    return std::nullopt;
  return TriangleIntersection<T>{t, static_cast<T>(weights.b / sum),
                                 static_cast<T>(weights.c / sum),
                                 (sum > 0.0) == (ray.ray.direction[ray.kz] > T(0))};
}

namespace {

/// The vector from one point to another, and what rounding took from it. Lengths from which
/// products could over- or underflow are scaled by a power of two.
struct ExpandedEdge {
  Vec3d value;
  Vec3d rest;

  ExpandedEdge(const Vec3d& from, const Vec3d& to) noexcept {
    for (const Axis axis : kAxes) {
      const detail::ExpandedDouble difference = detail::exactSum(to[axis], -from[axis]);
      value[axis] = difference.value;
      rest[axis] = difference.rest;
    }
    const double largest = std::max({std::fabs(value.x), std::fabs(value.y), std::fabs(value.z)});
    if (!(largest > 0x1p-300))
      scale(0x1p+600);
    if (largest > 0x1p+300)
      scale(0x1p-600);
  }

 private:
  void scale(double factor) noexcept {
    value = value * factor;
    rest = rest * factor;
  }
};

/// The edges' cross product, for doubles in twice the precision: the rounding of a plain product
/// hides which way a narrow triangle faces. Up to a factor.
Vec3d crossOfEdges(const Vec3d& a, const Vec3d& b, const Vec3d& c) noexcept {
  const ExpandedEdge p(a, b);
  const ExpandedEdge q(a, c);
  const auto component = [&](Axis i, Axis j) {
    const double ofRests = p.value[i] * q.rest[j] + p.rest[i] * q.value[j] -
                           (p.value[j] * q.rest[i] + p.rest[j] * q.value[i]);
    const detail::ExpandedDouble first = detail::exactProduct(p.value[i], q.value[j]);
    const detail::ExpandedDouble second = detail::exactProduct(p.value[j], q.value[i]);
    const detail::ExpandedDouble values = detail::exactSum(first.value, -second.value);
    return values.value + (values.rest + ((first.rest - second.rest) + ofRests));
  };
  return {component(Axis::Y, Axis::Z), component(Axis::Z, Axis::X), component(Axis::X, Axis::Y)};
}

}  // namespace

template <class T>
Vec3<T> triangleNormal(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c,
                       const Vec3<T>& rayDirection) noexcept {
  if constexpr (std::is_same_v<T, float>) {
    return detail::floatNormal(a, b, c, rayDirection);
  } else {
    const Vec3d normal = crossOfEdges(a, b, c);
    return normalized(normal == Vec3d{} ? -rayDirection : normal);
  }
}

template std::optional<TriangleIntersection<float>> intersectTriangle(const ShearedRay<float>&,
                                                                      const Vec3f&, const Vec3f&,
                                                                      const Vec3f&, float, float,
                                                                      EdgeRule) noexcept;
template std::optional<TriangleIntersection<double>> intersectTriangle(const ShearedRay<double>&,
                                                                       const Vec3d&, const Vec3d&,
                                                                       const Vec3d&, double, double,
                                                                       EdgeRule) noexcept;
template Vec3f triangleNormal(const Vec3f&, const Vec3f&, const Vec3f&, const Vec3f&) noexcept;
template Vec3d triangleNormal(const Vec3d&, const Vec3d&, const Vec3d&, const Vec3d&) noexcept;

}  // namespace planetree
