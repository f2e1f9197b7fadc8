// Where a ray meets a triangle of a block, as far as float can tell. Compiled once for each
// instruction set; hence no include guard but the one of Highway.

#if defined(PLANETREE_DISTANCE_BOUNDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLANETREE_DISTANCE_BOUNDS_INL
#undef PLANETREE_DISTANCE_BOUNDS_INL
#else
#define PLANETREE_DISTANCE_BOUNDS_INL
#endif

#include "traversal/wide_query.hpp"

#include <hwy/highway.h>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace planetree::detail::HWY_NAMESPACE {

/// A corner as the ray sees it: the ray is the third axis, its origin the origin.
struct ShearedCorner {
  float x;
  float y;
  float z;
};

/// All corners of a block.
struct ShearedBlock {
  HWY_ALIGN float x[TriangleBlock::kPositionCount];
  HWY_ALIGN float y[TriangleBlock::kPositionCount];
  HWY_ALIGN float z[TriangleBlock::kPositionCount];

  [[nodiscard]] HWY_INLINE ShearedCorner operator[](std::size_t i) const {
    return {x[i], y[i], z[i]};
  }
};

/// Where a ray meets a triangle with rounded corners, if it does: t lies in between. Such bounds
/// hold for every triangle that the test in double accepts: docs/numerics.md, section 3.
struct DistanceBounds {
  float lower;
  float upper;

  /// No part of the ray that counts lies within. False for NaN.
  [[nodiscard]] HWY_INLINE bool areOutside(const WideQuery& query) const {
    return lower > query.hitT || upper < query.tMin;
  }
  [[nodiscard]] HWY_INLINE bool areInside(const WideQuery& query) const {
    return lower >= query.tMin && upper <= query.hitT;
  }
};

template <class T>
HWY_INLINE T larger(T x, T y) {
  return x > y ? x : y;
}
template <class T>
HWY_INLINE T smaller(T x, T y) {
  return x < y ? x : y;
}
HWY_INLINE float magnitude(float x) {
  return x < 0.0f ? -x : x;
}

/// From the corners alone: the hit is no nearer than all of them, and no farther.
HWY_INLINE DistanceBounds boundByCorners(const WideQuery& query, const TriangleBlock& block,
                                         const ShearedBlock& sheared, std::size_t lane) {
  const float inverse = query.inverse[query.axes[2]];
  const auto distance = [&](std::size_t corner) {
    return sheared.z[block.corners[corner][lane]] * inverse;
  };
  const float a = distance(0);
  const float b = distance(1);
  const float c = distance(2);
  const float slack = 0.5f * query.edgeSlack * magnitude(inverse);
  return {smaller(smaller(a, b), c) - slack, larger(larger(a, b), c) + slack};
}

/// From the weights of the corners, and how far these may be off. Infinitely far apart, or NaN,
/// where rounding has left nothing of the triangle.
HWY_INLINE DistanceBounds boundByWeights(const WideQuery& query, const TriangleBlock& block,
                                         const ShearedBlock& sheared, std::size_t lane) {
  const ShearedCorner a = sheared[block.corners[0][lane]];
  const ShearedCorner b = sheared[block.corners[1][lane]];
  const ShearedCorner c = sheared[block.corners[2][lane]];
  const float v = a.x * c.y - a.y * c.x;
  const float w = b.x * a.y - b.y * a.x;
  const float sum = (c.x * b.y - c.y * b.x) + v + w;
  const float toB = b.z - a.z;
  const float toC = c.z - a.z;
  const float z = a.z + (v * toB + w * toC) / sum;

  const auto size = [](const ShearedCorner& corner) {
    return larger(magnitude(corner.x), magnitude(corner.y));
  };
  const float reach = larger(larger(size(a), size(b)), size(c)) + 0.0625f * query.edgeSlack;
  const float depth = larger(magnitude(toB), magnitude(toC));
  const float inverse = query.inverse[query.axes[2]];
  // Divided first: then nothing that counts can underflow.
  const float slackOfWeights = 8.0f * (reach / magnitude(sum)) * depth;
  const float slack = query.edgeSlack * (0.5f + slackOfWeights) * magnitude(inverse);
  return {z * inverse - slack, z * inverse + slack};
}

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
