#include "mesh/pack_triangles.hpp"

#include <array>
#include <bit>

namespace planetree::detail {
namespace {

/// By bits: 0 and -0 would round to different zeros.
bool isSamePosition(const Vec3f& a, const Vec3f& b) noexcept {
  for (const Axis axis : kAxes) {
    if (std::bit_cast<std::uint32_t>(a[axis]) != std::bit_cast<std::uint32_t>(b[axis]))
      return false;
  }
  return true;
}

/// A block that is being filled.
class BlockBuilder {
 public:
  /// Adds a triangle; false, and no change, if there is no room for it or its corners.
  bool add(const std::array<Vec3f, 3>& triangle, std::uint32_t object) {
    if (laneCount_ == TriangleBlock::kLaneCount)
      return false;
    const std::size_t positionCount = positionCount_;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t position = positionOf(triangle[corner]);
      if (position == TriangleBlock::kPositionCount) {
        positionCount_ = positionCount;
        return false;
      }
      block_.corners[corner][laneCount_] = static_cast<std::uint8_t>(position);
    }
    block_.objects[laneCount_++] = object;
    return true;
  }

  [[nodiscard]] TriangleBlock finish() noexcept {
    block_.usedLanes = (1u << laneCount_) - 1u;
    return block_;
  }

 private:
  /// Where the position stands, added if it is new; `kPositionCount` if there is no room.
  std::size_t positionOf(const Vec3f& position) {
    for (std::size_t i = 0; i < positionCount_; ++i) {
      if (isSamePosition(positions_[i], position))
        return i;
    }
    if (positionCount_ == TriangleBlock::kPositionCount)
      return positionCount_;
    positions_[positionCount_] = position;
    for (const Axis axis : kAxes)
      block_.positions[static_cast<std::size_t>(axis)][positionCount_] = position[axis];
    return positionCount_++;
  }

  TriangleBlock block_ = {};
  std::array<Vec3f, TriangleBlock::kPositionCount> positions_ = {};
  std::size_t positionCount_ = 0;
  std::size_t laneCount_ = 0;
};

/// Adds blocks with the objects, whose corners are what `cornersOf` says.
template <class CornersOf>
std::size_t packAll(std::span<const std::uint32_t> objects, std::vector<TriangleBlock>& blocks,
                    const CornersOf& cornersOf) {
  const std::size_t before = blocks.size();
  BlockBuilder builder;
  bool isEmpty = true;
  for (const std::uint32_t object : objects) {
    const std::array<Vec3f, 3> triangle = cornersOf(object);
    if (!builder.add(triangle, object)) {
      blocks.push_back(builder.finish());
      builder = {};
      builder.add(triangle, object);
    }
    isEmpty = false;
  }
  if (!isEmpty)
    blocks.push_back(builder.finish());
  return blocks.size() - before;
}

}  // namespace

std::size_t packTriangles(const TriangleMeshView<float>& mesh,
                          std::span<const std::uint32_t> objects, std::uint32_t firstObject,
                          std::vector<TriangleBlock>& blocks) {
  return packAll(objects, blocks,
                 [&](std::uint32_t object) { return mesh.corners(object - firstObject); });
}

std::size_t packRoundedTriangles(const TriangleMeshView<double>& mesh,
                                 std::span<const std::uint32_t> objects, std::uint32_t firstObject,
                                 const Vec3f& center, std::vector<TriangleBlock>& blocks) {
  const auto middle = static_cast<Vec3d>(center);
  return packAll(objects, blocks, [&](std::uint32_t object) -> std::array<Vec3f, 3> {
    const auto [a, b, c] = mesh.corners(object - firstObject);
    return {static_cast<Vec3f>(a - middle), static_cast<Vec3f>(b - middle),
            static_cast<Vec3f>(c - middle)};
  });
}

}  // namespace planetree::detail
