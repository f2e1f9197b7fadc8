#include "node/node_array.hpp"

#include <planetree/error.hpp>

#include <string>

namespace planetree::detail {
namespace {

void requireRoom(std::size_t count, std::size_t limit, const std::string& what) {
  if (count <= limit)
    return;
  throw Error(ErrorCode::CapacityExceeded,
              "the tree needs more than " + std::to_string(limit) + " " + what,
              "Raise leafSize, lower depthLimit, or divide the scene into several trees.");
}

}  // namespace

std::span<std::uint32_t> NodeArray::addLeaf(std::size_t count) {
  requireRoom(nodes_.size() + 1, kMaxNodeCount, "nodes");
  requireRoom(references_.size() + count, kMaxReferenceCount, "references");
  const std::size_t first = references_.size();
  nodes_.emplace_back(
      LeafNode(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)));
  references_.resize(first + count);
  boxes_.resize(first + count);
  return std::span(references_).subspan(first);
}

std::span<Box3> NodeArray::boxesOfLastLeaf() noexcept {
  return std::span(boxes_).subspan(nodes_.back().leaf().firstReference());
}

std::size_t NodeArray::addSplit(Axis axis, float position) {
  requireRoom(nodes_.size() + 1, kMaxNodeCount, "nodes");
  nodes_.emplace_back(SplitNode(axis, position, 0));
  return nodes_.size() - 1;
}

void NodeArray::beginRightChild(std::size_t split) {
  const SplitNode& unfinished = nodes_[split].split();
  nodes_[split] = SplitNode(unfinished.axis(), unfinished.position(),
                            static_cast<std::uint32_t>(nodes_.size() - split));
}

void NodeArray::append(const NodeArray& part) {
  requireRoom(nodes_.size() + part.nodes_.size(), kMaxNodeCount, "nodes");
  requireRoom(references_.size() + part.references_.size(), kMaxReferenceCount, "references");
  const auto firstReference = static_cast<std::uint32_t>(references_.size());
  for (const Node& node : part.nodes_) {
    if (node.isLeaf()) {
      const LeafNode& leaf = node.leaf();
      nodes_.emplace_back(LeafNode(firstReference + leaf.firstReference(), leaf.count()));
    } else {
      nodes_.push_back(node);
    }
  }
  references_.insert(references_.end(), part.references_.begin(), part.references_.end());
  boxes_.insert(boxes_.end(), part.boxes_.begin(), part.boxes_.end());
}

}  // namespace planetree::detail
