#include "traversal/wide_query.hpp"

#include <planetree/traversal/prepared_ray.hpp>

#include <cmath>

namespace planetree::detail {
namespace {

// Between these no product below over- or underflows: the longest way to a plane is the largest
// distance times the largest inverse, 2^40 times that of the largest component.
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
  if (!isInRange(std::fabs(direction[sheared.kz])) || !isInRange(ray.distanceSlack * 0x1p20f))
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
