#pragma once

#include <planetree/detail/bounding_table.hpp>
#include <planetree/detail/geometry_entry.hpp>
#include <planetree/detail/intersection_table.hpp>
#include <planetree/mesh/triangle_mesh.hpp>
#include <planetree/object.hpp>

#include <concepts>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace planetree::detail {

template <class O>
inline constexpr bool kIsFace = false;
template <class T>
inline constexpr bool kIsFace<Face<T>> = true;

/// What a tree of objects O sees as its range of objects.
template <class O>
struct RangeOf {
  using type = std::span<const O>;
};
template <class T>
struct RangeOf<Face<T>> {
  using type = TriangleMeshView<T>;
};

/// Storage that a range refers to, and the range.
template <class Storage, class Range>
struct OwnedRange {
  Storage storage;
  Range range;
};

/// Faces have tables of their own: they say why they are skipped, and share the sheared ray.
template <class T>
[[nodiscard]] const BoundingTable& faceBoundingTable() noexcept;
extern template const BoundingTable& faceBoundingTable<float>() noexcept;
extern template const BoundingTable& faceBoundingTable<double>() noexcept;
template <class T>
[[nodiscard]] const IntersectionTable<T>& faceIntersectionTable() noexcept;
extern template const IntersectionTable<float>& faceIntersectionTable<float>() noexcept;
extern template const IntersectionTable<double>& faceIntersectionTable<double>() noexcept;

template <Object O>
[[nodiscard]] GeometryEntry<ScalarOf<O>> entryOf(const std::span<const O>& range,
                                                 std::shared_ptr<const void> owner) {
  GeometryEntry<ScalarOf<O>> entry;
  entry.bounding = &kBoundingTable<std::span<const O>>;
  entry.intersecting = &kIntersectionTable<std::span<const O>, ScalarOf<O>>;
  entry.range = &range;
  entry.owner = std::move(owner);
  entry.size = range.size();
  return entry;
}

template <std::floating_point T>
[[nodiscard]] GeometryEntry<T> entryOf(const TriangleMeshView<T>& range,
                                       std::shared_ptr<const void> owner) {
  GeometryEntry<T> entry;
  entry.bounding = &faceBoundingTable<T>();
  entry.intersecting = &faceIntersectionTable<T>();
  entry.range = &range;
  entry.owner = std::move(owner);
  entry.size = range.size();
  return entry;
}

/// A geometry that keeps its objects: they live as long as the entry or a copy of it.
template <Object O>
[[nodiscard]] GeometryEntry<ScalarOf<O>> ownedEntry(std::vector<O> objects) {
  auto owned = std::make_shared<OwnedRange<std::vector<O>, std::span<const O>>>();
  owned->storage = std::move(objects);
  owned->range = owned->storage;
  return entryOf<O>(owned->range, owned);
}

template <std::floating_point T>
[[nodiscard]] GeometryEntry<T> ownedEntry(TriangleMesh<T> mesh) {
  auto owned = std::make_shared<OwnedRange<TriangleMesh<T>, TriangleMeshView<T>>>();
  owned->storage = std::move(mesh);
  owned->range = owned->storage.view();
  return entryOf(owned->range, owned);
}

/// A geometry of objects that stay the caller's.
template <Object O>
[[nodiscard]] GeometryEntry<ScalarOf<O>> viewedEntry(std::span<const O> objects) {
  const auto range = std::make_shared<const std::span<const O>>(objects);
  return entryOf<O>(*range, range);
}

template <std::floating_point T>
[[nodiscard]] GeometryEntry<T> viewedEntry(TriangleMeshView<T> mesh) {
  const auto range = std::make_shared<const TriangleMeshView<T>>(mesh);
  return entryOf(*range, range);
}

}  // namespace planetree::detail
