#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/reference.hpp>
#include <planetree/split/split_plane.hpp>

#include "node/tree_pieces.hpp"
#include "split/build_monitor.hpp"
#include "split/divide_references.hpp"

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
  /// All must outlive the builder; `clip` may be called from several threads at once.
  TreeBuilder(const BuildOptions& options, std::uint32_t depthLimit, const ClipReferences& clip,
              BuildMonitor& monitor)
      : options_(options), depthLimit_(depthLimit), clip_(clip), monitor_(monitor) {}

  /// The tree of these references within the cell. `budget` is how many references it may have in
  /// all.
  [[nodiscard]] TreePieces build(CellReferences references, const Box3& cell, double budget) const;

 private:
  class SubtreeBuilder;
  class Workshop;

  /// A cell that is to be built. `level` counts from 1 at the root.
  struct Task {
    Box3 cell;
    std::uint32_t level = 1;
    double budget = 0.0;
    double part = 1.0;  ///< of the whole work, as progress has it
  };

  struct Children {
    Task left;
    Task right;
  };

  [[nodiscard]] TreePieces buildPieces(CellReferences references, const Task& task,
                                       Workshop& workshop) const;
  /// The plane that divides a cell; nothing if it becomes a leaf.
  [[nodiscard]] std::optional<SplitPlane> findPlane(std::span<const Reference> references,
                                                    const Task& task, PlaneSearch& search) const;
  [[nodiscard]] static Children childrenOf(const Task& task, const SplitPlane& plane,
                                           std::size_t leftCount, std::size_t rightCount) noexcept;

  const BuildOptions& options_;
  std::uint32_t depthLimit_;
  const ClipReferences& clip_;
  BuildMonitor& monitor_;
};

}  // namespace planetree::detail
