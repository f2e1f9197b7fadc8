#pragma once

#include "node/wide_node.hpp"

#include <cstddef>
#include <cstdint>

namespace planetree::detail {

/// Sixteen rays in float that are taken through the wide form of a tree together, and what they
/// hit. Plain numbers only, so that kernels share no code with the rest of the library.
struct RayPacket {
  static constexpr std::size_t kRayCount = 16;
  /// So many packets are answered at a time, so that rays on their own find others to take turns
  /// with. Measured: 4 is 3 % slower with rays that go all ways, 16 no faster.
  static constexpr std::size_t kGroupSize = 8;

  // --- what is asked; bit i of a set stands for ray i ---
  /// Where the eight numbers of each ray stand, as in `Rayf`; null if they are in the arrays below,
  /// which the kernel fills in otherwise.
  const float* rows[kRayCount];
  alignas(64) float origin[3][kRayCount];
  alignas(64) float direction[3][kRayCount];
  alignas(64) float tMin[kRayCount];
  alignas(64) float hitT[kRayCount];  ///< at first the end of the interval
  std::uint32_t rays;                 ///< those that there are

  // --- what is answered ---
  std::uint32_t unanswered;  ///< rays that have to be asked one by one
  std::uint32_t hits;        ///< rays that hit something, of the others
  std::uint32_t flatHits;    ///< hits on triangles without area, whose normal is missing
  alignas(64) std::uint32_t hitObject[kRayCount];  ///< the tree's numbers of objects
  alignas(64) float u[kRayCount];
  alignas(64) float v[kRayCount];
  alignas(64) float normal[3][kRayCount];
};

}  // namespace planetree::detail
