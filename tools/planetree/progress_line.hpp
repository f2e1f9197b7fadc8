#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace planetree::tool {

/// One line on standard error that shows how a step goes that takes longer than a moment: with a
/// bar and the time left where it is known how much is done, else with the time it has taken. It
/// shows nothing unless standard error is a terminal and `isWanted`, and it is wiped off at the
/// end.
class ProgressLine {
 public:
  ProgressLine(std::string step, bool isWanted);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// `done` from 0 to 1. Any thread may call it, as often as it likes.
  void update(double done) noexcept { done_ = done; }

 private:
  using Clock = std::chrono::steady_clock;

  /// Shows the line again and again until the step has ended.
  void showUntilEnd();
  void show() const;

  std::string step_;
  Clock::time_point start_ = Clock::now();
  std::atomic<double> done_ = 0.0;
  std::mutex mutex_;
  std::condition_variable endOfStep_;
  bool hasEnded_ = false;  ///< guarded by `mutex_`
  std::thread painter_;    ///< none where nothing is shown
};

/// "rendering [=====               ]  25 %, 12 s left", or "building the tree, 3 s".
[[nodiscard]] std::string progressText(const std::string& step, double done, double seconds);

}  // namespace planetree::tool
