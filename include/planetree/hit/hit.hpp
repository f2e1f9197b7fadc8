#pragma once

#include <planetree/geometry/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace planetree {

/// The id that names nothing: the geometry and primitive of a miss.
inline constexpr std::uint32_t kNoId = 0xFFFF'FFFFu;

/// Where a ray meets an object. A default-made hit is a miss: t is infinite, the ids are `kNoId`.
template <class T>
struct Hit {
  T t = std::numeric_limits<T>::infinity();  ///< distance in units of the direction's length
  /// On a triangle (a, b, c), the barycentric weights of b and c: the point is
  /// (1 - u - v) a + u b + v c. On other shapes the parameters that the shape documents.
  T u = T(0);
  T v = T(0);
  /// Geometric normal, unit length, on the side the object's orientation gives (for a triangle
  /// that from which its corners run counter-clockwise); never turned toward the ray.
  Vec3<T> normal = {};
  std::uint32_t geometry = kNoId;   ///< which geometry of the scene
  std::uint32_t primitive = kNoId;  ///< which face or shape of that geometry
  std::uint32_t part = 0;           ///< which piece of the shape's surface, as the shape documents
  std::uint32_t instance = 0;       ///< always 0: room for trees inside trees

  friend constexpr bool operator==(const Hit&, const Hit&) noexcept = default;
};

using Hitf = Hit<float>;
using Hitd = Hit<double>;

static_assert(std::is_standard_layout_v<Hitf> && std::is_trivially_copyable_v<Hitf>);
static_assert(sizeof(Hitf) == 40 && sizeof(Hitd) == 64);
static_assert(offsetof(Hitf, u) == 4 && offsetof(Hitf, v) == 8 && offsetof(Hitf, normal) == 12);
static_assert(offsetof(Hitf, geometry) == 24 && offsetof(Hitf, primitive) == 28);
static_assert(offsetof(Hitf, part) == 32 && offsetof(Hitf, instance) == 36);
static_assert(offsetof(Hitd, u) == 8 && offsetof(Hitd, v) == 16 && offsetof(Hitd, normal) == 24);
static_assert(offsetof(Hitd, geometry) == 48 && offsetof(Hitd, primitive) == 52);
static_assert(offsetof(Hitd, part) == 56 && offsetof(Hitd, instance) == 60);

/// The order in which hits win: nearer first, then lower geometry, primitive, part. With it the
/// answer to a query depends on the ray and the scene alone, never on the tree.
template <class T>
[[nodiscard]] constexpr bool isBefore(const Hit<T>& a, const Hit<T>& b) noexcept {
  if (a.t != b.t)
    return a.t < b.t;
  if (a.geometry != b.geometry)
    return a.geometry < b.geometry;
  if (a.primitive != b.primitive)
    return a.primitive < b.primitive;
  return a.part < b.part;
}

}  // namespace planetree
