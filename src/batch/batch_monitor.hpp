#pragma once

#include <planetree/batch/batch_options.hpp>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>

namespace planetree::detail {

/// Throws `Cancelled` if a stop has been requested.
void throwIfStopped(const BatchControl& control);

/// What the caller of a batch sees of it while it runs, and can do to it. For any number of
/// threads.
class BatchMonitor {
 public:
  BatchMonitor(const BatchControl& control, std::size_t packetCount) noexcept
      : control_(control), packetCount_(packetCount) {
    // Small batches take little longer than to look at the clock.
    if (control.onProgress)
      lastTold_ = Clock::now();
  }

  /// So many packets more have been traced; throws what the caller throws, or `Cancelled`.
  void advance(std::size_t packetCount);
  /// All have been traced.
  void finish() const;

 private:
  using Clock = std::chrono::steady_clock;

  const BatchControl& control_;
  std::size_t packetCount_;
  std::atomic<std::size_t> doneCount_ = 0;
  std::mutex telling_;
  bool hasThrown_ = false;      ///< the caller, who is told no more; guarded by `telling_`
  double told_ = 0.0;           ///< guarded by `telling_`
  Clock::time_point lastTold_;  ///< guarded by `telling_`
};

}  // namespace planetree::detail
