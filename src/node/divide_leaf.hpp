#pragma once

#include <planetree/geometry/axis.hpp>
#include <planetree/geometry/box3.hpp>

#include "node/center_bins.hpp"
#include "node/leaf_packer.hpp"
#include "node/part.hpp"
#include "node/visit_weight.hpp"
#include "node/wide_node.hpp"
#include "support/plain_array.hpp"
#include "support/sort_words.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace planetree::detail {

/// How carefully leaves are divided.
enum class LeafCuts : std::uint8_t {
  AllPositions,  ///< all positions between two objects are tried
  Bins,          ///< the edges between a few bins are tried
};

/// Divides leaves of the binary form by their objects, until each part is a block or an object, no
/// more than `kMaxLeafDivisions` times one after the other.
class LeafDivider {
 public:
  explicit LeafDivider(LeafCuts cuts = LeafCuts::AllPositions,
                       const VisitWeight& weight = {}) noexcept
      : cuts_(cuts), weight_(weight) {}

  /// Adds the parts of a leaf to `parts` and its blocks to `blocks`. `boxes` has what each of
  /// the objects has inside the cell; without a packer each is on its own. Objects stay in one
  /// leaf, so the boxes of parts may overlap.
  ///
  /// By the surface area heuristic over the centers of the boxes along all axes, where each side
  /// costs as many tests as it has blocks; but what counts is how often rays meet a part, those
  /// that start inside too (`VisitWeight`): MacDonald and Booth, "Heuristics for ray tracing using
  /// space subdivision", 1990; Wald, "On fast construction of SAH-based bounding volume
  /// hierarchies", 2007. Very large leaves are divided by bins first, in any case. O(n log^2 n).
  void divide(std::span<const std::uint32_t> objects, std::span<const Box3> boxes,
              LeafPacker* packer, std::vector<Part>& parts, std::vector<TriangleBlock>& blocks);

 private:
  using Cut = CenterBins::Cut;

  void divideRange(std::size_t begin, std::size_t end, std::size_t depth, std::vector<Part>& parts,
                   std::vector<TriangleBlock>& blocks);
  /// Adds triangles that fit into one block: as one, or divided further if that costs less with so
  /// much for the slot of each part. Returns what they cost.
  double addBlocks(std::size_t begin, std::size_t end, double slotCost, std::vector<Part>& parts,
                   std::vector<TriangleBlock>& blocks);
  /// Whether objects are a block, or a single one.
  [[nodiscard]] bool fitsIntoOne(std::span<const std::uint32_t> places);
  [[nodiscard]] Cut cut(std::span<std::uint32_t> places, std::size_t depth);
  [[nodiscard]] Cut halve(std::span<std::uint32_t> places);
  [[nodiscard]] Cut findBestCut(std::span<std::uint32_t> places);
  /// `weights[i]` becomes how often rays meet the first i + 1 of these boxes together.
  void sumUpWeights(std::span<const std::uint32_t> places,
                    std::span<double> weights) const noexcept;
  void sortAlong(Axis axis, std::span<std::uint32_t> places);
  void countBlocks(std::span<const std::uint32_t> places, std::vector<std::uint32_t>& counts);
  [[nodiscard]] Box3 boundsOf(std::span<const std::uint32_t> places) const noexcept;
  [[nodiscard]] Box3 centersOf(std::span<const std::uint32_t> places) const noexcept;

  LeafCuts cuts_;
  VisitWeight weight_;
  std::span<const Box3> boxes_;
  LeafPacker* packer_ = nullptr;
  std::span<const std::uint32_t> objects_;
  std::vector<std::uint32_t> places_;  ///< indices of the boxes, those of each part together

  // Room that is used again.
  CenterBins bins_;
  WordSorter sorter_;
  PlainArray<std::uint64_t> words_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> bestOrder_;
  std::vector<std::uint32_t> backwards_;
  std::vector<std::uint32_t> leftCounts_;
  std::vector<std::uint32_t> rightCounts_;
  std::vector<double> leftWeights_;
  std::vector<double> rightWeights_;
};

}  // namespace planetree::detail
