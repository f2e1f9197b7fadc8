#include "node/divide_leaf.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <span>
#include <vector>

namespace planetree::detail {
namespace {

constexpr std::uint32_t kFirstObject = 1000;

/// Puts so many objects into a block, whatever they are.
class CountingPacker final : public LeafPacker {
 public:
  explicit CountingPacker(std::size_t objectsPerBlock) : objectsPerBlock_(objectsPerBlock) {}

  bool open(std::span<const std::uint32_t>) override { return true; }
  void countBlocks(std::span<const std::uint32_t> places,
                   std::span<std::uint32_t> counts) override {
    for (std::size_t i = 0; i < places.size(); ++i)
      counts[i] = static_cast<std::uint32_t>(i / objectsPerBlock_ + 1);
  }
  [[nodiscard]] TriangleBlock pack(std::span<const std::uint32_t> places) override {
    EXPECT_LE(places.size(), objectsPerBlock_);
    TriangleBlock block = {};
    block.usedLanes = (1u << places.size()) - 1u;
    std::copy(places.begin(), places.end(), block.objects.begin());
    return block;
  }

 private:
  std::size_t objectsPerBlock_;
};

struct Divided {
  std::vector<Part> parts;
  std::vector<TriangleBlock> blocks;

  /// The longest path of splits.
  [[nodiscard]] std::size_t depth() const {
    std::vector<std::size_t> depths(parts.size(), 0);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!parts[i].isSplit())
        continue;
      depths[i + 1] = depths[i] + 1;
      depths[parts[i].right] = depths[i] + 1;
    }
    return *std::max_element(depths.begin(), depths.end());
  }
};

std::vector<std::uint32_t> numbersOf(std::span<const Box3> boxes) {
  std::vector<std::uint32_t> numbers(boxes.size());
  std::iota(numbers.begin(), numbers.end(), kFirstObject);
  return numbers;
}

Divided divideBoxes(std::span<const Box3> boxes, LeafPacker* packer,
                    const VisitWeight& weight = {}) {
  Divided divided;
  LeafDivider(LeafCuts::AllPositions, weight)
      .divide(numbersOf(boxes), boxes, packer, divided.parts, divided.blocks);
  return divided;
}

std::vector<Box3> randomBoxes(std::size_t count, float size) {
  test::Random random(71);
  std::vector<Box3> boxes(count);
  for (Box3& box : boxes) {
    box.lower = random.pointIn<float>({-1, -1, -1}, {1, 1, 1});
    box.upper = box.lower + random.pointIn<float>({0, 0, 0}, {size, size, size});
  }
  return boxes;
}

void expectContains(const Box3& outer, const Box3& inner) {
  for (const Axis axis : kAxes) {
    EXPECT_LE(outer.lower[axis], inner.lower[axis]);
    EXPECT_GE(outer.upper[axis], inner.upper[axis]);
  }
}

TEST(LeafDivider, PutsEachObjectIntoOneBlockInsideItsBounds) {
  for (const std::size_t count : {1u, 2u, 3u, 16u, 17u, 100u, 6000u}) {
    SCOPED_TRACE(count);
    const std::vector<Box3> boxes = randomBoxes(count, 0.1f);
    CountingPacker packer(16);
    const Divided divided = divideBoxes(boxes, &packer);
    EXPECT_EQ(divided.parts.front().blockCount, divided.blocks.size());
    EXPECT_LE(divided.blocks.size(), 2 * ((count + 15) / 16));
    std::multiset<std::uint32_t> places;
    for (const Part& part : divided.parts) {
      for (std::uint32_t i = 0; i < part.blockCount; ++i) {
        const TriangleBlock& block = divided.blocks.at(part.first + i);
        for (std::size_t lane = 0; (block.usedLanes >> lane & 1u) != 0; ++lane) {
          expectContains(part.bounds, boxes.at(block.objects[lane]));
          if (!part.isSplit())
            places.insert(block.objects[lane]);
        }
      }
    }
    EXPECT_EQ(places.size(), count);
    EXPECT_EQ(std::set<std::uint32_t>(places.begin(), places.end()).size(), count);
  }
}

TEST(LeafDivider, LeavesObjectsOnTheirOwnWithoutAPacker) {
  const std::vector<Box3> boxes = randomBoxes(50, 0.1f);
  const Divided divided = divideBoxes(boxes, nullptr);
  EXPECT_TRUE(divided.blocks.empty());
  std::set<std::uint32_t> objects;
  for (const Part& part : divided.parts) {
    EXPECT_EQ(part.blockCount, 0u);
    if (part.isSplit())
      continue;
    objects.insert(part.first);
    EXPECT_EQ(part.bounds, boxes.at(part.first - kFirstObject));
  }
  EXPECT_EQ(objects.size(), boxes.size());
  EXPECT_EQ(divided.parts.size(), 2 * boxes.size() - 1);
}

