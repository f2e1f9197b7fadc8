#include <planetree/geometry/rounding.hpp>
#include <planetree/mesh/triangle_intersection.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include "node/wide_node.hpp"
#include "traversal/search_wide.hpp"
#include "traversal/wide_query.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace planetree::detail {
namespace {

// How far floats are from the doubles they stand for: docs/numerics.md, section 3. All in terms of
// the unit roundoff of float and of the largest distance, along an axis, between the center of the
// tree and the ray's origin and a corner, one after the other.
constexpr double kRoundoff = 0x1p-24;
constexpr double kBoxSlackInRoundoffs = 4.0;
constexpr double kEdgeSlackInRoundoffs = 48.0;
/// A direction whose component is smaller than this part of the largest one looks parallel to a
/// plane, as `PreparedRay<float>` has it.
constexpr double kNearParallel = 0x1p-40;

// Between these no product of floats overflows, and what underflows is far below the slack.
constexpr double kSmallestDirection = 0x1p-40;
constexpr double kLargestDirection = 0x1p+40;
constexpr double kSmallestReach = 0x1p-36;
constexpr double kLargestReach = 0x1p+40;

/// A query of a tree of doubles.
struct WideSearch : WideQuery {
  WideSearch(const Query<double>& asked, Hitd& found) noexcept : query(asked), hit(found) {
    const WideTree& wide = *query.tree.wide;
    nodes = wide.nodes.data();
    blocks = wide.blocks.data();
    root = wide.root;
    tMin = roundDown(query.interval.tMin);
    hitT = roundUp(query.interval.tMax);
  }

  /// Fills in the ray. False if its numbers are so large or small that those of the wide form could
  /// over- or underflow.
  [[nodiscard]] bool prepareRay() noexcept {
    const ShearedRay<double>& sheared = query.ray.sheared;
    const double largestComponent = std::fabs(sheared.ray.direction[sheared.kz]);
    const Vec3d origin = sheared.ray.origin - static_cast<Vec3d>(query.tree.wide->center);
    const double reach = reachFrom(origin);
    // False for NaN.
    const bool isInRange = largestComponent >= kSmallestDirection &&
                           largestComponent <= kLargestDirection && reach >= kSmallestReach &&
                           reach <= kLargestReach;
    if (!isInRange)
      return false;
    prepareForBlocks(sheared, origin, reach);
    prepareForBoxes(sheared, origin, reach);
    return true;
  }

  template <class Goal>
  [[nodiscard]] bool testFaces(Candidates& candidates) noexcept {
    // After the hit of the nearest the others may be too far.
    const auto nearest = static_cast<std::size_t>(
        std::min_element(candidates.earliest, candidates.earliest + candidates.count) -
        candidates.earliest);
    std::swap(candidates.objects[0], candidates.objects[nearest]);
    std::swap(candidates.earliest[0], candidates.earliest[nearest]);
    bool found = false;
    for (std::uint32_t i = 0; i < candidates.count; ++i) {
      if (candidates.earliest[i] > hitT || !testFace<Goal>(candidates.objects[i]))
        continue;
      found = true;
      if (Goal::kStopsAtAnyHit)
        break;
    }
    return found;
  }

  template <class Goal>
  [[nodiscard]] bool testLeaf(std::uint32_t leafIndex) noexcept {
    Unobserved unobserved;
    if (!visitLeaf<Goal>(query.tree.nodes[leafIndex].leaf(), query, hit, unobserved))
      return false;
    if (Goal::kStopsAtAnyHit)
      return true;
    isHitOnFace = false;
    shortenRay();
    return true;
  }

  /// Fills in what is needed of the nearest hit alone.
  void finishHit() noexcept {
    if (!isHitOnFace)
      return;
    const auto [a, b, c] = meshOf(query.tree.geometries[hit.geometry]).corners(hit.primitive);
    hit.normal = triangleNormal(a, b, c, query.ray.ray().direction);
  }

 private:
  /// The largest distance along an axis from the ray's origin to the center of the tree and on to
  /// a corner. `origin` is relative to the center.
  [[nodiscard]] double reachFrom(const Vec3d& origin) const noexcept {
    const auto center = static_cast<Vec3d>(query.tree.wide->center);
    double reach = 0.0;
    for (const Axis axis : kAxes) {
      const double below = center[axis] - static_cast<double>(query.tree.bounds.lower[axis]);
      const double above = static_cast<double>(query.tree.bounds.upper[axis]) - center[axis];
      reach = std::max(reach, std::fabs(origin[axis]) + std::max(below, above));
    }
    return reach;
  }

