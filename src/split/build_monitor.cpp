#include "split/build_monitor.hpp"

#include <planetree/error.hpp>

#include <tbb/task_group.h>

#include <algorithm>

namespace planetree::detail {
namespace {

constexpr std::chrono::milliseconds kTellingInterval(20);
constexpr double kMostBeforeTheEnd = 0.999;

double secondsBetween(std::chrono::steady_clock::time_point start,
                      std::chrono::steady_clock::time_point end) {
  return std::chrono::duration<double>(end - start).count();
}

}  // namespace

void BuildMonitor::beginPhase(std::string_view name, double share) {
  throwIfStopped();
  endPhase();
  phase_ = name;
  share_ = share;
}

void BuildMonitor::finish() {
  throwIfStopped();
  endPhase();
  report_.peakBytes = memory_.peak();
  if (control_.onProgress)
    control_.onProgress({.phase = report_.phases.back().name, .done = 1.0});
}

void BuildMonitor::endPhase() {
  if (phase_.empty())
    return;
  const Clock::time_point now = Clock::now();
  report_.phases.push_back({phase_, secondsBetween(phaseStart_, now)});
  report_.totalSeconds = secondsBetween(start_, now);
  phaseStart_ = now;
  doneBefore_ += share_;
  doneOfPhase_ = 0.0;
}

void BuildMonitor::throwIfStopped() const {
  if (control_.stopToken.stop_requested() || tbb::is_current_task_group_canceling())
    throw Cancelled();
}

void BuildMonitor::advance(double partOfPhase) {
  throwIfStopped();
  if (!control_.onProgress)
    return;
  double before = doneOfPhase_;
  while (!doneOfPhase_.compare_exchange_weak(before, before + partOfPhase)) {
  }
  const std::unique_lock lock(telling_, std::try_to_lock);
  const Clock::time_point now = Clock::now();
  if (!lock || hasThrown_ || now - lastTold_ < kTellingInterval)
    return;
  lastTold_ = now;
  // Rounding may add up to more than the whole, and the end is told at the end.
  const double done = doneBefore_ + share_ * std::min(doneOfPhase_.load(), 1.0);
  told_ = std::max(told_, std::min(done, kMostBeforeTheEnd));
  hasThrown_ = true;  // unless it returns
  control_.onProgress({.phase = phase_, .done = told_});
  hasThrown_ = false;
}

}  // namespace planetree::detail
