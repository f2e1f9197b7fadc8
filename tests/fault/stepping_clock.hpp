#pragma once

#include <chrono>

namespace planetree::test {

/// While it lives, the steady clock of planetree's libraries jumps at each look: progress, which is
/// told now and then, is told whenever it might be. The linker leads calls of the clock here.
class SteppingClock {
 public:
  explicit SteppingClock(std::chrono::milliseconds step) noexcept;
  SteppingClock(const SteppingClock&) = delete;
  SteppingClock& operator=(const SteppingClock&) = delete;
  ~SteppingClock();
};

}  // namespace planetree::test
