// What the wide form needs of a ray in float. Compiled once for each instruction set; hence no
// include guard but the one of Highway.

#if defined(PLANETREE_PREPARE_RAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLANETREE_PREPARE_RAY_INL
#undef PLANETREE_PREPARE_RAY_INL
#else
#define PLANETREE_PREPARE_RAY_INL
#endif

#include "traversal/wide_query.hpp"

#include <hwy/highway.h>
#include <cmath>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace planetree::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Between these no product overflows, and what underflows is far below the slack: t of the farthest
// plane is at most the largest distance times 2^40 (see `PreparedRay`) over the largest component.
// docs/numerics.md, section 3.
constexpr float kSmallest = 0x1p-40f;
constexpr float kLargest = 0x1p+40f;

constexpr std::uint32_t kExponentBits = 0x7F80'0000u;
/// Of 2^40 divided by a power of two: twice the bias of floats and 40.
constexpr std::uint32_t kExponentOfMost = (2u * 127u + 40u) << 23u;
static_assert(kNearParallel<float> == 0x1p-40f);

/// `length` is the largest component of the direction. False for NaN.
HWY_INLINE bool isInRange(float length, float reach) {
  return length >= kSmallest && length <= kLargest && reach >= kSmallest && reach <= kLargest;
}

/// The number of the highest bit that is set, of which there must be one. Written so that compilers
/// see the instruction behind it.
HWY_INLINE std::uint32_t highestBit(std::uint32_t bits) {
  return 31u ^ static_cast<std::uint32_t>(hwy::Num0BitsAboveMS1Bit_Nonzero32(bits));
}

#if HWY_TARGET == HWY_SCALAR

/// Fills in what depends on the ray. False if its numbers are so large or small that the tests of
/// boxes could over- or underflow, or are no numbers. Without vectors `PreparedRay` does it.
HWY_INLINE bool prepareRay(WideQuery& query) {
  Rayf ray;
  Box3 bounds;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    ray.origin[axis] = query.ray[a];
    ray.direction[axis] = query.ray[3 + a];
    bounds.lower[axis] = query.tree.frame.center[a] - query.tree.frame.halfSize[a];
    bounds.upper[axis] = query.tree.frame.center[a] + query.tree.frame.halfSize[a];
  }
  const PreparedRay<float> prepared(ray, bounds);
  const ShearedRay<float>& sheared = prepared.sheared;
  query.directionZ = ray.direction[sheared.kz];
  query.reach = largestDistance(ray.origin, bounds);
  if (!prepared.isValid() || !isInRange(std::fabs(query.directionZ), query.reach))
    return false;

  const Axis axes[3] = {sheared.kx, sheared.ky, sheared.kz};
  for (std::size_t i = 0; i < 3; ++i) {
    query.axes[i] = static_cast<std::uint32_t>(axes[i]);
    query.origin[i] = ray.origin[axes[i]];
  }
  query.shear[0] = sheared.shearX;
  query.shear[1] = sheared.shearY;
  query.octant = 0;
  for (const Axis axis : kAxes) {
    const auto a = static_cast<std::size_t>(axis);
    const AxisRay<float>& along = prepared.along(axis);
    const float offset = (query.tree.frame.center[a] - along.origin) * along.inverseDirection;
    query.inverse[a] = along.inverseDirection;
    query.nearOffset[a] = offset - along.slack;
    query.farOffset[a] = offset + along.slack;
    query.octant |= static_cast<std::uint32_t>(along.fromAbove) << a;
  }
  return true;
}

#else

/// One number for each axis, and one more that nobody reads.
using AxesTag = hn::FixedTag<float, 4>;
using Axes = hn::Vec<AxesTag>;

/// Three numbers, one by one: they were often written that way just before, and would reach a load
/// of all three only after they have gone through to the cache.
HWY_INLINE Axes loadAxes(const float* numbers) {
  const AxesTag d;
  const Axes xy = hn::OddEven(hn::Set(d, numbers[1]), hn::Set(d, numbers[0]));
  return hn::ConcatUpperLower(d, hn::Set(d, numbers[2]), xy);
}

