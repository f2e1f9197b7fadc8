#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace planetree::detail {

struct EndCounting;
struct RayPacket;
struct WideQuery;
struct WideSteps;
struct WideTree;

/// The loops that are compiled for each instruction set. All of them give the same bits.
struct Kernels {
  std::string_view name;  ///< "scalar", "sse4", "avx2", "avx512", "neon"
  /// Finds the nearest hit with t from `tMin` to `hitT`, of equal ones that with the lowest object.
  /// True if there is one, which is then in `query`.
  bool (*findNearest)(WideQuery& query) noexcept;
  /// True if there is any hit with t from `tMin` to `hitT`.
  bool (*findAny)(WideQuery& query) noexcept;
  /// The same for queries that decide for themselves: `WideTests::testCandidates` is handed the
  /// triangles that the ray may hit, and keeps the hit.
  bool (*handOverForNearest)(WideQuery& query) noexcept;
  bool (*handOverForAny)(WideQuery& query) noexcept;
  /// `findNearest` and `findAny` with the steps they take, which are added.
  bool (*countNearest)(WideQuery& query, WideSteps& steps) noexcept;
  bool (*countAny)(WideQuery& query, WideSteps& steps) noexcept;
  /// `findNearest` and `findAny` for all rays of up to `RayPacket::kGroupSize` packets, in a tree
  /// of triangles alone. Rays whose numbers are out of range are left unanswered.
  void (*findNearestOfPackets)(const WideTree& tree, RayPacket* packets,
                               std::size_t count) noexcept;
  void (*findAnyOfPackets)(const WideTree& tree, RayPacket* packets, std::size_t count) noexcept;
  /// Counts the ends of boxes by bins.
  void (*countEnds)(const EndCounting& counting) noexcept;
};

/// Those that this machine can run, the best one first.
[[nodiscard]] std::span<const Kernels> supportedKernels() noexcept;

/// The best one, unless PLANETREE_ISA names another: see instruction_set.hpp.
[[nodiscard]] const Kernels& chooseKernels() noexcept;

/// The same, chosen at the first call, once for the program.
[[nodiscard]] inline const Kernels& activeKernels() noexcept {
  static const Kernels& chosen = chooseKernels();
  return chosen;
}

}  // namespace planetree::detail
