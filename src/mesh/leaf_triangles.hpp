#pragma once

#include <planetree/geometry/vec3.hpp>

#include "node/triangle_block.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree::detail {

/// The triangles of a leaf, to be put into blocks in any order. Corners with the same bits share a
/// position: 0 and -0 do not, as they would round to different zeros.
class LeafTriangles {
 public:
  void clear();
  /// `object` is the tree's number of the triangle.
  void add(const std::array<Vec3f, 3>& corners, std::uint32_t object);

  /// `counts[i]` becomes the number of blocks that the first i + 1 of `places` take, which are
  /// filled one after the other.
  void countBlocks(std::span<const std::uint32_t> places, std::span<std::uint32_t> counts);

  /// The block with the triangles at `places`, which fit into one.
  [[nodiscard]] TriangleBlock pack(std::span<const std::uint32_t> places);

 private:
  struct Triangle {
    std::array<std::uint32_t, 3> corners;  ///< indices of positions
    std::uint32_t object;
  };

  /// How many positions a triangle adds to the block that is being counted.
  [[nodiscard]] std::size_t countNewCorners(const Triangle& triangle) const noexcept;
  [[nodiscard]] std::uint32_t indexOf(const Vec3f& position);
  void growTable();
  [[nodiscard]] std::size_t homeOf(const Vec3f& position) const noexcept;

  std::vector<Triangle> triangles_;
  std::vector<Vec3f> positions_;
  std::vector<std::uint32_t> table_;   ///< by hash: indices of positions, or none
  std::vector<std::uint32_t> usedIn_;  ///< the block that the position was counted in last
  std::uint32_t countedBlocks_ = 0;    ///< in all countings, so that each block has its own number
  std::vector<std::uint8_t> placeInBlock_;  ///< of a position in the block that is being packed
};

}  // namespace planetree::detail
