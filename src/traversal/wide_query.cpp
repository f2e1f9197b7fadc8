#include "traversal/wide_query.hpp"

#include <planetree/traversal/prepared_ray.hpp>

#include <algorithm>
#include <array>
#include <cmath>

/// What `PreparedRay` does, once more for speed: preparing a ray is a good part of a query that
/// ends after a few nodes. No branches that depend on the direction, and four lanes at a time.
namespace planetree::detail {
namespace {

// Between these no product below over- or underflows: t of the farthest plane is at most the
// largest distance times 2^40 (see `PreparedRay`) over the largest component. docs/numerics.md,
// section 3.
constexpr float kSmallest = 0x1p-40f;
constexpr float kLargest = 0x1p+40f;

bool isInRange(float x) noexcept {
  return x >= kSmallest && x <= kLargest;
}

/// One number for each axis, and one more that nobody reads.
using PerAxis = std::array<float, 4>;

PerAxis perAxis(const Vec3f& v) noexcept {
  return {v.x, v.y, v.z, v.z};
}

float largestOf(const PerAxis& numbers) noexcept {
  return std::max(std::max(numbers[0], numbers[1]), numbers[2]);
}

/// As in `ShearedRay`, where the direction is largest; the last of equal ones.
std::uint32_t axisOfLargest(const PerAxis& sizes) noexcept {
  const auto ofFirstTwo = static_cast<std::uint32_t>(!(sizes[0] > sizes[1]));
  const auto isOfFirstTwo = static_cast<std::uint32_t>(std::max(sizes[0], sizes[1]) > sizes[2]);
  return 2 - isOfFirstTwo * (2 - ofFirstTwo);
}

}  // namespace

bool WideQuery::prepare(const Rayf& ray, const Box3& bounds, const Vec3f& center) noexcept {
  const PerAxis origin = perAxis(ray.origin);
  const PerAxis direction = perAxis(ray.direction);
  const PerAxis lower = perAxis(bounds.lower);
  const PerAxis upper = perAxis(bounds.upper);
  const PerAxis middle = perAxis(center);
  PerAxis sizes;
  PerAxis distances;
  for (std::size_t i = 0; i < 4; ++i) {
    sizes[i] = std::fabs(direction[i]);
    distances[i] = std::max(std::fabs(lower[i] - origin[i]), std::fabs(upper[i] - origin[i]));
  }
  const float largest = largestOf(sizes);
  reach = largestOf(distances);
  // The largest of numbers says nothing of those that are none.
  if (!(isInRange(largest) && isInRange(reach) && isFinite(ray.origin) && isFinite(ray.direction)))
    return false;

  static constexpr std::array<std::uint32_t, 3> kNextAxis = {1, 2, 0};
  kz = axisOfLargest(sizes);
  kx = kNextAxis[kz];
  ky = kNextAxis[kx];
  originX = origin[kx];
  originY = origin[ky];
  originZ = origin[kz];
  directionZ = direction[kz];
  PerAxis shear;
  for (std::size_t i = 0; i < 4; ++i)
    shear[i] = direction[i] / directionZ;
  shearX = shear[kx];
  shearY = shear[ky];

  const float smallest = largest * kNearParallel<float>;
  const float distanceSlack = kSlackInRoundoffs<float> * kRoundoff<float> * reach;
  for (std::size_t i = 0; i < 4; ++i) {
    const float component = std::copysign(std::max(sizes[i], smallest), direction[i]);
    inverse[i] = 1.0f / component;
    const float slack = distanceSlack * std::fabs(inverse[i]);
    const float toCenter = (middle[i] - origin[i]) * inverse[i];
    nearOffset[i] = toCenter - slack;
    farOffset[i] = toCenter + slack;
  }
  octant = 0;
  for (std::uint32_t i = 0; i < 3; ++i)
    octant |= static_cast<std::uint32_t>(std::signbit(direction[i])) << i;
  return true;
}

}  // namespace planetree::detail
