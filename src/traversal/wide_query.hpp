#pragma once

#include <planetree/traversal/prepared_ray.hpp>

#include "node/wide_node.hpp"

#include <cstddef>
#include <cstdint>

namespace planetree::detail {

/// A ray on its way through the wide form of a tree: all that a kernel reads, and what it found.
/// Plain numbers and functions only, so that kernels share no code with the rest of the library.
struct WideQuery {
  /// Fills in the ray; `center` is that of the wide tree. False if the numbers of the ray are so
  /// large or small that the tests of boxes could over- or underflow.
  [[nodiscard]] bool prepare(const PreparedRay<float>& ray, const Vec3f& center) noexcept;

  // --- the tree ---
  const WideNode* nodes = nullptr;
  const TriangleBlock* blocks = nullptr;
  WideChild root = {};
  /// Whether nodes are so many that they are often far away, and worth fetching ahead.
  bool isLargeTree = false;

  // --- the ray as the triangles see it ---
  std::uint32_t kx = 0;  ///< the axes, permuted as in `ShearedRay`
  std::uint32_t ky = 1;
  std::uint32_t kz = 2;
  float originX = 0.0f;  ///< the origin along kx
  float originY = 0.0f;
  float originZ = 0.0f;
  float shearX = 0.0f;
  float shearY = 0.0f;
  float directionZ = 0.0f;
  float tMin = 0.0f;

  // --- the ray as the boxes see it: t = plane * inverse + offset ---
  float inverse[3] = {};
  float nearOffset[3] = {};  ///< less the slack, so that t is never too late
  float farOffset[3] = {};   ///< plus the slack, so that t is never too early
  std::uint32_t octant = 0;  ///< bit a: the direction is negative along axis a

  // --- objects that are not in blocks ---
  /// Tests the object of a reference; true if that answers the query or lowers `hitT`.
  bool (*testObject)(WideQuery& query, std::uint32_t reference) noexcept = nullptr;
  /// Whether the query sees an object; null if it sees all.
  bool (*sees)(const WideQuery& query, std::uint32_t object) noexcept = nullptr;

  // --- the best hit so far ---
  float hitT = 0.0f;                        ///< at first the end of the interval
  std::uint32_t hitObject = 0xFFFF'FFFFu;   ///< the tree's number of the object
  const TriangleBlock* hitBlock = nullptr;  ///< null if it is no triangle of a block
  std::uint32_t hitLane = 0;
  double hitWeights[3] = {};  ///< of the corners, not divided by their sum
};

}  // namespace planetree::detail
