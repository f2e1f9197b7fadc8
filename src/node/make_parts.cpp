#include "node/make_parts.hpp"

#include <planetree/error.hpp>

#include "node/wide_node.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace planetree::detail {
namespace {

/// The parts of one subtree, counted from its own first part, block and reference.
struct SubtreeParts {
  std::vector<Part> parts;
  std::vector<TriangleBlock> blocks;
  MemoryCharge partsCharge;
  MemoryCharge blocksCharge;
};

/// Of the objects of a leaf, in rising order.
void requireNumbersFit(std::span<const std::uint32_t> objects) {
  if (objects.empty() || objects.back() <= WideChild::kMaxObject)
    return;
  throw Error(ErrorCode::CapacityExceeded, "the scene has too many objects",
              "Divide the scene into several trees.");
}

SubtreeParts makeSubtreeParts(const NodeArray& tree, const VisitWeight& weight, LeafCuts cuts,
                              LeafPacker& packer, MemoryMeter& memory) {
  SubtreeParts made;
  LeafDivider divider(cuts, weight);
  std::vector<std::uint32_t> partOf(tree.nodes().size());
  for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
    partOf[i] = static_cast<std::uint32_t>(made.parts.size());
    const Node& node = tree.nodes()[i];
    if (!node.isLeaf()) {
      made.parts.push_back({.axis = node.split().axis()});
      continue;
    }
    const std::uint32_t first = node.leaf().firstReference();
    const auto objects = tree.references().subspan(first, node.leaf().count());
    const bool isPacked = packer.open(objects);
    if (!isPacked)
      requireNumbersFit(objects);
    divider.divide(objects, tree.boxes().subspan(first, node.leaf().count()),
                   isPacked ? &packer : nullptr, made.parts, made.blocks);
  }
  for (std::size_t i = tree.nodes().size(); i-- > 0;) {
    if (tree.nodes()[i].isLeaf())
      continue;
    made.parts[partOf[i]].right = partOf[i + tree.nodes()[i].split().rightOffset()];
    boundSplit(made.parts, partOf[i]);
  }
  made.partsCharge = MemoryCharge(memory, made.parts.capacity() * sizeof(Part));
  made.blocksCharge = MemoryCharge(memory, made.blocks.capacity() * sizeof(TriangleBlock));
  return made;
}

/// Moves parts to where they are in the whole.
void place(std::span<const Part> from, std::size_t firstPart, std::size_t firstBlock,
           PlainArray<Part>& to) {
  std::transform(from.begin(), from.end(), to.data() + firstPart, [&](Part part) {
    if (part.isSplit())
      part.right += static_cast<std::uint32_t>(firstPart);
    if (part.blockCount > 0)
      part.first += static_cast<std::uint32_t>(firstBlock);
    return part;
  });
}

}  // namespace

void TreeParts::forAllUpwards(const std::function<void(std::size_t part)>& each) const {
  tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
    for (std::size_t part = pieces[i].partCount; part-- > 0;)
      each(pieces[i].firstPart + part);
  });
  for (std::size_t i = tops.size(); i-- > 0;)
    each(tops[i]);
}

TreeParts makeParts(TreePieces tree, const VisitWeight& weight, LeafCuts cuts,
                    const MakeLeafPacker& makePacker, MemoryMeter& memory,
                    const std::function<void(double part)>& advance) {
  std::vector<SubtreeParts> made(tree.subtrees().size());
  const auto total = static_cast<double>(std::max<std::size_t>(tree.referenceCount(), 1));
  tbb::parallel_for(std::size_t{0}, made.size(), [&](std::size_t i) {
    const auto count = static_cast<double>(tree.subtrees()[i].references().size());
    made[i] = makeSubtreeParts(tree.takeSubtree(i), weight, cuts, *makePacker(), memory);
    advance(count / total);
  });

  const std::vector<TreePieces::Place>& top = tree.top();
  TreeParts all;
  std::vector<std::size_t> partOf(top.size());
  std::size_t partCount = 0;
  for (std::size_t i = 0; i < top.size(); ++i) {
    partOf[i] = partCount;
    if (top[i].isSplit()) {
      all.tops.push_back(partCount++);
      continue;
    }
    SubtreeParts& subtree = made[top[i].subtree];
    all.pieces.push_back({.firstPart = partCount,
                          .partCount = subtree.parts.size(),
                          .firstBlock = all.blockCount,
                          .blocks = std::move(subtree.blocks),
                          .blocksCharge = std::move(subtree.blocksCharge)});
    partCount += subtree.parts.size();
    all.blockCount += all.pieces.back().blocks.size();
  }

  all.partsCharge = MemoryCharge(memory, partCount * sizeof(Part));
  all.parts.resize(partCount);
  tbb::parallel_for(std::size_t{0}, made.size(), [&](std::size_t i) {
    const TreeParts::Piece& piece = all.pieces[i];
    place(made[i].parts, piece.firstPart, piece.firstBlock, all.parts);
    made[i] = {};
  });
  for (std::size_t i = top.size(); i-- > 0;) {
    if (!top[i].isSplit())
      continue;
    all.parts.data()[partOf[i]] = {.axis = top[i].axis,
                                   .right = static_cast<std::uint32_t>(partOf[top[i].right])};
    boundSplit(all.parts.values(), partOf[i]);
  }
  return all;
}

}  // namespace planetree::detail
