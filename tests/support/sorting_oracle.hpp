#pragma once

#include "support/textbook_oracle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// The search of `findBestSplitPlaneByCounting` for sets that are too large for it: counts are
/// looked up in sorted lists of all ends. It has no bins, and passes no candidate over.
namespace planetree::test {

/// The ends of boxes along one axis, sorted.
struct SortedEnds {
  std::vector<float> lower;
  std::vector<float> upper;
  std::array<std::vector<float>, 2> planar;  ///< by whether the normal gives them to the left

  SortedEnds(std::span<const Reference> objects, Axis axis) {
    for (const Reference& object : objects) {
      lower.push_back(object.bounds.lower[axis]);
      upper.push_back(object.bounds.upper[axis]);
      if (object.isPlanar(axis))
        planar[object.belongsLeft(axis) ? 1 : 0].push_back(object.bounds.lower[axis]);
    }
    for (std::vector<float>* ends : {&lower, &upper, &planar[0], &planar[1]})
      std::sort(ends->begin(), ends->end());
  }
};

[[nodiscard]] inline std::uint64_t countBelow(const std::vector<float>& ends, float position) {
  return static_cast<std::uint64_t>(std::lower_bound(ends.begin(), ends.end(), position) -
                                    ends.begin());
}
[[nodiscard]] inline std::uint64_t countAbove(const std::vector<float>& ends, float position) {
  return static_cast<std::uint64_t>(ends.end() -
                                    std::upper_bound(ends.begin(), ends.end(), position));
}

[[nodiscard]] inline std::optional<OraclePlane> findBestSplitPlaneBySorting(
    std::span<const Reference> objects, const Box3& cell, const BuildOptions& options) {
  std::optional<OraclePlane> best;
  for (const Axis axis : kAxes) {
    const SortedEnds ends(objects, axis);
    const auto improve = [&](float position, Side planarSide) {
      const auto planarCount = [&](std::size_t side) {
        return ends.planar[side].size() - countBelow(ends.planar[side], position) -
               countAbove(ends.planar[side], position);
      };
      const std::uint64_t all = planarCount(0) + planarCount(1);
      const std::uint64_t left = options.planarRule == PlanarRule::NormalSign ? planarCount(1)
                                 : planarSide == Side::Left                   ? all
                                                                              : 0;
      OraclePlane plane{.axis = axis, .position = position, .planarSide = planarSide};
      plane.leftCount = countBelow(ends.lower, position) + left;
      plane.rightCount = countAbove(ends.upper, position) + (all - left);
      plane.cost = options.cost.splitCost(plane.leftCount, areaOf(leftBoxOf(cell, axis, position)),
                                          plane.rightCount,
                                          areaOf(rightBoxOf(cell, axis, position)), areaOf(cell));
      if (!best || plane.isBetterThan(*best))
        best = plane;
    };
    for (const std::vector<float>* positions : {&ends.lower, &ends.upper}) {
      for (const float position : *positions) {
        const bool isInside = position > cell.lower[axis] && position < cell.upper[axis];
        const bool isOnWall = position == cell.lower[axis] || position == cell.upper[axis];
        if (!isInside && !(isOnWall && !options.allowsEmptyCells))
          continue;
        improve(position, Side::Right);
        if (options.planarRule == PlanarRule::CheaperSide)
          improve(position, Side::Left);
      }
    }
  }
  return best;
}

}  // namespace planetree::test
