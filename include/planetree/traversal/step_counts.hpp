#pragma once

#include <cstdint>

namespace planetree {

/// The work that queries did; each counted query adds to it.
struct StepCounts {
  std::uint64_t splitNodes = 0;  ///< split nodes visited (the broad phase)
  std::uint64_t leafNodes = 0;   ///< leaves visited, the empty ones included
  std::uint64_t objects = 0;     ///< objects tested (the narrow phase)
};

}  // namespace planetree
