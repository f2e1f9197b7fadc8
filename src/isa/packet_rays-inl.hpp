// The rays of a packet, as the wide form of a tree sees them. Compiled once for each instruction
// set; hence no include guard but the one of Highway.

#if defined(PLANETREE_PACKET_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLANETREE_PACKET_RAYS_INL
#undef PLANETREE_PACKET_RAYS_INL
#else
#define PLANETREE_PACKET_RAYS_INL
#endif

#include "isa/prepare_ray-inl.hpp"
#include "isa/wide_traversal-inl.hpp"
#include "traversal/ray_packet.hpp"

#include <hwy/highway.h>
#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace planetree::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

static_assert(RayPacket::kRayCount == kLaneCount);

/// The lanes of one vector in a set of sixteen.
template <class Tag>
HWY_INLINE hn::Mask<Tag> maskOf(Tag tag, std::uint32_t set, std::size_t firstLane) {
  const std::uint32_t bits = set >> firstLane;
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                 static_cast<std::uint8_t>(bits >> 8u)};
  return hn::LoadMaskBits(tag, bytes);
}
template <class Tag>
HWY_INLINE std::uint32_t setOf(Tag tag, hn::Mask<Tag> mask, std::size_t firstLane) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(tag, mask, bytes);
  return (bytes[0] | std::uint32_t{bytes[1]} << 8u) << firstLane;
}

HWY_INLINE std::size_t sizeOf(std::uint32_t set) {
  return hwy::PopCount(set);
}

/// One number of each ray.
struct RayNumbers {
  HWY_ALIGN float of[kLaneCount];

  HWY_INLINE Floats operator[](std::size_t vector) const {
    return hn::Load(FloatTag(), of + vector * kLanesPerVector);
  }
  HWY_INLINE void put(std::size_t vector, Floats numbers) {
    hn::Store(numbers, FloatTag(), of + vector * kLanesPerVector);
  }
};

/// The least and the greatest of numbers.
struct Range {
  float least;
  float greatest;
};

HWY_INLINE Range rangeOf(const RayNumbers& numbers, std::uint32_t rays) {
  const FloatTag d;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  // Often all rays begin in one point.
  const float first = numbers.of[hwy::Num0BitsBelowLS1Bit_Nonzero32(rays)];
  Mask isFirst[kVectorCount];
  forEachVector([&](auto i) { isFirst[i] = hn::Eq(numbers[i], hn::Set(d, first)); });
  if ((rays & ~bitsOf(isFirst)) == 0)
    return {first, first};
  Floats least = hn::Set(d, kInfinity);
  Floats greatest = hn::Set(d, -kInfinity);
  forEachVector([&](auto i) {
    const Mask isThere = maskOf(d, rays, i * kLanesPerVector);
    least = hn::Min(least, hn::IfThenElse(isThere, numbers[i], hn::Set(d, kInfinity)));
    greatest = hn::Max(greatest, hn::IfThenElse(isThere, numbers[i], hn::Set(d, -kInfinity)));
  });
  return {hn::GetLane(hn::MinOfLanes(d, least)), hn::GetLane(hn::MaxOfLanes(d, greatest))};
}

/// The rays as boxes and triangles see them; see WideQuery for what the numbers are. Of sets, bit i
/// stands for ray i.
struct PacketRays {
  RayNumbers inverse[3];
  RayNumbers toCenter[3];
  RayNumbers nearOffset[3];
  RayNumbers farOffset[3];
  RayNumbers origin[3];  ///< along the sheared axes of each ray
  RayNumbers shear[2];
  RayNumbers directionZ;
  RayNumbers depthPerT;
  RayNumbers depthPerZ;
  RayNumbers reach;
  std::uint32_t isNegative[3];  ///< those whose direction is negative along the axis
  std::uint32_t isMostly[3];    ///< those whose direction is largest along the axis

