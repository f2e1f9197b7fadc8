#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/box3.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>

#include <concepts>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

/// What a tree can hold.
///
/// A *shape* is any class with these members; no base class is needed:
///
///     struct Disk {
///       using Scalar = float;                      // float or double
///       Box3 bounds() const;                       // everything `intersect` can hit lies inside
///       std::optional<Hit<Scalar>> intersect(const Ray<Scalar>& ray, Scalar tMin,
///                                            Scalar tMax) const noexcept;
///     };
///
/// `intersect` returns the nearest hit with t in the closed interval [tMin, tMax], or nothing. It
/// looks at the ray's origin and direction only; the interval comes as arguments. Three things must
/// hold:
///  - the hits do not depend on the interval: compute all roots, then choose. Then asking again
///    from `nextUp(hit.t)` finds the next one, and neither skips nor repeats any.
///  - the point at the returned t lies in `bounds()`, but for the rounding of a few operations on
///    numbers as large as the distance from the origin (docs/numerics.md has the exact allowance).
///  - the same arguments give the same bits, from any thread.
/// It fills t, u, v, normal and part; the tree fills the ids.
///
/// An object has at most one hit at each t. Where there would be more, as at the rim of a capped
/// cylinder, the shape settles which part it is on.
///
/// Three members are optional:
///  - `Box3 clippedBounds(const Box3& cell) const` bounds the part of the shape inside the closed
///    cell, rounded outward; an empty box says that the shape does not touch the cell. With it the
///    tree keeps the shape out of the cells that only its box touches.
///  - `int planarSide(Axis axis) const` is the sign of the component of the normal along `axis`,
///    for flat shapes. The textbook rules put a shape that lies in a split plane left of it if the
///    sign is negative, and right of it otherwise.
///  - `intersectCrossing`, called as `intersect` is, answers queries with
///    `QueryOptions::crossings`. Its hits are a part of those of `intersect` with the same t. For
///    shapes without volume that share edges, as triangles do; solid ones have no need of it.
///
/// An *object* is a shape, a `std::variant` of objects, or a pointer to an object (raw,
/// `std::unique_ptr` or `std::shared_ptr`; also to a virtual base such as `Geometry<T>`).
namespace planetree {

template <class S>
concept Shape =
    (std::same_as<typename S::Scalar, float> || std::same_as<typename S::Scalar, double>)&&requires(
        const S& shape, const Ray<typename S::Scalar>& ray, typename S::Scalar t) {
  { shape.bounds() } -> std::convertible_to<Box3>;
  { shape.intersect(ray, t, t) }
  noexcept->std::same_as<std::optional<Hit<typename S::Scalar>>>;
};

template <class S>
concept ShapeWithClippedBounds = Shape<S> && requires(const S& shape, const Box3& cell) {
  { shape.clippedBounds(cell) } -> std::convertible_to<Box3>;
};

template <class S>
concept ShapeWithPlanarSide = Shape<S> && requires(const S& shape, Axis axis) {
  { shape.planarSide(axis) } -> std::convertible_to<int>;
};

template <class S>
concept ShapeWithCrossings = Shape<S> &&
    requires(const S& shape, const Ray<typename S::Scalar>& ray, typename S::Scalar t) {
  { shape.intersectCrossing(ray, t, t) }
  noexcept->std::same_as<std::optional<Hit<typename S::Scalar>>>;
};

namespace detail {

/// How to reach the shape inside an object. The primary template is a shape itself.
template <class O>
struct ObjectTraits {
  static constexpr bool kIsObject = false;
};

template <Shape S>
struct ObjectTraits<S> {
  static constexpr bool kIsObject = true;
  using Scalar = typename S::Scalar;

