#include "traversal/wide_query.hpp"

#include <planetree/traversal/prepared_ray.hpp>

#include <cmath>

namespace planetree::detail {
namespace {

// Between these no product below over- or underflows: t of the farthest plane is at most the largest
// distance times 2^40 (see `PreparedRay`) over the largest component. docs/numerics.md, section 3.
constexpr float kSmallest = 0x1p-40f;
constexpr float kLargest = 0x1p+40f;

bool isInRange(float x) noexcept {
  return x >= kSmallest && x <= kLargest;  // false for NaN
}

}  // namespace

bool WideQuery::prepare(const PreparedRay<float>& ray, const Vec3f& center) noexcept {
  const ShearedRay<float>& sheared = ray.sheared;
  const Vec3f& origin = ray.ray().origin;
  const Vec3f& direction = ray.ray().direction;
  constexpr float kSlackPart = kSlackInRoundoffs<float> * 0x1p-24f;
  if (!isInRange(std::fabs(direction[sheared.kz])) || !isInRange(ray.distanceSlack / kSlackPart))
    return false;

  kx = static_cast<std::uint32_t>(sheared.kx);
  ky = static_cast<std::uint32_t>(sheared.ky);
  kz = static_cast<std::uint32_t>(sheared.kz);
  originX = origin[sheared.kx];
  originY = origin[sheared.ky];
  originZ = origin[sheared.kz];
  shearX = sheared.shearX;
  shearY = sheared.shearY;
  directionZ = direction[sheared.kz];

  octant = 0;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    const AxisRay<float>& along = ray.along(axis);
    const float toCenter = (center[axis] - origin[axis]) * along.inverseDirection;
    inverse[a] = along.inverseDirection;
    nearOffset[a] = toCenter - along.slack;
    farOffset[a] = toCenter + along.slack;
    octant |= static_cast<std::uint32_t>(along.fromAbove) << a;
  }
  return true;
}

}  // namespace planetree::detail
