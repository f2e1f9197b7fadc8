#include "mesh/leaf_triangles.hpp"

#include "support/assert.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace planetree::detail {
namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kSmallestTable = 256;

std::array<std::uint32_t, 3> bitsOf(const Vec3f& position) noexcept {
  return {std::bit_cast<std::uint32_t>(position.x), std::bit_cast<std::uint32_t>(position.y),
          std::bit_cast<std::uint32_t>(position.z)};
}

}  // namespace

void LeafTriangles::clear() noexcept {
  triangles_.clear();
  positions_.clear();
  usedIn_.clear();
  countedBlocks_ = 0;
  // Small again: to clear what a large leaf took would cost every leaf after it.
  table_.assign(kSmallestTable, kFree);
}

void LeafTriangles::add(const std::array<Vec3f, 3>& corners, std::uint32_t object) {
  triangles_.push_back({{indexOf(corners[0]), indexOf(corners[1]), indexOf(corners[2])}, object});
}

void LeafTriangles::countBlocks(std::span<const std::uint32_t> places,
                                std::span<std::uint32_t> counts) {
  std::uint32_t blockCount = 0;
  std::size_t laneCount = 0;
  std::size_t positionCount = 0;
  const auto isNew = [&](const Triangle& triangle, std::size_t corner) {
    const std::uint32_t position = triangle.corners[corner];
    return usedIn_[position] != countedBlocks_ &&
           std::find(triangle.corners.begin(), triangle.corners.begin() + corner, position) ==
               triangle.corners.begin() + corner;
  };
  const auto newPositionsOf = [&](const Triangle& triangle) -> std::size_t {
    return std::size_t{isNew(triangle, 0)} + isNew(triangle, 1) + isNew(triangle, 2);
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Triangle& triangle = triangles_[places[i]];
    const bool fits = laneCount < TriangleBlock::kLaneCount &&
                      positionCount + newPositionsOf(triangle) <= TriangleBlock::kPositionCount;
    if (blockCount == 0 || !fits) {
      ++blockCount;
      ++countedBlocks_;
      laneCount = 0;
      positionCount = 0;
    }
    positionCount += newPositionsOf(triangle);
    ++laneCount;
    for (const std::uint32_t position : triangle.corners)
      usedIn_[position] = countedBlocks_;
    counts[i] = blockCount;
  }
}

TriangleBlock LeafTriangles::pack(std::span<const std::uint32_t> places) const {
  PLANETREE_ASSERT(places.size() <= TriangleBlock::kLaneCount);
  TriangleBlock block = {};
  std::array<std::uint32_t, TriangleBlock::kPositionCount> used;
  auto usedEnd = used.begin();
  for (std::size_t lane = 0; lane < places.size(); ++lane) {
    const Triangle& triangle = triangles_[places[lane]];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t position = triangle.corners[corner];
      const auto at = std::find(used.begin(), usedEnd, position);
      const auto inBlock = static_cast<std::size_t>(at - used.begin());
      if (at == usedEnd) {
        PLANETREE_ASSERT(usedEnd != used.end());
        *usedEnd++ = position;
        for (const Axis axis : kAxes)
          block.positions[static_cast<std::size_t>(axis)][inBlock] = positions_[position][axis];
      }
      block.corners[corner][lane] = static_cast<std::uint8_t>(inBlock);
    }
    block.objects[lane] = triangle.object;
  }
  block.usedLanes = (1u << places.size()) - 1u;
  return block;
}

std::uint32_t LeafTriangles::indexOf(const Vec3f& position) {
  if (2 * (positions_.size() + 1) > table_.size())
    growTable();
  std::size_t at = homeOf(position);
  while (table_[at] != kFree) {
    if (bitsOf(positions_[table_[at]]) == bitsOf(position))
      return table_[at];
    at = (at + 1) % table_.size();
  }
  table_[at] = static_cast<std::uint32_t>(positions_.size());
  positions_.push_back(position);
  usedIn_.push_back(countedBlocks_);
  return table_[at];
}

void LeafTriangles::growTable() {
  table_.assign(std::max(kSmallestTable, 2 * table_.size()), kFree);
  for (std::uint32_t i = 0; i < positions_.size(); ++i) {
    std::size_t at = homeOf(positions_[i]);
    while (table_[at] != kFree)
      at = (at + 1) % table_.size();
    table_[at] = i;
  }
}

std::size_t LeafTriangles::homeOf(const Vec3f& position) const noexcept {
  std::uint64_t hash = 0;
  for (const std::uint32_t bits : bitsOf(position))
    hash = (hash ^ bits) * 0x9E37'79B9'7F4A'7C15u;
  return static_cast<std::size_t>(hash >> 32u) % table_.size();
}

}  // namespace planetree::detail
