#pragma once

#include <cstdint>
#include <vector>

namespace planetree {

/// Why an object is not in the tree.
enum class SkipReason : std::uint8_t {
  IndexOutOfRange,  ///< a face with a vertex index beyond the last vertex
  NotFinite,        ///< a corner or a box with a NaN, an infinity, or beyond the range of float
  Empty,            ///< a null pointer, or a shape whose box is empty
  RepeatedCorner,   ///< a face with two corners at one point: no ray can hit it
};

/// One object that was left out.
struct SkippedObject {
  std::uint32_t geometry = 0;
  std::uint32_t primitive = 0;
  SkipReason reason = SkipReason::Empty;
};

/// What building did. Skipped objects keep their number: nothing else is renumbered.
struct BuildReport {
  std::uint64_t objectCount = 0;       ///< all objects handed over, the skipped ones included
  std::uint64_t skippedCount = 0;      ///< of them not in the tree
  std::vector<SkippedObject> skipped;  ///< the first few skipped ones
  double boundSeconds = 0.0;           ///< bounding the objects
  double splitSeconds = 0.0;           ///< splitting, down to the finished nodes
  double totalSeconds = 0.0;
};

}  // namespace planetree
