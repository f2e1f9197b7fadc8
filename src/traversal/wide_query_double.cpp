#include "traversal/wide_query.hpp"

#include <algorithm>
#include <cmath>

namespace planetree::detail {
namespace {

// How far floats are from the doubles they stand for: docs/numerics.md, section 3. All in terms of
// the unit roundoff of float and of the largest distance, along an axis, between the center of the
// tree and the ray's origin and a corner, one after the other.
constexpr double kRoundoffOfFloat = 0x1p-24;
constexpr double kBoxSlackInRoundoffs = 4.0;
constexpr double kEdgeSlackInRoundoffs = 48.0;
/// A direction whose component is smaller than this part of the largest one looks parallel to a
/// plane, as `PreparedRay<float>` has it.
constexpr double kNearParallelOfFloat = 0x1p-40;

// Between these no product of floats overflows, and what underflows is far below the slack.
constexpr double kSmallestDirection = 0x1p-40;
constexpr double kLargestDirection = 0x1p+40;
constexpr double kSmallestReach = 0x1p-36;
constexpr double kLargestReach = 0x1p+40;

/// The largest distance along an axis from the ray's origin to the center of the tree and on to a
/// corner. `origin` is relative to the center.
double reachFrom(const Vec3d& origin, const WideFrame& frame) noexcept {
  double reach = 0.0;
  for (const Axis axis : kAxes) {
    const auto toCorner = static_cast<double>(frame.halfSize[static_cast<std::size_t>(axis)]);
    reach = std::max(reach, std::fabs(origin[axis]) + toCorner);
  }
  return reach;
}

void prepareForBlocks(const ShearedRay<double>& sheared, const Vec3d& origin, double distance,
                      WideQuery& query) noexcept {
  const Axis axes[3] = {sheared.kx, sheared.ky, sheared.kz};
  for (std::size_t i = 0; i < 3; ++i) {
    query.axes[i] = static_cast<std::uint32_t>(axes[i]);
    query.origin[i] = static_cast<float>(origin[axes[i]]);
  }
  query.shear[0] = static_cast<float>(sheared.shearX);
  query.shear[1] = static_cast<float>(sheared.shearY);
  query.directionZ = static_cast<float>(sheared.ray.direction[sheared.kz]);
  query.edgeSlack = static_cast<float>(kEdgeSlackInRoundoffs * kRoundoffOfFloat * distance);
}

void prepareForBoxes(const PreparedRay<double>& ray, const Vec3d& origin, double distance,
                     WideQuery& query) noexcept {
  const double largestInverse =
      std::fabs(ray.along(ray.sheared.kz).inverseDirection) / kNearParallelOfFloat;
  const double slack = kBoxSlackInRoundoffs * kRoundoffOfFloat * distance;
  query.octant = 0;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    const AxisRay<double>& along = ray.along(axis);
    const double size = std::min(std::fabs(along.inverseDirection), largestInverse);
    const double perUnit = std::copysign(size, along.inverseDirection);
    const double toCenter = -origin[axis] * perUnit;
    query.inverse[a] = static_cast<float>(perUnit);
    query.nearOffset[a] = static_cast<float>(toCenter - slack * size);
    query.farOffset[a] = static_cast<float>(toCenter + slack * size);
    query.octant |= static_cast<std::uint32_t>(along.fromAbove) << a;
  }
}

}  // namespace

bool WideQuery::prepare(const PreparedRay<double>& prepared) noexcept {
  const ShearedRay<double>& sheared = prepared.sheared;
  const double largestComponent = std::fabs(sheared.ray.direction[sheared.kz]);
  Vec3d fromCenter = sheared.ray.origin;
  for (const Axis axis : kAxes)
    fromCenter[axis] -= static_cast<double>(tree.frame.center[static_cast<std::size_t>(axis)]);
  const double distance = reachFrom(fromCenter, tree.frame);
  // False for NaN.
  const bool isInRange = largestComponent >= kSmallestDirection &&
                         largestComponent <= kLargestDirection && distance >= kSmallestReach &&
                         distance <= kLargestReach;
  if (!prepared.isValid() || !isInRange)
    return false;
  prepareForBlocks(sheared, fromCenter, distance, *this);
  prepareForBoxes(prepared, fromCenter, distance, *this);
  reach = static_cast<float>(distance);
  cornersAreRounded = true;
  return true;
}

}  // namespace planetree::detail