HWY_INLINE std::uint32_t axesIn(hn::Mask<AxesTag> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(AxesTag(), mask, bytes);
  return bytes[0] & 7u;
}

/// Fills in what depends on the ray, as the version without vectors does, for speed: to prepare a
/// ray is a good part of a query that ends after a few nodes. All axes at a time, and no branches
/// that depend on the direction.
HWY_INLINE bool prepareRay(WideQuery& query) {
  const AxesTag d;
  const auto isAxis = hn::FirstN(d, 3);
  const Axes origin = loadAxes(query.ray);
  const Axes direction = loadAxes(query.ray + 3);
  const Axes toCenter = hn::Sub(hn::Load(d, query.tree.frame.center), origin);
  const Axes sizes = hn::IfThenElseZero(isAxis, hn::Abs(direction));
  const Axes distances = hn::IfThenElseZero(
      isAxis, hn::Add(hn::Abs(toCenter), hn::Load(d, query.tree.frame.halfSize)));
  const Axes largest = hn::MaxOfLanes(d, sizes);
  const Axes reach = hn::MaxOfLanes(d, distances);
  query.reach = hn::GetLane(reach);

  // The largest of numbers says nothing of those that are none; differences from themselves do.
  const Axes notNumbers = hn::Add(hn::Sub(origin, origin), hn::Sub(direction, direction));
  const bool areNumbers = axesIn(hn::Eq(notNumbers, hn::Zero(d))) == 7u;
  if (!areNumbers || !isInRange(hn::GetLane(largest), query.reach))
    return false;

  // As in `ShearedRay`: of axes along which the direction is equally large, the last one.
  const std::uint32_t kz = highestBit(axesIn(hn::Eq(sizes, largest)));
  const auto kx = static_cast<std::uint32_t>(nextAxis(static_cast<Axis>(kz)));
  const auto ky = static_cast<std::uint32_t>(nextAxis(static_cast<Axis>(kx)));
  query.axes[0] = kx;
  query.axes[1] = ky;
  query.axes[2] = kz;
  query.origin[0] = query.ray[kx];
  query.origin[1] = query.ray[ky];
  query.origin[2] = query.ray[kz];
  query.directionZ = query.ray[3 + kz];
  query.shear[0] = query.ray[3 + kx] / query.directionZ;
  query.shear[1] = query.ray[3 + ky] / query.directionZ;

  // A direction nearly parallel to a plane takes up to 2^41 times what the one along the largest
  // component does, no more: as a power of two that is known before the quotient.
  const hn::RebindToUnsigned<AxesTag> bits;
  const auto exponent = hn::And(hn::BitCast(bits, largest), hn::Set(bits, kExponentBits));
  const Axes most = hn::BitCast(d, hn::Sub(hn::Set(bits, kExponentOfMost), exponent));
  const Axes quotient = hn::Abs(hn::Div(hn::Set(d, 1.0f), direction));
  const Axes inverse = hn::CopySign(hn::Min(quotient, most), direction);
  const Axes distanceSlack =
      hn::Mul(reach, hn::Set(d, kSlackInRoundoffs<float> * kRoundoff<float>));
  const Axes slack = hn::Mul(distanceSlack, hn::Abs(inverse));
  const Axes offset = hn::Mul(toCenter, inverse);
  hn::Store(inverse, d, query.inverse);
  hn::Store(hn::Sub(offset, slack), d, query.nearOffset);
  hn::Store(hn::Add(offset, slack), d, query.farOffset);
  const hn::RebindToSigned<AxesTag> words;
  query.octant = axesIn(hn::RebindMask(d, hn::Lt(hn::BitCast(words, direction), hn::Zero(words))));
  return true;
}

#endif  // HWY_TARGET == HWY_SCALAR

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
