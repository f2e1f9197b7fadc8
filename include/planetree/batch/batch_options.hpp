#pragma once

#include <planetree/traversal/query_options.hpp>

#include <cstdint>
#include <functional>
#include <stop_token>

namespace planetree {

/// What the caller happens to know of the rays of a batch, as other libraries ask for it. Neither
/// answers nor speed depend on it so far: what rays have in common is found out from the rays.
enum class RayHint : std::uint8_t {
  None,
  Coherent,    ///< neighbours have nearly the same origin and direction, as those of a camera
  Incoherent,  ///< neighbours have nothing in common
  Shadow       ///< short, and from nearly the same origins
};

/// How a batch of rays is traced.
struct BatchOptions {
  /// For all rays of the batch. Where these leave something out (but for a mask that sees all
  /// geometries), rays are traced one by one.
  QueryOptions query = {};

  /// Threads to trace with, at most as many as oneTBB may use; 0 means all threads of the caller's
  /// oneTBB arena. Batches of about a thousand rays stay in the caller's thread in any case. All
  /// threads round and flush denormals as the calling one does.
  std::uint32_t threadCount = 0;

  RayHint hint = RayHint::None;
};

/// A hand on a long batch while it runs.
struct BatchControl {
  /// Told now and then what part of the rays has been traced, and once at the end, with 1. It never
  /// falls. Called from the threads that trace, never by two at a time; it should be quick, and
  /// must not wait for oneTBB tasks. What it throws ends the batch and comes out of the call, and
  /// it is not called again.
  std::function<void(double done)> onProgress = {};

  /// Ends the batch soon after a stop is requested: the call throws `Cancelled`. Each ray has then
  /// its answer, or what stood there before.
  std::stop_token stopToken = {};
};

}  // namespace planetree
