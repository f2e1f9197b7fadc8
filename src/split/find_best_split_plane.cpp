#include <planetree/split/find_best_split_plane.hpp>

#include "split/plane_search.hpp"
#include "support/assert.hpp"

#include <algorithm>

namespace planetree {
std::optional<SplitPlane> findBestSplitPlane(std::span<const Reference> references,
                                             const Box3& cell, const BuildOptions& options) {
  const std::optional<SplitPlane> best = detail::PlaneSearch(options).find(references, cell);
  PLANETREE_ASSERT(!best ||
                   best->leftCount == countLeftObjects(references, *best, options.planarRule));
  PLANETREE_ASSERT(!best ||
                   best->rightCount == countRightObjects(references, *best, options.planarRule));
  return best;
}

std::uint64_t countLeftObjects(std::span<const Reference> references, const SplitPlane& plane,
                               PlanarRule rule) noexcept {
  return static_cast<std::uint64_t>(
      std::count_if(references.begin(), references.end(),
                    [&](const Reference& r) { return goesLeft(r, plane, rule); }));
}

std::uint64_t countRightObjects(std::span<const Reference> references, const SplitPlane& plane,
                                PlanarRule rule) noexcept {
  return static_cast<std::uint64_t>(
      std::count_if(references.begin(), references.end(),
                    [&](const Reference& r) { return goesRight(r, plane, rule); }));
}

}  // namespace planetree
