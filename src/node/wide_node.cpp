#include "node/wide_node.hpp"

#include <cstddef>
#include <memory>

namespace planetree::detail {
namespace {

/// Sixteen megabytes of nodes, about what a thread has of a large cache. In smaller trees fetching
/// ahead costs as much as it saves.
constexpr std::size_t kLargeNodeCount = 32'768;

static_assert(LargePages::kAlignment % alignof(WideNode) == 0);
static_assert(sizeof(WideNode) % alignof(TriangleBlock) == 0);

}  // namespace

WideTree::WideTree(const WideFrame& wideFrame, WideChild wideRoot,
                   std::span<const WideNode> wideNodes, std::span<const TriangleBlock> wideBlocks)
    : frame(wideFrame),
      root(wideRoot),
      isLarge(wideNodes.size() > kLargeNodeCount),
      memory_(wideNodes.size_bytes() + wideBlocks.size_bytes()) {
  auto* const firstNode = reinterpret_cast<WideNode*>(memory_.data());
  auto* const firstBlock =
      reinterpret_cast<TriangleBlock*>(memory_.data() + wideNodes.size_bytes());
  std::uninitialized_copy(wideNodes.begin(), wideNodes.end(), firstNode);
  std::uninitialized_copy(wideBlocks.begin(), wideBlocks.end(), firstBlock);
  nodes = {firstNode, wideNodes.size()};
  blocks = {firstBlock, wideBlocks.size()};
}

}  // namespace planetree::detail
