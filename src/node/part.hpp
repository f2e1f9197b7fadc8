#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/box3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace planetree::detail {

/// What a wide tree is made of: splits of the binary form, splits of the objects of its leaves, and
/// what these end in, a block, an object or nothing. Depth first, as the binary form itself.
struct Part {
  Box3 bounds = {};              ///< of the contents; empty if there is nothing in it
  Axis axis = Axis::X;           ///< of a split: the left child lies before the right one along it
  std::uint32_t right = 0;       ///< of a split: index of its right child, the left one comes next
  std::uint32_t first = 0;       ///< the first block, or the number of a single object
  std::uint32_t blockCount = 0;  ///< blocks that hold all that is in it; 0 if there is no such row

  [[nodiscard]] bool isSplit() const noexcept { return right != 0; }
  [[nodiscard]] bool isEmpty() const noexcept { return bounds.isEmpty(); }
};

[[nodiscard]] constexpr std::size_t leftChild(std::size_t part) noexcept {
  return part + 1;
}
[[nodiscard]] inline std::size_t rightChild(std::span<const Part> parts,
                                            std::size_t part) noexcept {
  return parts[part].right;
}

/// Bounds a split by its children, which must be bounded.
inline void boundSplit(std::span<Part> parts, std::size_t part) noexcept {
  parts[part].bounds = parts[leftChild(part)].bounds;
  parts[part].bounds.extend(parts[rightChild(parts, part)].bounds);
}

}  // namespace planetree::detail
