#pragma once

#include "node/part.hpp"
#include "node/plan_slots.hpp"
#include "node/wide_node.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace planetree::detail {

/// A part inside one wide node: what is in a slot, or a split.
struct Branch {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  std::size_t part;
  std::uint8_t kind = 0;     ///< of a split in a slot: what it is there, see `SlotPlan`
  std::size_t slot = kNone;  ///< if it is in one
  std::size_t left = kNone;  ///< index of a branch
  std::size_t right = kNone;
};

/// What a split holds as a wide node: its branches, itself first, and those in slots in the order
/// of these.
void branchOut(std::span<const Part> parts, std::span<const SlotPlan> plans, std::size_t part,
               std::vector<Branch>& branches);

/// Whether a part in a slot is a node of its own.
[[nodiscard]] inline bool isNode(const Part& part, std::uint8_t kind) noexcept {
  return part.isSplit() && kind != SlotPlan::kRow;
}

/// What a slot leads to that holds this part; `nodeOf` has the indices of the parts that are nodes.
[[nodiscard]] WideChild childOf(std::span<const Part> parts, std::size_t part, std::uint8_t kind,
                                std::span<const std::uint32_t> nodeOf) noexcept;

/// The node with these branches. Throws nothing but `std::bad_alloc`.
[[nodiscard]] WideNode makeWideNode(std::span<const Part> parts, std::span<const Branch> branches,
                                    std::span<const std::uint32_t> nodeOf, const WideFrame& frame);

}  // namespace planetree::detail
