#include <planetree/planetree.hpp>

#include "node/node_array.hpp"
#include "node/widen_tree.hpp"
#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// How much a tree can hold. Where there is no room for as much in a test, an input claims to be as
/// large, or the check is asked by itself.
namespace planetree::test {
namespace {

/// What `attempt` was refused for, if it was.
template <class Attempt>
std::optional<ErrorCode> refusalOf(const Attempt& attempt) {
  try {
    attempt();
    return std::nullopt;
  } catch (const Error& error) {
    EXPECT_FALSE(error.advice().empty()) << error.what();
    return error.code();
  }
}

/// A mesh that is one triangle so many times: with a stride of zero all faces are the same one.
TriangleMeshView<float> repeatedTriangle(std::size_t faceCount) {
  static const std::vector<Vec3f> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  static const FaceIndices face = {0, 1, 2};
  return {positions.data(), sizeof(Vec3f), positions.size(), face.data(), 0, faceCount};
}

/// Builds within a gigabyte: who is let through by all other checks ends there.
std::optional<ErrorCode> refusalOfMeshes(const std::vector<std::size_t>& faceCounts) {
  Scene<float> scene;
  for (const std::size_t faceCount : faceCounts)
    scene.add(repeatedTriangle(faceCount));
  BuildControl control;
  control.memoryLimit = 1'000'000'000;
  return refusalOf([&] { static_cast<void>(buildTree(scene, {}, control)); });
}

TEST(Capacity, EndsWithTheObjectsThatThirtyTwoBitsCanNumber) {
  constexpr std::size_t kMost = 0xFFFF'FFFE;
  EXPECT_EQ(refusalOfMeshes({kMost}), ErrorCode::MemoryLimitExceeded);
  EXPECT_EQ(refusalOfMeshes({kMost + 1}), ErrorCode::CapacityExceeded);
  EXPECT_EQ(refusalOfMeshes({kMost + 2}), ErrorCode::CapacityExceeded);
  EXPECT_EQ(refusalOfMeshes({std::numeric_limits<std::size_t>::max()}),
            ErrorCode::CapacityExceeded);
}

TEST(Capacity, CountsTheObjectsOfAllGeometries) {
  constexpr std::size_t kHalf = 0x7FFF'FFFF;
  EXPECT_EQ(refusalOfMeshes({kHalf, kHalf}), ErrorCode::MemoryLimitExceeded);
  EXPECT_EQ(refusalOfMeshes({kHalf, kHalf, 0}), ErrorCode::MemoryLimitExceeded);
  EXPECT_EQ(refusalOfMeshes({kHalf, kHalf, 1}), ErrorCode::CapacityExceeded);
  // Together they would be none at all in sixty-four bits.
  EXPECT_EQ(refusalOfMeshes({1, std::numeric_limits<std::size_t>::max()}),
            ErrorCode::CapacityExceeded);
}

TEST(Capacity, EndsWithTheReferencesThatALeafCanPointTo) {
  using planetree::detail::requireReferenceRoom;
  static_assert(kMaxReferenceCount == (1u << 30) - 1);
  EXPECT_EQ(refusalOf([] { requireReferenceRoom(kMaxReferenceCount); }), std::nullopt);
  EXPECT_EQ(refusalOf([] { requireReferenceRoom(kMaxReferenceCount + 1); }),
            ErrorCode::CapacityExceeded);
  // Asked before memory is taken.
  planetree::detail::NodeArray nodes;
  EXPECT_EQ(refusalOf([&] { static_cast<void>(nodes.addLeaf(kMaxReferenceCount + 1)); }),
            ErrorCode::CapacityExceeded);
}

TEST(Capacity, EndsWithTheNodesThatASplitCanPointTo) {
  using planetree::detail::requireNodeRoom;
  static_assert(kMaxNodeCount == (1u << 30) - 1);
  EXPECT_EQ(refusalOf([] { requireNodeRoom(kMaxNodeCount); }), std::nullopt);
  EXPECT_EQ(refusalOf([] { requireNodeRoom(kMaxNodeCount + 1); }), ErrorCode::CapacityExceeded);
}

TEST(Capacity, EndsWithTheNodesAndBlocksThatAWideNodeCanPointTo) {
  using planetree::detail::requireBlockRoom;
  using planetree::detail::requireWideNodeRoom;
  constexpr std::size_t kMostNodes = std::size_t{1} << 31u;
  constexpr std::size_t kMostBlocks = std::size_t{1} << 27u;
  EXPECT_EQ(refusalOf([] { requireWideNodeRoom(kMostNodes); }), std::nullopt);
  EXPECT_EQ(refusalOf([] { requireWideNodeRoom(kMostNodes + 1); }), ErrorCode::CapacityExceeded);
  EXPECT_EQ(refusalOf([] { requireBlockRoom(kMostBlocks); }), std::nullopt);
  EXPECT_EQ(refusalOf([] { requireBlockRoom(kMostBlocks + 1); }), ErrorCode::CapacityExceeded);
}

/// For leaves of shapes.
class NoPacker final : public planetree::detail::LeafPacker {
 public:
  bool open(std::span<const std::uint32_t> /*objects*/) override { return false; }
  void countBlocks(std::span<const std::uint32_t> /*places*/,
                   std::span<std::uint32_t> /*counts*/) override {}
  planetree::detail::TriangleBlock pack(std::span<const std::uint32_t> /*places*/) override {
    return {};
  }
};

/// Widens a tree of one leaf with one shape of this number.
void widenLeafOf(std::uint32_t object) {
  const Box3 box{{0, 0, 0}, {1, 1, 1}};
  planetree::detail::NodeArray leaf;
  leaf.addLeaf(1)[0] = object;
  leaf.boxesOfLastLeaf()[0] = box;
  planetree::detail::MemoryMeter memory(0);
  const planetree::detail::WideTree wide = planetree::detail::widenTree(
      planetree::detail::TreePieces(std::move(leaf)), box,
      planetree::detail::LeafCuts::AllPositions, [] { return std::make_unique<NoPacker>(); },
      memory, [](double /*part*/) {});
  EXPECT_EQ(wide.root.objectNumber(), object);
  EXPECT_FALSE(wide.root.isEnd());
}

TEST(Capacity, EndsWithTheNumbersOfShapesThatAWideNodeCanHold) {
  constexpr std::uint32_t kMost = (1u << 30) - 2;
  EXPECT_EQ(refusalOf([] { widenLeafOf(kMost); }), std::nullopt);
  EXPECT_EQ(refusalOf([] { widenLeafOf(kMost + 1); }), ErrorCode::CapacityExceeded);
  EXPECT_EQ(refusalOf([] { widenLeafOf(0xFFFF'FFFEu); }), ErrorCode::CapacityExceeded);
}

}  // namespace
}  // namespace planetree::test
