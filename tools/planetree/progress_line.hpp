#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace planetree::tool {

/// One line on standard error that shows how far a long step is. It shows nothing unless standard
/// error is a terminal and `isWanted`, and it is wiped off at the end.
class ProgressLine {
 public:
  ProgressLine(std::string step, bool isWanted);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// `done` from 0 to 1. Any thread may call it, as often as it likes.
  void update(double done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string step_;
  bool isShown_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  Clock::time_point lastShown_ = start_;
};

}  // namespace planetree::tool
