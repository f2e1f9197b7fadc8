#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/reference.hpp>
#include <planetree/split/split_plane.hpp>

#include "node/node_array.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace planetree::detail {

/// Shrinks the boxes of references to what their objects have inside a cell.
using ClipReferences = std::function<void(const Box3& cell, std::span<Reference> references)>;

/// Builds the binary tree from references alone; never sees an object. Must run inside a oneTBB
/// arena. The result does not depend on how many threads there are.
class TreeBuilder {
 public:
  /// `clip` must outlive the builder and may be called from several threads at once.
  TreeBuilder(const BuildOptions& options, std::uint32_t depthLimit, const ClipReferences& clip)
      : options_(options), depthLimit_(depthLimit), clip_(clip) {}

  /// Adds the tree of these references within the cell. `level` counts from 1 at the root; `budget`
  /// is how many references the subtree may have in all.
  void buildTree(std::vector<Reference> references, const Box3& cell, std::uint32_t level,
                 double budget, NodeArray& tree) const;

 private:
  struct Division {
    std::vector<Reference> left;
    std::vector<Reference> right;
  };

  [[nodiscard]] bool mustBeLeaf(std::size_t count, std::uint32_t level) const noexcept;
  [[nodiscard]] bool isWorthIt(const SplitPlane& plane, std::size_t count) const noexcept;
  [[nodiscard]] static bool fitsInto(double budget, const SplitPlane& plane) noexcept;
  [[nodiscard]] Division divide(std::vector<Reference> references, const SplitPlane& plane,
                                const Box3& cell) const;
  void clipStraddling(std::vector<Reference>& references,
                      const std::vector<std::uint32_t>& straddling, const Box3& cell) const;

  const BuildOptions& options_;
  std::uint32_t depthLimit_;
  const ClipReferences& clip_;
};

}  // namespace planetree::detail
