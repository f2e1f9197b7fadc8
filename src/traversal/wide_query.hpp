#pragma once

#include <planetree/traversal/prepared_ray.hpp>

#include "node/wide_node.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace planetree::detail {

/// Triangles of a block that a kernel hands over.
struct Candidates {
  std::uint32_t objects[TriangleBlock::kLaneCount];
  float earliest[TriangleBlock::kLaneCount];  ///< no hit is nearer; or NaN
  std::uint32_t count = 0;
};

/// A ray on its way through the wide form of a tree: all that a kernel reads, and what it found.
/// Plain numbers and functions only, so that kernels share no code with the rest of the library.
struct WideQuery {
  /// Fills in a ray for a tree whose objects are in double, and its positions in blocks relative to
  /// the center. False if the numbers of the ray are so large or small that the tests of boxes
  /// could over- or underflow, or are no numbers. Rays in float are prepared by the kernels.
  [[nodiscard]] bool prepare(const PreparedRay<double>& prepared) noexcept;

  // --- the tree ---
  const WideNode* nodes = nullptr;
  const TriangleBlock* blocks = nullptr;
  WideChild root = {};
  /// Whether nodes are so many that they are often far away, and worth fetching ahead.
  bool isLargeTree = false;
  const WideFrame* frame = nullptr;

  // --- a ray in float that is still to be prepared ---
  const float* ray = nullptr;  ///< origin, direction, tMin, tMax; null if it is prepared
  bool isOutOfRange = false;   ///< the kernel cannot answer

  // --- the ray as the triangles see it ---
  std::uint32_t kx = 0;  ///< the axes, permuted as in `ShearedRay`
  std::uint32_t ky = 1;
  std::uint32_t kz = 2;
  float directionZ = 0.0f;
  float tMin = 0.0f;

  // One number more than there are axes: four are computed as fast as three.
  alignas(16) float origin[4];
  alignas(16) float shear[4];  ///< along kx and ky

  // --- the ray as the boxes see it: t = plane * inverse + offset ---
  alignas(16) float inverse[4];
  alignas(16) float nearOffset[4];  ///< less the slack, so that t is never too late
  alignas(16) float farOffset[4];   ///< plus the slack, so that t is never too early
  std::uint32_t octant = 0;         ///< bit a: the direction is negative along axis a
  float reach = 0.0f;  ///< the largest distance, along an axis, from the origin to a corner

  // --- objects that are not in blocks ---
  /// Tests the object of a reference; true if that answers the query or lowers `hitT`.
  bool (*testObject)(WideQuery& query, std::uint32_t reference) noexcept = nullptr;

  // --- triangles that are handed over ---
  /// An edge function of rounded corners that is no larger than this times their largest sheared
  /// coordinate may have the wrong sign. Corners in float are not rounded.
  float edgeSlack = 0.0f;
  bool cornersAreRounded = false;
  /// Tests triangles with the corners of their mesh; true if that answers the query or lowers
  /// `hitT`.
  bool (*testCandidates)(WideQuery& query, Candidates& candidates) noexcept = nullptr;

  // --- the best hit so far ---
  float hitT = 0.0f;                        ///< at first the end of the interval
  std::uint32_t hitObject = 0xFFFF'FFFFu;   ///< the tree's number of the object
  const TriangleBlock* hitBlock = nullptr;  ///< null if it is no triangle of a block
  std::uint32_t hitLane = 0;
  double hitWeights[3];  ///< of the corners, not divided by their sum
};

}  // namespace planetree::detail
