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
  requireNodeRoom(nodes_.size() + 1);
  requireReferenceRoom(references_.size() + count);
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
  requireNodeRoom(nodes_.size() + 1);
  nodes_.emplace_back(SplitNode(axis, position, 0));
  return nodes_.size() - 1;
}

void NodeArray::beginRightChild(std::size_t split) {
  const SplitNode& unfinished = nodes_[split].split();
  nodes_[split] = SplitNode(unfinished.axis(), unfinished.position(),
                            static_cast<std::uint32_t>(nodes_.size() - split));
}

void NodeArray::removeFrom(std::size_t split, std::size_t firstReference) {
  nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(split), nodes_.end());
  references_.resize(firstReference);
  boxes_.resize(firstReference);
}

void NodeArray::chargeMemory(MemoryMeter& meter) {
  charge_.resize(meter, nodes_.capacity() * sizeof(Node) +
                            references_.capacity() * sizeof(std::uint32_t) +
                            boxes_.capacity() * sizeof(Box3));
}

void requireNodeRoom(std::size_t nodeCount) {
  requireRoom(nodeCount, kMaxNodeCount, "nodes");
}

void requireReferenceRoom(std::size_t referenceCount) {
  requireRoom(referenceCount, kMaxReferenceCount, "references");
}

}  // namespace planetree::detail
