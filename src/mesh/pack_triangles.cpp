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

/// Adds blocks with the faces, whose corners stand in them as `cornersInBlock` says.
template <class T, class CornersInBlock>
void packAll(const TriangleMeshView<T>& mesh, std::span<const std::uint32_t> objects,
             std::uint32_t firstObject, std::vector<TriangleBlock>& blocks,
             std::vector<Box3>& bounds, const CornersInBlock& cornersInBlock) {
  BlockBuilder builder;
  Box3 box;
  const auto finish = [&] {
    blocks.push_back(builder.finish());
    bounds.push_back(box);
    builder = {};
    box = {};
  };
  for (const std::uint32_t object : objects) {
    const std::array<Vec3<T>, 3> triangle = mesh.corners(object - firstObject);
    const std::array<Vec3f, 3> corners = cornersInBlock(triangle);
    if (!builder.add(corners, object)) {
      finish();
      builder.add(corners, object);
    }
    for (const Vec3<T>& corner : triangle)
      box.extend(corner);
  }
  if (!objects.empty())
    finish();
}

}  // namespace

void packTriangles(const TriangleMeshView<float>& mesh, std::span<const std::uint32_t> objects,
                   std::uint32_t firstObject, std::vector<TriangleBlock>& blocks,
                   std::vector<Box3>& bounds) {
  packAll(mesh, objects, firstObject, blocks, bounds,
          [](const std::array<Vec3f, 3>& corners) { return corners; });
}

void packRoundedTriangles(const TriangleMeshView<double>& mesh,
                          std::span<const std::uint32_t> objects, std::uint32_t firstObject,
                          const Vec3f& center, std::vector<TriangleBlock>& blocks,
                          std::vector<Box3>& bounds) {
  const auto middle = static_cast<Vec3d>(center);
  packAll(mesh, objects, firstObject, blocks, bounds,
          [&](const std::array<Vec3d, 3>& corners) -> std::array<Vec3f, 3> {
            return {static_cast<Vec3f>(corners[0] - middle),
                    static_cast<Vec3f>(corners[1] - middle),
                    static_cast<Vec3f>(corners[2] - middle)};
          });
}

}  // namespace planetree::detail
