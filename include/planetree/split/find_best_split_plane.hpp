#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/reference.hpp>
#include <planetree/split/split_plane.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace planetree {

/// The plane that divides the cell at the smallest expected cost (`CostModel::splitCost`), of all
/// planes through the lower and upper ends of the references' boxes on all three axes. Nothing if
/// there is no such plane inside the cell.
///
/// Under `exactPlanes` it is the cheapest of all; without, the cheapest next to the best edge of a
/// few bins.
///
/// A sweep over the sorted ends of each axis counts both sides of every candidate, and bins spare
/// it the candidates that cannot be best: O(N log N) where all cost alike, else linear as a rule.
/// Many references are looked at by all threads of the caller's oneTBB arena. MacDonald and Booth
/// 1990 for the heuristic; Wald and Havran, "On building fast kd-trees for ray tracing, and on
/// doing that in O(N log N)", IEEE Symposium on Interactive Ray Tracing 2006, for the sweep. Unlike
/// the paper, equal costs are broken by axis, then by the lower position: the result must not
/// depend on the order of the references.
///
/// Objects in the plane go right unless left is strictly cheaper.
///
/// Under `allowsEmptyCells` planes strictly inside the cell are candidates; without, also those on
/// its walls, which leave one side flat, as the textbook has it. Planes outside do not divide the
/// cell and are passed over.
[[nodiscard]] std::optional<SplitPlane> findBestSplitPlane(std::span<const Reference> references,
                                                           const Box3& cell,
                                                           const BuildOptions& options);

namespace detail {

[[nodiscard]] constexpr bool liesIn(const SplitPlane& plane, const Reference& reference) noexcept {
  return reference.isPlanar(plane.axis) && reference.bounds.lower[plane.axis] == plane.position;
}

/// Only for references that lie in the plane.
[[nodiscard]] constexpr bool planarGoesLeft(const Reference& reference, const SplitPlane& plane,
                                            PlanarRule rule) noexcept {
  return rule == PlanarRule::NormalSign ? reference.belongsLeft(plane.axis)
                                        : plane.planarSide == Side::Left;
}

}  // namespace detail

/// Whether a reference has a part below the plane, or lies in it and is given to the left.
[[nodiscard]] constexpr bool goesLeft(const Reference& reference, const SplitPlane& plane,
                                      PlanarRule rule) noexcept {
  return detail::liesIn(plane, reference) ? detail::planarGoesLeft(reference, plane, rule)
                                          : reference.bounds.lower[plane.axis] < plane.position;
}
/// Whether a reference has a part above the plane, or lies in it and is given to the right.
[[nodiscard]] constexpr bool goesRight(const Reference& reference, const SplitPlane& plane,
                                       PlanarRule rule) noexcept {
  return detail::liesIn(plane, reference) ? !detail::planarGoesLeft(reference, plane, rule)
                                          : reference.bounds.upper[plane.axis] > plane.position;
}

/// How many references go left. O(N); the sweep of `findBestSplitPlane` gives the same numbers.
[[nodiscard]] std::uint64_t countLeftObjects(std::span<const Reference> references,
                                             const SplitPlane& plane, PlanarRule rule) noexcept;
/// How many references go right.
[[nodiscard]] std::uint64_t countRightObjects(std::span<const Reference> references,
                                              const SplitPlane& plane, PlanarRule rule) noexcept;

}  // namespace planetree