  /// Tests one face with the corners of its mesh; whether that answers the query or has a better
  /// hit.
  template <class Goal>
  [[nodiscard]] bool testFace(std::uint32_t object) noexcept {
    const auto geometries = query.tree.geometries;
    const std::uint32_t geometry = geometryOf(geometries, object);
    const GeometryEntry<double>& entry = geometries[geometry];
    if ((entry.mask & query.mask) == 0)
      return false;
    const auto [from, to] = query.interval;
    const std::uint32_t face = object - entry.firstObject;
    const auto [a, b, c] = meshOf(entry).corners(face);
    const auto at = intersectTriangle(query.ray.sheared, a, b, c, from, hit.t < to ? hit.t : to);
    if (!at || Goal::kStopsAtAnyHit)
      return at.has_value();
    const Hitd candidate = {
        .t = at->t, .u = at->u, .v = at->v, .geometry = geometry, .primitive = face};
    if (!isBefore(candidate, hit))
      return false;
    hit = candidate;
    isHitOnFace = true;
    shortenRay();
    return true;
  }

  void prepareForBlocks(const ShearedRay<double>& sheared, const Vec3d& origin,
                        double reach) noexcept {
    kx = static_cast<std::uint32_t>(sheared.kx);
    ky = static_cast<std::uint32_t>(sheared.ky);
    kz = static_cast<std::uint32_t>(sheared.kz);
    originX = static_cast<float>(origin[sheared.kx]);
    originY = static_cast<float>(origin[sheared.ky]);
    originZ = static_cast<float>(origin[sheared.kz]);
    shearX = static_cast<float>(sheared.shearX);
    shearY = static_cast<float>(sheared.shearY);
    edgeSlack = static_cast<float>(kEdgeSlackInRoundoffs * kRoundoff * reach);
  }

  void prepareForBoxes(const ShearedRay<double>& sheared, const Vec3d& origin,
                       double reach) noexcept {
    const double largestInverse =
        std::fabs(query.ray.along(sheared.kz).inverseDirection) / kNearParallel;
    const double slack = kBoxSlackInRoundoffs * kRoundoff * reach;
    octant = 0;
    for (const Axis axis : kAxes) {
      const auto a = static_cast<std::size_t>(axis);
      const AxisRay<double>& along = query.ray.along(axis);
      const double size = std::min(std::fabs(along.inverseDirection), largestInverse);
      const double perUnit = std::copysign(size, along.inverseDirection);
      const double toCenter = -origin[axis] * perUnit;
      inverse[a] = static_cast<float>(perUnit);
      nearOffset[a] = static_cast<float>(toCenter - slack * size);
      farOffset[a] = static_cast<float>(toCenter + slack * size);
      octant |= static_cast<std::uint32_t>(along.fromAbove) << a;
    }
  }

  [[nodiscard]] static const TriangleMeshView<double>& meshOf(
      const GeometryEntry<double>& entry) noexcept {
    return *static_cast<const TriangleMeshView<double>*>(entry.range);
  }

  /// To the hit, or a little beyond: a cell that holds a hit as near must still be met.
  void shortenRay() noexcept {
    hitT = roundUp(hit.t);
    hitObject = query.tree.geometries[hit.geometry].firstObject + hit.primitive;
  }

  const Query<double>& query;
  Hitd& hit;                 ///< the best so far
  bool isHitOnFace = false;  ///< and on a triangle of a block: its normal is missing
};

}  // namespace

template <class Goal>
std::optional<bool> searchWide(const Query<double>& query, Hitd& hit,
                               const WideKernels& kernels) noexcept {
  if (query.tree.wide == nullptr)
    return std::nullopt;
  if (!query.ray.isValid() || query.tree.bounds.isEmpty())
    return false;
  WideSearch search(query, hit);
  if (!search.prepareRay())
    return std::nullopt;
  search.testObjects = [](WideQuery& wide, std::uint32_t leafIndex) noexcept {
    return static_cast<WideSearch&>(wide).testLeaf<Goal>(leafIndex);
  };
  search.testCandidates = [](WideQuery& wide, Candidates& candidates) noexcept {
    return static_cast<WideSearch&>(wide).testFaces<Goal>(candidates);
  };
  if (Goal::kStopsAtAnyHit)
    return kernels.findAnyOfRounded(search);
  if (!kernels.findNearestOfRounded(search))
    return false;
  search.finishHit();
  return true;
}

template std::optional<bool> searchWide<NearestHit>(const Query<double>&, Hitd&,
                                                    const WideKernels&) noexcept;
template std::optional<bool> searchWide<AnyHit>(const Query<double>&, Hitd&,
                                                const WideKernels&) noexcept;

}  // namespace planetree::detail
