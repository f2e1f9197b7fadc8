#pragma once

#include <planetree/geometry/sheared_ray.hpp>
#include <planetree/geometry/vec3.hpp>

#include <cstdint>
#include <optional>

namespace planetree {

/// Where a ray meets a triangle (a, b, c): at distance t, with weights u of b and v of c.
template <class T>
struct TriangleIntersection {
  T t;
  T u;
  T v;
  bool isFromFront;  ///< whether a, b, c run counter-clockwise as the ray sees them
};

/// What a ray hits that meets an edge or a vertex exactly.
enum class EdgeRule : std::uint8_t {
  Closed,    ///< every triangle there: no ray slips through
  HalfOpen,  ///< what a ray an infinitesimal step aside would; see `QueryOptions::crossings`
};

/// The point where the ray meets the triangle, if its t lies in [tMin, tMax]; both sides count, and
/// so do the edges, as `rule` says. Degenerate triangles are missed, but for the tiny area that
/// rounding may give them; a ray whose direction is zero, infinite or NaN misses.
///
/// Watertight: a ray that meets an edge shared by two triangles meets at least one of them,
/// whatever is rounded. Woop, Benthin, Wald, "Watertight ray/triangle intersection", JCGT 2013. In
/// contrast to the paper the weights of a triangle that is hit are always computed anew with
/// (nearly) exact edge functions, not only at exact zeros, so that t is right to a few ulps for
/// slivers too; the bound is derived in docs/numerics.md, and the tree relies on it. For the double
/// version, exact zeros are decided by error-free products.
template <class T>
[[nodiscard]] std::optional<TriangleIntersection<T>> intersectTriangle(
    const ShearedRay<T>& ray, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, T tMin, T tMax,
    EdgeRule rule = EdgeRule::Closed) noexcept;

/// The unit normal on the side from which a, b, c run counter-clockwise. A triangle without area
/// has none: for it the result faces the ray.
template <class T>
[[nodiscard]] Vec3<T> triangleNormal(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c,
                                     const Vec3<T>& rayDirection) noexcept;

}  // namespace planetree
