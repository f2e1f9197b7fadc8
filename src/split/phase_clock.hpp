#pragma once

#include <planetree/split/build_report.hpp>

#include <chrono>
#include <string_view>

namespace planetree::detail {

/// Measures the phases of a build, one after the other.
class PhaseClock {
 public:
  /// The clock runs from here on, and writes into `report`, which must outlive it.
  explicit PhaseClock(BuildReport& report) : report_(report) {}

  /// Ends a phase, which began where the last one ended. `name` must be a literal.
  void end(std::string_view name) {
    const Clock::time_point now = Clock::now();
    report_.phases.push_back({name, secondsBetween(phaseStart_, now)});
    report_.totalSeconds = secondsBetween(start_, now);
    phaseStart_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double secondsBetween(Clock::time_point start, Clock::time_point end) {
    return std::chrono::duration<double>(end - start).count();
  }

  BuildReport& report_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point phaseStart_ = start_;
};

}  // namespace planetree::detail
