#pragma once

#include <planetree/split/build_control.hpp>
#include <planetree/split/build_report.hpp>

#include "support/memory_meter.hpp"

#include <atomic>
#include <chrono>
#include <mutex>
#include <string_view>

namespace planetree::detail {

/// What the caller of a build sees of it while it runs, and can do to it. Any thread of the build
/// may use all but `beginPhase`.
class BuildMonitor {
 public:
  /// The clock runs from here on. Both must outlive the monitor.
  BuildMonitor(const BuildControl& control, BuildReport& report)
      : control_(control), report_(report), memory_(control.memoryLimit) {}

  /// Ends the phase before, if there is one. `name` must be a literal; `share` is what part of the
  /// whole build the phase is expected to take.
  void beginPhase(std::string_view name, double share);
  /// Ends the last phase, and with it the build.
  void finish();

  /// Throws `Cancelled` if a stop has been requested, or another thread has thrown. Quick.
  ///
  /// To be called behind every parallel loop inside of a task: when another task throws, oneTBB
  /// ends all loops of the build early, and those that did not throw themselves return as if all
  /// were done.
  void throwIfStopped() const;
  /// Says that another part of the phase is done, tells the caller now and then, and throws what
  /// the caller throws, or `Cancelled`.
  void advance(double partOfPhase);

  [[nodiscard]] MemoryMeter& memory() noexcept { return memory_; }

 private:
  using Clock = std::chrono::steady_clock;

  void endPhase();

  const BuildControl& control_;
  BuildReport& report_;
  MemoryMeter memory_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point phaseStart_ = start_;
  std::string_view phase_;
  double doneBefore_ = 0.0;  ///< of the build, in earlier phases
  double share_ = 0.0;       ///< of the phase
  std::atomic<double> doneOfPhase_ = 0.0;
  std::mutex telling_;
  bool hasThrown_ = false;               ///< the caller, who is told no more; guarded, too
  double told_ = 0.0;                    ///< guarded by `telling_`
  Clock::time_point lastTold_ = start_;  ///< guarded by `telling_`
};

}  // namespace planetree::detail