  HWY_INLINE std::uint32_t octantOf(std::size_t ray) const {
    return (isNegative[0] >> ray & 1u) | (isNegative[1] >> ray & 1u) << 1u |
           (isNegative[2] >> ray & 1u) << 2u;
  }
  /// The axis along which the direction is largest.
  HWY_INLINE std::uint32_t mainAxisOf(std::size_t ray) const {
    return (isMostly[1] >> ray & 1u) | (isMostly[2] >> ray & 1u) << 1u;
  }
};

/// Fills in the arrays of the rays if these stand elsewhere.
HWY_INLINE void loadRows(RayPacket& packet) {
  if (packet.rows[0] == nullptr)
    return;
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t ray = 0; ray < kLaneCount; ++ray) {
    const float* const row = packet.rows[ray];
    for (std::size_t a = 0; a < 3; ++a) {
      packet.origin[a][ray] = row[a];
      packet.direction[a][ray] = row[3 + a];
    }
    packet.tMin[ray] = row[6];
    packet.hitT[ray] = row[7];
  }
#else
  const hn::FixedTag<float, 4> d;
  for (std::size_t ray = 0; ray < kLaneCount; ray += 4) {
    // Four rows of four numbers become four columns.
    const auto transpose = [&](std::size_t from, float* first, float* second, float* third,
                               float* fourth) {
      const auto a = hn::LoadU(d, packet.rows[ray] + from);
      const auto b = hn::LoadU(d, packet.rows[ray + 1] + from);
      const auto c = hn::LoadU(d, packet.rows[ray + 2] + from);
      const auto e = hn::LoadU(d, packet.rows[ray + 3] + from);
      const auto lowerAC = hn::InterleaveLower(d, a, c);
      const auto lowerBE = hn::InterleaveLower(d, b, e);
      const auto upperAC = hn::InterleaveUpper(d, a, c);
      const auto upperBE = hn::InterleaveUpper(d, b, e);
      hn::Store(hn::InterleaveLower(d, lowerAC, lowerBE), d, first + ray);
      hn::Store(hn::InterleaveUpper(d, lowerAC, lowerBE), d, second + ray);
      hn::Store(hn::InterleaveLower(d, upperAC, upperBE), d, third + ray);
      hn::Store(hn::InterleaveUpper(d, upperAC, upperBE), d, fourth + ray);
    };
    transpose(0, packet.origin[0], packet.origin[1], packet.origin[2], packet.direction[0]);
    transpose(4, packet.direction[1], packet.direction[2], packet.tMin, packet.hitT);
  }
#endif
}

