#pragma once

#include <planetree/detail/object_table.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace planetree::detail {

/// One geometry of a tree: a range of objects and the functions that reach them.
template <class T>
struct GeometryEntry {
  const ObjectTable<T>* table = nullptr;
  const void* range = nullptr;
  std::shared_ptr<const void> owner;  ///< keeps `range` alive, and what it refers to if owned
  std::size_t size = 0;
  std::uint32_t firstObject = 0;  ///< the tree's number of primitive 0
  std::uint32_t mask = 0xFFFF'FFFFu;
  void* userPointer = nullptr;
};

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

/// Faces have a table of their own: they share the sheared ray and say why they are skipped.
template <class T>
[[nodiscard]] const ObjectTable<T>& faceTable() noexcept;
extern template const ObjectTable<float>& faceTable<float>() noexcept;
extern template const ObjectTable<double>& faceTable<double>() noexcept;

template <Object O>
[[nodiscard]] GeometryEntry<ScalarOf<O>> ownedEntry(std::vector<O> objects) {
  using Owned = OwnedRange<std::vector<O>, std::span<const O>>;
  auto owned = std::make_shared<Owned>();
  owned->storage = std::move(objects);
  owned->range = owned->storage;
  GeometryEntry<ScalarOf<O>> entry;
  entry.table = &kObjectTable<std::span<const O>, ScalarOf<O>>;
  entry.range = &owned->range;
  entry.size = owned->storage.size();
  entry.owner = std::move(owned);
  return entry;
}

template <Object O>
[[nodiscard]] GeometryEntry<ScalarOf<O>> viewedEntry(std::span<const O> objects) {
  auto range = std::make_shared<std::span<const O>>(objects);
  GeometryEntry<ScalarOf<O>> entry;
  entry.table = &kObjectTable<std::span<const O>, ScalarOf<O>>;
  entry.range = range.get();
  entry.size = objects.size();
  entry.owner = std::move(range);
  return entry;
}

template <std::floating_point T>
[[nodiscard]] GeometryEntry<T> ownedEntry(TriangleMesh<T> mesh) {
  auto owned = std::make_shared<OwnedRange<TriangleMesh<T>, TriangleMeshView<T>>>();
  owned->storage = std::move(mesh);
  owned->range = owned->storage.view();
  GeometryEntry<T> entry;
  entry.table = &faceTable<T>();
  entry.range = &owned->range;
  entry.size = owned->range.size();
  entry.owner = std::move(owned);
  return entry;
}

template <std::floating_point T>
[[nodiscard]] GeometryEntry<T> viewedEntry(TriangleMeshView<T> mesh) {
  auto range = std::make_shared<TriangleMeshView<T>>(mesh);
  GeometryEntry<T> entry;
  entry.table = &faceTable<T>();
  entry.range = range.get();
  entry.size = mesh.size();
  entry.owner = std::move(range);
  return entry;
}

}  // namespace planetree::detail