  /// Calls `visitor` with the shape; nothing happens where there is none (null, valueless).
  template <class Visitor>
  static void visit(const S& shape, Visitor&& visitor) {
    visitor(shape);
  }
};

template <class P>
struct PointerTraits {
  static constexpr bool kIsObject = ObjectTraits<std::remove_const_t<P>>::kIsObject;
};

template <class P>
requires ObjectTraits<std::remove_const_t<P>>::kIsObject struct PointerTraits<P> {
  using Pointee = ObjectTraits<std::remove_const_t<P>>;
  static constexpr bool kIsObject = true;
  using Scalar = typename Pointee::Scalar;

  template <class Pointer, class Visitor>
  static void visit(const Pointer& pointer, Visitor&& visitor) {
    if (pointer)
      Pointee::visit(*pointer, std::forward<Visitor>(visitor));
  }
};

template <class P>
struct ObjectTraits<P*> : PointerTraits<P> {};
template <class P, class D>
struct ObjectTraits<std::unique_ptr<P, D>> : PointerTraits<P> {};
template <class P>
struct ObjectTraits<std::shared_ptr<P>> : PointerTraits<P> {};

template <class First, class... Rest>
requires(ObjectTraits<First>::kIsObject&&...&&
             ObjectTraits<Rest>::kIsObject) struct ObjectTraits<std::variant<First, Rest...>> {
  static constexpr bool kIsObject = true;
  using Scalar = typename ObjectTraits<First>::Scalar;
  static_assert((std::same_as<Scalar, typename ObjectTraits<Rest>::Scalar> && ...),
                "all shapes of a variant must use the same scalar");

  template <class Visitor>
  static void visit(const std::variant<First, Rest...>& object, Visitor&& visitor) {
    if (object.valueless_by_exception())
      return;
    std::visit(
        [&]<class O>(const O& inner) {
          ObjectTraits<O>::visit(inner, std::forward<Visitor>(visitor));
        },
        object);
  }
};

}  // namespace detail

template <class O>
concept Object = detail::ObjectTraits<O>::kIsObject;

/// The precision of the rays that an object answers: float or double.
template <Object O>
using ScalarOf = typename detail::ObjectTraits<O>::Scalar;

/// The box around an object; empty for a null pointer.
template <Object O>
[[nodiscard]] Box3 objectBounds(const O& object) {
  Box3 bounds;
  detail::ObjectTraits<O>::visit(object, [&](const auto& shape) { bounds = shape.bounds(); });
  return bounds;
}

/// The box around the part of an object inside `cell`: what `clippedBounds` says, or else the part
/// of its box inside the cell. Empty if the object does not touch the cell.
template <Object O>
[[nodiscard]] Box3 objectClippedBounds(const O& object, const Box3& cell) {
  Box3 bounds;
  detail::ObjectTraits<O>::visit(object, [&]<class S>(const S& shape) {
    if constexpr (ShapeWithClippedBounds<S>) {
      bounds = shape.clippedBounds(cell);
    } else {
      bounds = intersection(shape.bounds(), cell);
    }
  });
  return bounds;
}

/// The sign of the normal's component along `axis`; 0 for objects that do not say.
template <Object O>
[[nodiscard]] int objectPlanarSide(const O& object, Axis axis) {
  int side = 0;
  detail::ObjectTraits<O>::visit(object, [&]<class S>(const S& shape) {
    if constexpr (ShapeWithPlanarSide<S>)
      side = shape.planarSide(axis);
  });
  return side;
}

/// The nearest hit of an object with t in [tMin, tMax], or nothing; the ids are left unset.
template <Object O>
[[nodiscard]] std::optional<Hit<ScalarOf<O>>> objectIntersect(const O& object,
                                                              const Ray<ScalarOf<O>>& ray,
                                                              ScalarOf<O> tMin,
                                                              ScalarOf<O> tMax) noexcept {
  std::optional<Hit<ScalarOf<O>>> hit;
  detail::ObjectTraits<O>::visit(
      object, [&](const auto& shape) { hit = shape.intersect(ray, tMin, tMax); });
  return hit;
}

/// The same for a query with `QueryOptions::crossings`.
template <Object O>
[[nodiscard]] std::optional<Hit<ScalarOf<O>>> objectIntersectCrossing(const O& object,
                                                                      const Ray<ScalarOf<O>>& ray,
                                                                      ScalarOf<O> tMin,
                                                                      ScalarOf<O> tMax) noexcept {
  std::optional<Hit<ScalarOf<O>>> hit;
  detail::ObjectTraits<O>::visit(object, [&]<class S>(const S& shape) {
    if constexpr (ShapeWithCrossings<S>) {
      hit = shape.intersectCrossing(ray, tMin, tMax);
    } else {
      hit = shape.intersect(ray, tMin, tMax);
    }
  });
  return hit;
}

}  // namespace planetree
