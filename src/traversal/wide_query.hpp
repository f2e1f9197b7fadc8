#pragma once

#include <planetree/traversal/prepared_ray.hpp>

#include "node/wide_node.hpp"

#include <cstddef>
#include <cstdint>

namespace planetree::detail {

/// Triangles of a block that a kernel hands over.
struct Candidates {
  std::uint32_t objects[TriangleBlock::kLaneCount];
  float earliest[TriangleBlock::kLaneCount];  ///< no hit is nearer; or NaN
  std::uint32_t count = 0;
};

struct WideQuery;

/// What kernels leave to others. True if what is tested answers the query or lowers `hitT`.
struct WideTests {
  /// Tests the object with this number, one that is in no block.
  bool (*testObject)(WideQuery& query, std::uint32_t object) noexcept;
  /// Tests triangles with the corners of their mesh, for queries that hand them over.
  bool (*testCandidates)(WideQuery& query, Candidates& candidates) noexcept;
};

/// How far queries went through the wide form.
struct WideSteps {
  std::uint64_t nodes = 0;   ///< nodes visited
  std::uint64_t blocks = 0;  ///< blocks of triangles tested
};

/// A ray on its way through the wide form of a tree: all that a kernel reads, and what it found.
/// Plain numbers and functions only, so that kernels share no code with the rest of the library.
/// Most members have no value until the ray is prepared: to clear them would take as long.
struct WideQuery {
  WideQuery(const WideTree& wide, const WideTests& wideTests, float from, float to) noexcept
      : tree(wide), tests(wideTests), hitT(to), tMin(from) {}

  /// Fills in a ray for a tree whose objects are in double, and its positions in blocks relative to
  /// the center. False if the numbers of the ray are so large or small that the tests of boxes
  /// could over- or underflow, or are no numbers. Rays in float are prepared by the kernels.
  [[nodiscard]] bool prepare(const PreparedRay<double>& prepared) noexcept;

  const WideTree& tree;
  const WideTests& tests;

  // --- a ray in float that is still to be prepared ---
  const float* ray = nullptr;  ///< origin and direction; null if it is prepared
  bool isOutOfRange = false;   ///< the kernel cannot answer

  // --- the best hit so far ---
  float hitT;                               ///< at first the end of the interval
  std::uint32_t hitObject = 0xFFFF'FFFFu;   ///< the tree's number of the object
  const TriangleBlock* hitBlock = nullptr;  ///< null if it is no triangle of a block
  std::uint32_t hitLane;
  double hitWeights[3];  ///< of the corners, not divided by their sum

  // --- the ray as the triangles see it: along the axes kx, ky, kz of `ShearedRay` ---
  std::uint32_t axes[3];
  float origin[3];
  float shear[2];
  float directionZ;
  /// Depths are in parts of twice the largest t of a corner: nothing over- or underflows.
  float depthPerT;
  float depthPerZ;
  float tMin;
  /// An edge function of rounded corners that is no larger than this times their largest sheared
  /// coordinate may have the wrong sign. Corners in float are not rounded.
  float edgeSlack = 0.0f;
  bool cornersAreRounded = false;

  // --- the ray as the boxes see it: t = plane * inverse + offset ---
  alignas(16) float inverse[4];
  alignas(16) float nearOffset[4];  ///< less the slack, so that t is never too late
  alignas(16) float farOffset[4];   ///< plus the slack, so that t is never too early
  std::uint32_t octant;             ///< bit a: the direction is negative along axis a
  float reach;  ///< the largest distance, along an axis, from the origin to a corner
};

}  // namespace planetree::detail
