#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace planetree::detail {

struct BoundingTable;
template <class T>
struct IntersectionTable;

/// One geometry of a tree: a range of objects, and the functions that reach them: one table for
/// building, the other for tracing, which know nothing of each other.
template <class T>
struct GeometryEntry {
  const BoundingTable* bounding = nullptr;
  const IntersectionTable<T>* intersecting = nullptr;
  const void* range = nullptr;
  std::shared_ptr<const void> owner;  ///< keeps `range` alive, and what it refers to if owned
  std::size_t size = 0;
  std::uint32_t firstObject = 0;  ///< the tree's number of primitive 0
  std::uint32_t mask = 0xFFFF'FFFFu;
  void* userPointer = nullptr;
};

/// The geometry that an object number belongs to.
template <class T>
[[nodiscard]] std::uint32_t geometryOf(std::span<const GeometryEntry<T>> geometries,
                                       std::uint32_t object) noexcept {
  std::uint32_t first = 0;
  auto last = static_cast<std::uint32_t>(geometries.size());
  while (last - first > 1) {
    const std::uint32_t middle = first + (last - first) / 2;
    (geometries[middle].firstObject <= object ? first : last) = middle;
  }
  return first;
}

}  // namespace planetree::detail
