#pragma once

#include <planetree/geometry/vec3.hpp>
#include <planetree/node/node_layout.hpp>

#include "node/triangle_block.hpp"
#include "support/large_pages.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// The wide form of a tree: several levels of the binary one in each node, derived from it for
/// speed. Its cells are those of the binary form, so they do not overlap and are met front to back;
/// each carries the box of what it contains, which is tighter than the cell. Below the leaves of
/// the binary form the objects themselves are divided: the boxes of these parts may overlap, and
/// are met roughly front to back.
namespace planetree::detail {

/// No leaf of the binary form is divided more often than this, one part after the other.
inline constexpr std::size_t kMaxLeafDivisions = 48;

/// No path through a wide tree has more nodes: each of them holds at least one split, of a cell or
/// of the objects of a leaf.
inline constexpr std::size_t kMaxWideDepth = kMaxTreeDepth + kMaxLeafDivisions;

/// What a slot of a wide node leads to, in one word.
class WideChild {
 public:
  static constexpr std::uint32_t kMaxNodeIndex = 0x7FFF'FFFFu;
  static constexpr std::uint32_t kMaxBlockIndex = 0x07FF'FFFFu;
  static constexpr std::uint32_t kMaxBlockCount = 8;
  static constexpr std::uint32_t kMaxObject = 0x3FFF'FFFEu;

  constexpr WideChild() = default;

  [[nodiscard]] static constexpr WideChild node(std::uint32_t index) noexcept {
    return WideChild(index);
  }
  /// `count` blocks of triangles from `first` on, at least one and at most `kMaxBlockCount`.
  [[nodiscard]] static constexpr WideChild blocks(std::uint32_t first,
                                                  std::uint32_t count) noexcept {
    return WideChild(kLeafBit | first << 3 | (count - 1));
  }
  /// A single object, by its number in the tree.
  [[nodiscard]] static constexpr WideChild object(std::uint32_t number) noexcept {
    return WideChild(kLeafBit | kObjectBit | number);
  }

  /// Nothing: the end of a search.
  [[nodiscard]] static constexpr WideChild end() noexcept { return object(kMaxObject + 1); }

  [[nodiscard]] static constexpr WideChild fromWord(std::uint32_t word) noexcept {
    return WideChild(word);
  }

  [[nodiscard]] constexpr std::uint32_t word() const noexcept { return word_; }

  [[nodiscard]] constexpr bool isNode() const noexcept { return (word_ & kLeafBit) == 0; }
  [[nodiscard]] constexpr bool isObject() const noexcept { return (word_ & kObjectBit) != 0; }
  [[nodiscard]] constexpr bool isEnd() const noexcept { return word_ == end().word_; }
  [[nodiscard]] constexpr std::uint32_t nodeIndex() const noexcept { return word_; }
  [[nodiscard]] constexpr std::uint32_t firstBlock() const noexcept {
    return (word_ & ~(kLeafBit | kObjectBit)) >> 3;
  }
  [[nodiscard]] constexpr std::uint32_t blockCount() const noexcept { return (word_ & 7u) + 1; }
  [[nodiscard]] constexpr std::uint32_t objectNumber() const noexcept {
    return word_ & ~(kLeafBit | kObjectBit);
  }

 private:
  static constexpr std::uint32_t kLeafBit = 0x8000'0000u;
  static constexpr std::uint32_t kObjectBit = 0x4000'0000u;

  explicit constexpr WideChild(std::uint32_t word) noexcept : word_(word) {}

  std::uint32_t word_ = 0;
};
static_assert(sizeof(WideChild) == 4);
static_assert(WideChild::blocks(WideChild::kMaxBlockIndex, 8).firstBlock() ==
              WideChild::kMaxBlockIndex);
static_assert(!WideChild::blocks(WideChild::kMaxBlockIndex, 8).isObject());

/// In which order a ray meets the slots of a node: sixteen numbers of four bits, from the farthest
/// slot to the nearest. Two of them stand side by side in the two halves of the word, so that one
/// shift per lane of 32 bits unpacks them all.
class SlotOrder {
 public:
  static constexpr unsigned kBitsPerSlot = 4;

  constexpr SlotOrder() = default;
  explicit constexpr SlotOrder(const std::array<std::uint8_t, 16>& slots) noexcept {
    for (std::size_t i = 0; i < slots.size(); ++i)
      word_ |= std::uint64_t{slots[i]} << shift(i);
  }
  [[nodiscard]] constexpr std::size_t operator[](std::size_t i) const noexcept {
    return word_ >> shift(i) & 15u;
  }
  [[nodiscard]] constexpr std::uint64_t word() const noexcept { return word_; }

 private:
  static constexpr unsigned shift(std::size_t i) noexcept {
    return static_cast<unsigned>((i & 1u) * 32u + (i >> 1u) * kBitsPerSlot);
  }

  std::uint64_t word_ = 0;
};

/// Sixteen cells with the boxes of what they contain. A slot without a child has an inverted box,
/// which no ray meets.
struct alignas(64) WideNode {
  static constexpr std::size_t kSlotCount = 16;

  /// Positions along axis a, relative to the center of the tree and rounded outward: lower ends in
  /// `planes[2 a]`, upper ends in `planes[2 a + 1]`.
  float planes[6][kSlotCount];
  std::array<WideChild, kSlotCount> children;
  /// By the signs of the ray's direction: bit a is set if it is negative along axis a.
  std::array<SlotOrder, 8> orders;
};
static_assert(sizeof(WideNode) == 512);

/// Where a wide tree lies. One number more than there are axes, for loads of four.
struct alignas(16) WideFrame {
  float center[4] = {};    ///< what the positions are relative to
  float halfSize[4] = {};  ///< how far the bounds reach from there, rounded up
};

/// A tree in its wide form.
struct WideTree {
  /// An empty tree.
  WideTree() = default;
  /// With room for so many nodes and blocks in memory of their own, to be written before anyone
  /// looks; the nodes, which rays visit most, first.
  WideTree(const WideFrame& wideFrame, WideChild wideRoot, std::size_t nodeCount,
           std::size_t blockCount);

  [[nodiscard]] std::span<WideNode> nodesToWrite() noexcept;
  [[nodiscard]] std::span<TriangleBlock> blocksToWrite() noexcept;

  WideFrame frame = {};
  std::uint32_t commonMask = 0;  ///< what the masks of all geometries have in common
  WideChild root = WideChild::end();
  bool holdsObjects = false;  ///< there are single objects, not only blocks
  bool isLarge = false;       ///< much of it is often far away, and worth fetching ahead
  std::span<const WideNode> nodes = {};
  std::span<const TriangleBlock> blocks = {};

 private:
  LargePages memory_;
};

}  // namespace planetree::detail
