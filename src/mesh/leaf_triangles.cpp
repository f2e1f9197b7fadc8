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

void LeafTriangles::clear() {
  triangles_.clear();
  positions_.clear();
  usedIn_.clear();
  placeInBlock_.clear();
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
  std::size_t laneCount = TriangleBlock::kLaneCount;  // as if there were a full block already
  std::size_t positionCount = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [a, b, c] = triangles_[places[i]].corners;
    std::size_t newCount = countNewCorners(triangles_[places[i]]);
    if (laneCount == TriangleBlock::kLaneCount ||
        positionCount + newCount > TriangleBlock::kPositionCount) {
      ++blockCount;
      ++countedBlocks_;
      laneCount = 0;
      positionCount = 0;
      newCount = countNewCorners(triangles_[places[i]]);
    }
    positionCount += newCount;
    ++laneCount;
    usedIn_[a] = countedBlocks_;
    usedIn_[b] = countedBlocks_;
    usedIn_[c] = countedBlocks_;
    counts[i] = blockCount;
  }
}

std::size_t LeafTriangles::countNewCorners(const Triangle& triangle) const noexcept {
  const auto [a, b, c] = triangle.corners;
  // Without branches: which corners are new is as good as random.
  const auto isNew = [&](std::uint32_t corner) {
    return static_cast<unsigned>(usedIn_[corner] != countedBlocks_);
  };
  const auto differ = [](std::uint32_t one, std::uint32_t other) {
    return static_cast<unsigned>(one != other);
  };
  return isNew(a) + (isNew(b) & differ(b, a)) + (isNew(c) & differ(c, a) & differ(c, b));
}

TriangleBlock LeafTriangles::pack(std::span<const std::uint32_t> places) {
  PLANETREE_ASSERT(places.size() <= TriangleBlock::kLaneCount);
  TriangleBlock block = {};
  ++countedBlocks_;
  std::size_t usedCount = 0;
  for (std::size_t lane = 0; lane < places.size(); ++lane) {
    const Triangle& triangle = triangles_[places[lane]];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t position = triangle.corners[corner];
      if (usedIn_[position] != countedBlocks_) {
        PLANETREE_ASSERT(usedCount < TriangleBlock::kPositionCount);
        usedIn_[position] = countedBlocks_;
        placeInBlock_[position] = static_cast<std::uint8_t>(usedCount);
        for (const Axis axis : kAxes)
          block.positions[static_cast<std::size_t>(axis)][usedCount] = positions_[position][axis];
        ++usedCount;
      }
      block.corners[corner][lane] = placeInBlock_[position];
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
  placeInBlock_.push_back(0);
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
