// Bounds of all rays of a packet: what these miss each of the rays misses. Compiled once for each
// instruction set; hence no include guard but the one of Highway.

#if defined(PLANETREE_RAY_BUNDLES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLANETREE_RAY_BUNDLES_INL
#undef PLANETREE_RAY_BUNDLES_INL
#else
#define PLANETREE_RAY_BUNDLES_INL
#endif

#include "isa/packet_rays-inl.hpp"
#include "isa/wide_traversal-inl.hpp"

#include <hwy/highway.h>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace planetree::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// All rays of a packet at once, for the boxes of a node: what this misses, each of them misses.
class RayBundle {
 public:
  HWY_INLINE RayBundle(const PacketRays& rays, const RayNumbers& tMin, std::uint32_t octant,
                       std::uint32_t together) {
    const float reach = rangeOf(rays.reach, together).greatest;
    for (std::size_t a = 0; a < 3; ++a) {
      const Range inverse = rangeOf(rays.inverse[a], together);
      const Range toCenter = rangeOf(rays.toCenter[a], together);
      const bool isNegative = (octant >> a & 1u) != 0;
      leastInverse_[a] = inverse.least;
      greatestInverse_[a] = inverse.greatest;
      nearToCenter_[a] = isNegative ? toCenter.greatest : toCenter.least;
      farToCenter_[a] = isNegative ? toCenter.least : toCenter.greatest;
      // Twice that of a single ray: docs/numerics.md, section 3.
      slack_[a] = 2.0f * kSlackInRoundoffs<float> * kRoundoff<float> * reach *
                  larger(magnitude(inverse.least), magnitude(inverse.greatest));
      planes_[a] = (2 * a + (isNegative ? 1u : 0u)) * kLaneCount;
    }
    tMin_ = rangeOf(tMin, together).least;
  }

  HWY_INLINE void test(const WideNode& node, float tMax, BoxTest& result) const {
    const FloatTag d;
    const float* const planes = &node.planes[0][0];
    forEachVector([&](auto i) {
      const std::size_t at = i * kLanesPerVector;
      Floats tNear = hn::Set(d, tMin_);
      Floats tFar = hn::Set(d, tMax);
      for (std::size_t a = 0; a < 3; ++a) {
        const Floats least = hn::Set(d, leastInverse_[a]);
        const Floats greatest = hn::Set(d, greatestInverse_[a]);
        const Floats slack = hn::Set(d, slack_[a]);
        const Floats toNear =
            hn::Add(hn::Load(d, planes + planes_[a] + at), hn::Set(d, nearToCenter_[a]));
        const Floats toFar = hn::Add(hn::Load(d, planes + (planes_[a] ^ kLaneCount) + at),
                                     hn::Set(d, farToCenter_[a]));
        tNear = hn::Max(tNear,
                        hn::Sub(hn::Min(hn::Mul(toNear, least), hn::Mul(toNear, greatest)), slack));
        tFar =
            hn::Min(tFar, hn::Add(hn::Max(hn::Mul(toFar, least), hn::Mul(toFar, greatest)), slack));
      }
      result.tNear.vectors[i] = tNear;
      result.tFar.vectors[i] = tFar;
    });
  }

 private:
  float leastInverse_[3], greatestInverse_[3];
  float nearToCenter_[3], farToCenter_[3];
  float slack_[3];
  float tMin_;
  std::size_t planes_[3];
};

/// The same for the triangles of a block.
class ShearedBundle {
 public:
  HWY_INLINE ShearedBundle(const PacketRays& rays, const std::uint32_t (&axes)[3],
                           std::uint32_t together) {
    for (std::size_t k = 0; k < 3; ++k) {
      origin_[k] = rangeOf(rays.origin[k], together);
      rows_[k] = axes[k] * TriangleBlock::kPositionCount;
    }
    for (std::size_t k = 0; k < 2; ++k)
      shear_[k] = rangeOf(rays.shear[k], together);
  }

  /// How far the directions go apart, in parts of the largest component.
  HWY_INLINE float spread() const {
    return larger(shear_[0].greatest - shear_[0].least, shear_[1].greatest - shear_[1].least);
  }

  /// The triangles that any of the rays may hit. Each step is rounded as for a single ray, and
  /// rounding keeps order: the sheared corners of each ray lie within the bounds, exactly.
  HWY_INLINE std::uint32_t findMet(const TriangleBlock& block) const {
    const FloatTag d;
    Lanes least[2];
    Lanes greatest[2];
    forEachVector([&](auto i) {
      const auto row = [&](std::size_t k) {
        return hn::Load(d, &block.positions[0][0] + rows_[k] + i * kLanesPerVector);
      };
      const auto fromOrigin = [&](std::size_t k, float origin) {
        return hn::Sub(row(k), hn::Set(d, origin));
      };
      const Floats leastZ = fromOrigin(2, origin_[2].greatest);
      const Floats greatestZ = fromOrigin(2, origin_[2].least);
      for (std::size_t k = 0; k < 2; ++k) {
        const Floats lowShear = hn::Set(d, shear_[k].least);
        const Floats highShear = hn::Set(d, shear_[k].greatest);
        const Floats a = hn::Mul(lowShear, leastZ);
        const Floats b = hn::Mul(lowShear, greatestZ);
        const Floats c = hn::Mul(highShear, leastZ);
        const Floats e = hn::Mul(highShear, greatestZ);
        least[k].vectors[i] =
            hn::Sub(fromOrigin(k, origin_[k].greatest), hn::Max(hn::Max(a, b), hn::Max(c, e)));
        greatest[k].vectors[i] =
            hn::Sub(fromOrigin(k, origin_[k].least), hn::Min(hn::Min(a, b), hn::Min(c, e)));
      }
    });
    Mask isMet[kVectorCount];
    forEachVector([&](auto i) {
      const hn::Rebind<std::uint8_t, WordTag> bytes;
      Words corners[3];
      for (std::size_t corner = 0; corner < 3; ++corner) {
        corners[corner] =
            hn::PromoteTo(WordTag(), hn::LoadU(bytes, block.corners[corner] + i * kLanesPerVector));
      }
      const Floats zero = hn::Zero(d);
      Mask isAround[2];
      for (std::size_t k = 0; k < 2; ++k) {
        const Floats lowest =
            hn::Min(hn::Min(pick(least[k], corners[0]), pick(least[k], corners[1])),
                    pick(least[k], corners[2]));
        const Floats highest =
            hn::Max(hn::Max(pick(greatest[k], corners[0]), pick(greatest[k], corners[1])),
                    pick(greatest[k], corners[2]));
        isAround[k] = hn::And(hn::Le(lowest, zero), hn::Ge(highest, zero));
      }
      isMet[i] = hn::And(isAround[0], isAround[1]);
    });
    return bitsOf(isMet) & block.usedLanes;
  }

 private:
  Range origin_[3];
  Range shear_[2];
  std::size_t rows_[3];
};

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
