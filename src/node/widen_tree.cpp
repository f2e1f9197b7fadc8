#include "node/widen_tree.hpp"

#include <planetree/error.hpp>

#include "node/plan_slots.hpp"
#include "node/write_wide_node.hpp"
#include "support/plain_array.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace planetree::detail {
namespace {

constexpr std::size_t kNodeBatchSize = 64;

// Most of the time goes there, as progress has it.
constexpr double kPartOfMakingParts = 0.85;
constexpr double kPartOfWritingNodes = 0.15;

void requireRoom(std::size_t count, std::uint32_t maxIndex, const std::string& what) {
  if (count <= std::size_t{maxIndex} + 1)
    return;
  throw Error(ErrorCode::CapacityExceeded, "the wide form of the tree has too many " + what,
              "Raise leafSize, or divide the scene into several trees.");
}

WideFrame frameOf(const Box3& bounds) noexcept {
  WideFrame frame;
  const Vec3f center = centerOfWideTree(bounds);
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    frame.center[a] = center[axis];
    const auto middle = static_cast<double>(center[axis]);
    frame.halfSize[a] = roundUp(std::max(static_cast<double>(bounds.upper[axis]) - middle,
                                         middle - static_cast<double>(bounds.lower[axis])));
  }
  return frame;
}

/// The parts that become nodes, depth first, and where they stand.
struct NodeNumbers {
  std::vector<std::size_t> parts;
  PlainArray<std::uint32_t> nodeOf;  ///< by part; undefined for those that are no nodes
};

NodeNumbers numberNodes(std::span<const Part> parts, std::span<const SlotPlan> plans) {
  NodeNumbers numbers;
  numbers.nodeOf.resize(parts.size());
  std::vector<std::size_t> rest;
  if (isNode(parts.front(), plans.front().leftSlots[1]))
    rest.push_back(0);
  std::vector<Branch> branches;
  while (!rest.empty()) {
    const std::size_t part = rest.back();
    rest.pop_back();
    numbers.nodeOf.data()[part] = static_cast<std::uint32_t>(numbers.parts.size());
    numbers.parts.push_back(part);
    branchOut(parts, plans, part, branches);
    for (std::size_t i = branches.size(); i-- > 0;) {
      const Branch& branch = branches[i];
      if (branch.slot != Branch::kNone && isNode(parts[branch.part], branch.kind))
        rest.push_back(branch.part);
    }
  }
  return numbers;
}

}  // namespace

Vec3f centerOfWideTree(const Box3& bounds) noexcept {
  Vec3f center;
  for (const Axis axis : kAxes) {
    center[axis] = static_cast<float>(
        0.5 * (static_cast<double>(bounds.lower[axis]) + static_cast<double>(bounds.upper[axis])));
  }
  return center;
}

WideTree widenTree(TreePieces tree, const Box3& bounds, LeafCuts cuts,
                   const MakeLeafPacker& makePacker, MemoryMeter& memory,
                   const std::function<void(double part)>& advance) {
  if (bounds.isEmpty())
    return {};
  const std::size_t referenceCount = tree.referenceCount();
  const SlotPlanner planner(bounds, referenceCount);
  const TreeParts all = makeParts(std::move(tree), planner.weight(), cuts, makePacker, memory,
                                  [&](double part) { advance(kPartOfMakingParts * part); });
  const std::span<const Part> parts = all.parts.values();
  if (parts.front().isEmpty())
    return {};
  requireBlockRoom(all.blockCount);

  const MemoryCharge plansCharge(memory, parts.size() * (sizeof(SlotPlan) + sizeof(std::uint32_t)));
  PlainArray<SlotPlan> plans(parts.size());
  all.forAllUpwards([&](std::size_t part) { planner.plan(parts, part, plans.values()); });
  advance(0.0);
  const NodeNumbers numbers = numberNodes(parts, plans.values());
  requireWideNodeRoom(numbers.parts.size());

  const std::span<const std::uint32_t> nodeOf = numbers.nodeOf.values();
  const WideFrame frame = frameOf(bounds);
  const MemoryCharge wideCharge(
      memory, numbers.parts.size() * sizeof(WideNode) + all.blockCount * sizeof(TriangleBlock));
  WideTree wide(frame, childOf(parts, 0, plans.values().front().leftSlots[1], nodeOf),
                numbers.parts.size(), all.blockCount);
  wide.holdsObjects = std::any_of(parts.begin(), parts.end(), [](const Part& part) {
    return !part.isSplit() && !part.isEmpty() && part.blockCount == 0;
  });
  const std::span<WideNode> nodes = wide.nodesToWrite();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, nodes.size(), kNodeBatchSize),
                    [&](const tbb::blocked_range<std::size_t>& batch) {
                      std::vector<Branch> branches;
                      for (std::size_t i = batch.begin(); i < batch.end(); ++i) {
                        branchOut(parts, plans.values(), numbers.parts[i], branches);
                        nodes[i] = makeWideNode(parts, branches, nodeOf, frame);
                      }
                      advance(kPartOfWritingNodes * static_cast<double>(batch.size()) /
                              static_cast<double>(nodes.size()));
                    });
  const std::span<TriangleBlock> blocks = wide.blocksToWrite();
  tbb::parallel_for(std::size_t{0}, all.pieces.size(), [&](std::size_t i) {
    const TreeParts::Piece& piece = all.pieces[i];
    std::ranges::copy(piece.blocks, blocks.subspan(piece.firstBlock).begin());
  });
  return wide;
}

void requireWideNodeRoom(std::size_t nodeCount) {
  requireRoom(nodeCount, WideChild::kMaxNodeIndex, "nodes");
}

void requireBlockRoom(std::size_t blockCount) {
  requireRoom(blockCount, WideChild::kMaxBlockIndex, "blocks");
}

}  // namespace planetree::detail
