#include "node/wide_node.hpp"

#include <cstddef>

namespace planetree::detail {
namespace {

/// Sixteen megabytes of nodes, about what a thread has of a large cache. In smaller trees fetching
/// ahead costs as much as it saves.
constexpr std::size_t kLargeNodeCount = 32'768;

static_assert(LargePages::kAlignment % alignof(WideNode) == 0);
static_assert(sizeof(WideNode) % alignof(TriangleBlock) == 0);

}  // namespace

WideTree::WideTree(const WideFrame& wideFrame, WideChild wideRoot, std::size_t nodeCount,
                   std::size_t blockCount)
    : frame(wideFrame),
      root(wideRoot),
      isLarge(nodeCount > kLargeNodeCount),
      memory_(nodeCount * sizeof(WideNode) + blockCount * sizeof(TriangleBlock)) {
  auto* const firstNode = reinterpret_cast<WideNode*>(memory_.data());
  nodes = {firstNode, nodeCount};
  blocks = {reinterpret_cast<TriangleBlock*>(firstNode + nodeCount), blockCount};
}

std::span<WideNode> WideTree::nodesToWrite() noexcept {
  return {reinterpret_cast<WideNode*>(memory_.data()), nodes.size()};
}

std::span<TriangleBlock> WideTree::blocksToWrite() noexcept {
  return {reinterpret_cast<TriangleBlock*>(memory_.data() + nodes.size_bytes()), blocks.size()};
}

}  // namespace planetree::detail
