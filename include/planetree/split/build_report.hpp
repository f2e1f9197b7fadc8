#pragma once

#include <planetree/split/scene_range.hpp>

#include <cstdint>
#include <string_view>
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

/// A part of the build, and how long it took by the wall clock.
struct BuildPhase {
  std::string_view name;  ///< "bound", "split", ...; lives as long as the program
  double seconds = 0.0;
};

/// What building did. Skipped objects keep their number: nothing else is renumbered.
struct BuildReport {
  std::uint64_t objectCount = 0;       ///< all objects handed over, the skipped ones included
  std::uint64_t skippedCount = 0;      ///< of them not in the tree
  std::vector<SkippedObject> skipped;  ///< the first few skipped ones
  /// Of all objects in the tree. Outside of the range it is built and asked all the same, but hits
  /// may be lost.
  SceneRange sceneRange = SceneRange::Within;
  /// What took how long, in the order in which it was done. Which phases there are may change with
  /// the builder: "bound" bounds the objects, "split" finds the planes and divides the objects down
  /// to the leaves, "retract" takes back splits (`BuildOptions::retractsSplits`), "assemble" makes
  /// the arrays of the binary form, "widen" the form that queries walk.
  std::vector<BuildPhase> phases;
  double totalSeconds = 0.0;         ///< the sum of the phases
  std::uint64_t referenceCount = 0;  ///< entries of all leaves; an object may have several
  /// The most memory that the build held at a time, the finished tree included, but not the
  /// objects: what `BuildControl::memoryLimit` limits. Small things are not counted.
  std::uint64_t peakBytes = 0;
};

}  // namespace planetree
