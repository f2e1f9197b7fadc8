#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string_view>

namespace planetree {

/// How far a build has come.
struct BuildProgress {
  std::string_view phase;  ///< see `BuildReport::phases`; lives as long as the program
  double done = 0.0;       ///< of the whole build, from 0 to 1; it never falls
};

/// A hand on a build while it runs. Without any of it a build is left to itself.
///
///     std::stop_source stop;
///     BuildControl control;
///     control.onProgress = [&](const BuildProgress& progress) { bar.show(progress.done); };
///     control.stopToken = stop.get_token();
///     const auto tree = buildTree(mesh.view(), BuildOptions::fast(), control);
struct BuildControl {
  /// Told now and then how far the build has come, and once at the end, with 1. Called from the
  /// threads that build, never by two at a time; it should be quick, and must not wait for oneTBB
  /// tasks. What it throws ends the build and comes out of `buildTree`, and it is not called
  /// again.
  std::function<void(const BuildProgress&)> onProgress = {};

  /// Ends the build soon after a stop is requested: `buildTree` throws `Cancelled`, and all memory
  /// that the build has taken is free again. A stop that comes too late changes nothing.
  std::stop_token stopToken = {};

  /// How many bytes the build may take in all, the finished tree included, but not the objects; 0
  /// stands for the memory that the machine has. Where more would be needed, `buildTree` throws
  /// `Error` with `MemoryLimitExceeded`, before or soon after it takes it. What a build took is in
  /// `BuildReport::peakBytes`; for triangles it is some 100 to 250 bytes each.
  std::uint64_t memoryLimit = 0;
};

}  // namespace planetree