TEST(LeafDivider, MakesAnEmptyPartOfAnEmptyLeaf) {
  CountingPacker packer(16);
  for (LeafPacker* which : {static_cast<LeafPacker*>(&packer), static_cast<LeafPacker*>(nullptr)}) {
    const Divided divided = divideBoxes({}, which);
    ASSERT_EQ(divided.parts.size(), 1u);
    EXPECT_TRUE(divided.parts.front().bounds.isEmpty());
    EXPECT_FALSE(divided.parts.front().isSplit());
  }
}

/// Two clusters far apart: the cut goes between them, wherever the middle is.
TEST(LeafDivider, CutsBetweenClusters) {
  std::vector<Box3> boxes;
  for (int i = 0; i < 40; ++i) {
    const float y = (i % 5 == 0 ? 10.0f : 0.0f) + 0.01f * static_cast<float>(i);
    boxes.push_back({{0, y, 0}, {1, y + 0.005f, 1}});
  }
  CountingPacker packer(8);
  const Divided divided = divideBoxes(boxes, &packer);
  const Part& root = divided.parts.front();
  ASSERT_TRUE(root.isSplit());
  EXPECT_EQ(root.axis, Axis::Y);
  EXPECT_LT(divided.parts[1].bounds.upper.y, 5.0f);
  EXPECT_GT(divided.parts[root.right].bounds.lower.y, 5.0f);
}

/// Two triangles for each wall of a unit cube.
std::vector<Box3> wallsOfRoom() {
  std::vector<Box3> boxes;
  for (const Axis axis : kAxes) {
    for (const float position : {0.0f, 1.0f}) {
      Box3 wall{{0, 0, 0}, {1, 1, 1}};
      wall.lower[axis] = wall.upper[axis] = position;
      boxes.insert(boxes.end(), 2, wall);
    }
  }
  return boxes;
}

TEST(LeafDivider, GivesEachWallOfARoomABlockIfRaysStartThere) {
  const std::vector<Box3> boxes = wallsOfRoom();
  CountingPacker packer(16);
  const Divided divided = divideBoxes(boxes, &packer, VisitWeight({{0, 0, 0}, {1, 1, 1}}));
  ASSERT_EQ(divided.blocks.size(), 6u);
  EXPECT_EQ(divided.parts.front().blockCount, 6u);
  for (const Part& part : divided.parts) {
    if (!part.isSplit()) {
      EXPECT_EQ(part.bounds.surfaceArea(), 2.0);
    }
  }
}

TEST(LeafDivider, LeavesTheWallsOfARoomInOneBlockIfRaysStartElsewhere) {
  const std::vector<Box3> boxes = wallsOfRoom();
  CountingPacker packer(16);
  const VisitWeight inLargeTree({{-100, -100, -100}, {100, 100, 100}});
  EXPECT_EQ(divideBoxes(boxes, &packer, inLargeTree).blocks.size(), 1u);
  EXPECT_EQ(divideBoxes(boxes, &packer).blocks.size(), 1u);
}

TEST(LeafDivider, NeverDividesTooOften) {
  // Each box as large as all before it together: the best cuts take one at a time.
  std::vector<Box3> growing;
  for (int i = 0; i < 250; ++i) {
    const float size = std::ldexp(1.0f, i - 125);
    growing.push_back({{size, 0, 0}, {2.0f * size, size, size}});
  }
  CountingPacker packer(16);
  const VisitWeight inside(growing.back());
  EXPECT_LE(divideBoxes(growing, &packer, inside).depth(), kMaxLeafDivisions);
  EXPECT_LE(divideBoxes(growing, nullptr).depth(), kMaxLeafDivisions);
  EXPECT_GT(divideBoxes(growing, nullptr).depth(), 12u);
  const std::vector<Box3> equal(100'000, Box3{{0, 0, 0}, {1, 1, 1}});
  EXPECT_LE(divideBoxes(equal, nullptr).depth(), 18u);
}

TEST(LeafDivider, GivesTheSamePartsEachTime) {
  const std::vector<Box3> boxes = randomBoxes(3000, 0.5f);
  CountingPacker packer(16);
  const Divided first = divideBoxes(boxes, &packer);
  LeafDivider used;
  for (int round = 0; round < 2; ++round) {
    Divided again;
    used.divide(numbersOf(boxes), boxes, &packer, again.parts, again.blocks);
    ASSERT_EQ(again.parts.size(), first.parts.size());
    for (std::size_t i = 0; i < first.parts.size(); ++i) {
      EXPECT_EQ(again.parts[i].bounds, first.parts[i].bounds);
      EXPECT_EQ(again.parts[i].right, first.parts[i].right);
    }
    for (std::size_t i = 0; i < first.blocks.size(); ++i)
      EXPECT_EQ(again.blocks[i].objects, first.blocks[i].objects);
  }
}

}  // namespace
}  // namespace planetree::detail
