#pragma once

#include "traversal/wide_query.hpp"

#include <span>
#include <string_view>

namespace planetree::detail {

/// The loop over the wide form, compiled for one instruction set. All of them give the same bits.
struct WideKernels {
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
};

/// Those that this machine can run, the best one first.
[[nodiscard]] std::span<const WideKernels> supportedWideKernels() noexcept;

/// The best one, unless PLANETREE_ISA names another: see instruction_set.hpp.
[[nodiscard]] const WideKernels& chooseWideKernels() noexcept;

/// The same, chosen at the first call, once for the program.
[[nodiscard]] inline const WideKernels& wideKernels() noexcept {
  static const WideKernels& chosen = chooseWideKernels();
  return chosen;
}

}  // namespace planetree::detail
