#include "stepping_clock.hpp"

#include <atomic>
#include <cstdint>

using Clock = std::chrono::steady_clock;

// See memory_faults.cpp.
Clock::time_point realNow() __asm__("__real__ZNSt6chrono3_V212steady_clock3nowEv");
Clock::time_point wrappedNow() __asm__("__wrap__ZNSt6chrono3_V212steady_clock3nowEv");

namespace {

std::atomic<std::int64_t> stepMilliseconds = 0;
std::atomic<std::int64_t> addedMilliseconds = 0;

}  // namespace

Clock::time_point wrappedNow() {
  const std::int64_t step = stepMilliseconds;
  return realNow() + std::chrono::milliseconds(addedMilliseconds += step);
}

namespace planetree::test {

SteppingClock::SteppingClock(std::chrono::milliseconds step) noexcept {
  stepMilliseconds = step.count();
}

SteppingClock::~SteppingClock() {
  stepMilliseconds = 0;
  // Nobody has looked at it before and looks again, but for the test's own stopwatch.
  addedMilliseconds = 0;
}

}  // namespace planetree::test
