#pragma once

#include <planetree/geometry/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace planetree::detail {

/// Up to sixteen triangles that are tested together. They share their corners, as the faces of a
/// mesh do: the positions are moved and sheared once, and the triangles pick theirs.
struct alignas(64) TriangleBlock {
  static constexpr std::size_t kLaneCount = 16;
  static constexpr std::size_t kPositionCount = 16;

  float positions[3][kPositionCount];   ///< by axis
  std::uint8_t corners[3][kLaneCount];  ///< of a triangle: which positions
  std::uint32_t usedLanes;              ///< bit i: lane i holds a triangle
  /// The tree's numbers of the triangles. In a cache line of their own, which is read for hits
  /// only.
  alignas(64) std::array<std::uint32_t, kLaneCount> objects;

  [[nodiscard]] Vec3f corner(std::size_t lane, std::size_t which) const noexcept {
    const std::size_t i = corners[which][lane];
    return {positions[0][i], positions[1][i], positions[2][i]};
  }
};
static_assert(sizeof(TriangleBlock) == 320);

}  // namespace planetree::detail
