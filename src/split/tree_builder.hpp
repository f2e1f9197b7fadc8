#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/reference.hpp>
#include <planetree/split/split_plane.hpp>

#include "node/tree_pieces.hpp"
#include "split/divide_references.hpp"
#include "support/plain_array.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace planetree::detail {

class PlaneSearch;

/// Builds the binary tree from references alone; never sees an object. Must run inside a oneTBB
/// arena. The result does not depend on how many threads there are.
///
/// The cells at the top, which hold many references, are divided by all threads together; below,
/// one thread builds a subtree as a whole, in memory that it uses again and again.
class TreeBuilder {
 public:
  /// `clip` must outlive the builder and may be called from several threads at once.
  TreeBuilder(const BuildOptions& options, std::uint32_t depthLimit, const ClipReferences& clip)
      : options_(options), depthLimit_(depthLimit), clip_(clip) {}

  /// The tree of these references within the cell. `budget` is how many references it may have in
  /// all.
  [[nodiscard]] TreePieces build(PlainArray<Reference> references, const Box3& cell,
                                 double budget) const;

 private:
  class SubtreeBuilder;
  class Workshop;

  /// A cell that is to be built. `level` counts from 1 at the root.
  struct Task {
    Box3 cell;
    std::uint32_t level = 1;
    double budget = 0.0;
  };

  struct Children {
    Task left;
    Task right;
  };

  [[nodiscard]] TreePieces buildPieces(PlainArray<Reference> references, const Task& task,
                                       Workshop& workshop) const;
  /// The plane that divides a cell; nothing if it becomes a leaf.
  [[nodiscard]] std::optional<SplitPlane> findPlane(std::span<const Reference> references,
                                                    const Task& task, PlaneSearch& search) const;
  [[nodiscard]] static Children childrenOf(const Task& task, const SplitPlane& plane,
                                           std::size_t leftCount, std::size_t rightCount) noexcept;

  const BuildOptions& options_;
  std::uint32_t depthLimit_;
  const ClipReferences& clip_;
};

}  // namespace planetree::detail