/// Fills in the rays, as `prepareRay` does for each of them, and returns those that may hit
/// something. Those out of range are left unanswered.
HWY_INLINE std::uint32_t preparePacket(const WideTree& tree, RayPacket& packet, PacketRays& rays) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> bits;
  const hn::RebindToSigned<FloatTag> words;
  std::uint32_t isValid = 0;
  std::uint32_t hasInterval = 0;
  for (std::size_t a = 0; a < 3; ++a)
    rays.isNegative[a] = rays.isMostly[a] = 0;
  forEachVector([&](auto i) {
    const std::size_t at = i * kLanesPerVector;
    Floats origin[3];
    Floats direction[3];
    Floats toCenter[3];
    Floats notNumbers = hn::Zero(d);
    Floats largest = hn::Zero(d);
    Floats reach = hn::Zero(d);
    for (std::size_t a = 0; a < 3; ++a) {
      origin[a] = hn::Load(d, packet.origin[a] + at);
      direction[a] = hn::Load(d, packet.direction[a] + at);
      toCenter[a] = hn::Sub(hn::Set(d, tree.frame.center[a]), origin[a]);
      notNumbers = hn::Add(
          notNumbers, hn::Add(hn::Sub(origin[a], origin[a]), hn::Sub(direction[a], direction[a])));
      largest = hn::Max(largest, hn::Abs(direction[a]));
      reach = hn::Max(reach, hn::Add(hn::Abs(toCenter[a]), hn::Set(d, tree.frame.halfSize[a])));
    }
    const auto isBetween = [&](Floats number) {
      return hn::And(hn::Ge(number, hn::Set(d, kSmallest)), hn::Le(number, hn::Set(d, kLargest)));
    };
    const Mask areNumbers = hn::Eq(notNumbers, hn::Zero(d));
    isValid |= bitsOf(hn::And(areNumbers, hn::And(isBetween(largest), isBetween(reach)))) << at;
    hasInterval |= bitsOf(hn::Le(hn::Load(d, packet.tMin + at), hn::Load(d, packet.hitT + at)))
                   << at;

    const auto exponent = hn::And(hn::BitCast(bits, largest), hn::Set(bits, kExponentBits));
    const Floats most = hn::BitCast(d, hn::Sub(hn::Set(bits, kExponentOfMost), exponent));
    const Floats distanceSlack =
        hn::Mul(reach, hn::Set(d, kSlackInRoundoffs<float> * kRoundoff<float>));
    for (std::size_t a = 0; a < 3; ++a) {
      const Floats quotient = hn::Abs(hn::Div(hn::Set(d, 1.0f), direction[a]));
      const Floats inverse = hn::CopySign(hn::Min(quotient, most), direction[a]);
      const Floats slack = hn::Mul(distanceSlack, hn::Abs(inverse));
      const Floats offset = hn::Mul(toCenter[a], inverse);
      rays.inverse[a].put(i, inverse);
      rays.toCenter[a].put(i, toCenter[a]);
      rays.nearOffset[a].put(i, hn::Sub(offset, slack));
      rays.farOffset[a].put(i, hn::Add(offset, slack));
      const auto isNegative = hn::Lt(hn::BitCast(words, direction[a]), hn::Zero(words));
      rays.isNegative[a] |= bitsOf(hn::RebindMask(d, isNegative)) << at;
    }

    const Mask isMostlyZ = hn::Eq(hn::Abs(direction[2]), largest);
    const Mask isMostlyY = hn::AndNot(isMostlyZ, hn::Eq(hn::Abs(direction[1]), largest));
    rays.isMostly[2] |= bitsOf(isMostlyZ) << at;
    rays.isMostly[1] |= bitsOf(isMostlyY) << at;
    const auto choose = [&](Floats ifX, Floats ifY, Floats ifZ) {
      return hn::IfThenElse(isMostlyZ, ifZ, hn::IfThenElse(isMostlyY, ifY, ifX));
    };
    const Floats along = choose(direction[0], direction[1], direction[2]);
    rays.directionZ.put(i, along);
    rays.shear[0].put(i, hn::Div(choose(direction[1], direction[2], direction[0]), along));
    rays.shear[1].put(i, hn::Div(choose(direction[2], direction[0], direction[1]), along));
    rays.origin[0].put(i, choose(origin[1], origin[2], origin[0]));
    rays.origin[1].put(i, choose(origin[2], origin[0], origin[1]));
    rays.origin[2].put(i, choose(origin[0], origin[1], origin[2]));
    const Floats half = hn::Div(hn::Set(d, 0.5f), reach);
    rays.reach.put(i, reach);
    rays.depthPerT.put(i, hn::Mul(half, hn::Abs(along)));
    rays.depthPerZ.put(i, hn::CopySign(half, along));
  });
  rays.isMostly[0] = ~(rays.isMostly[1] | rays.isMostly[2]);
  packet.unanswered = packet.rays & ~isValid;
  return packet.rays & isValid & hasInterval;
}

/// Of these rays, those that go the way of the first one: into the same octant, and mostly along
/// the same axis.
HWY_INLINE std::uint32_t findLikeFirst(const PacketRays& rays, std::uint32_t asked) {
  const auto first = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(asked));
  std::uint32_t together = asked & rays.isMostly[rays.mainAxisOf(first)];
  for (std::size_t a = 0; a < 3; ++a) {
    const std::uint32_t set = rays.isNegative[a];
    together &= (set >> first & 1u) != 0 ? set : ~set;
  }
  return together;
}

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
