#include "batch/batch_monitor.hpp"

#include <planetree/error.hpp>

#include <algorithm>

namespace planetree::detail {
namespace {

constexpr std::chrono::milliseconds kTellingInterval(20);
constexpr double kMostBeforeTheEnd = 0.999;

}  // namespace

void throwIfStopped(const BatchControl& control) {
  if (control.stopToken.stop_requested())
    throw Cancelled();
}

void BatchMonitor::advance(std::size_t packetCount) {
  throwIfStopped(control_);
  if (!control_.onProgress)
    return;
  doneCount_ += packetCount;
  const std::unique_lock lock(telling_, std::try_to_lock);
  const Clock::time_point now = Clock::now();
  if (!lock || hasThrown_ || now - lastTold_ < kTellingInterval)
    return;
  lastTold_ = now;
  const double done = static_cast<double>(doneCount_) / static_cast<double>(packetCount_);
  told_ = std::max(told_, std::min(done, kMostBeforeTheEnd));
  hasThrown_ = true;  // unless it returns
  control_.onProgress(told_);
  hasThrown_ = false;
}

void BatchMonitor::finish() const {
  if (control_.onProgress)
    control_.onProgress(1.0);
}

}  // namespace planetree::detail
