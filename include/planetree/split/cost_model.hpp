#pragma once

#include <cstdint>

namespace planetree {

/// What the surface area heuristic believes a ray pays; only ratios matter.
/// MacDonald and Booth, "Heuristics for ray tracing using space subdivision", The Visual Computer
/// 1990.
struct CostModel {
  double traversalCost = 1.5;     ///< one split node
  double intersectionCost = 1.0;  ///< one object in a leaf
  /// One face of a mesh, in place of `intersectionCost`, where a tree holds nothing else. Sixteen
  /// of them are tested at once, and the wide form divides leaves further without holding any face
  /// twice: a split has to spare many tests to be worth its references.
  double faceCost = 0.05;
  /// The part of a split's cost that is forgiven if one side is empty, in [0, 1). Cutting off empty
  /// space pays more than the heuristic sees, since rays then leave the tree early.
  double emptyBonus = 0.2;

  /// Cost of a leaf with `count` objects.
  [[nodiscard]] constexpr double leafCost(std::uint64_t count) const noexcept {
    return intersectionCost * static_cast<double>(count);
  }

  /// Cost of a split: a ray that meets the cell meets each side with the ratio of the side's area
  /// to that of the cell. With a traversal cost of 0, an intersection cost of 1 and no bonus it is
  /// the textbook's `(nL AL + nR AR) / A`. A cell without area costs as if both sides were always
  /// met.
  [[nodiscard]] constexpr double splitCost(std::uint64_t leftCount, double leftArea,
                                           std::uint64_t rightCount, double rightArea,
                                           double cellArea) const noexcept {
    const double leftChance = cellArea > 0.0 ? leftArea / cellArea : 1.0;
    const double rightChance = cellArea > 0.0 ? rightArea / cellArea : 1.0;
    const double objectCost = intersectionCost * (leftChance * static_cast<double>(leftCount) +
                                                  rightChance * static_cast<double>(rightCount));
    const bool cutsOffEmptySpace = leftCount == 0 || rightCount == 0;
    return (traversalCost + objectCost) * (cutsOffEmptySpace ? 1.0 - emptyBonus : 1.0);
  }
};

}  // namespace planetree
