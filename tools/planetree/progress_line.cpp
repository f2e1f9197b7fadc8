#include "progress_line.hpp"

#include "talk.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <utility>

namespace planetree::tool {

namespace {

/// Steps that are shorter than this show nothing.
constexpr std::chrono::milliseconds kBeforeFirst{1000};
constexpr std::chrono::milliseconds kBetween{200};
constexpr const char* kEraseLine = "\r\x1b[K";
constexpr int kBarWidth = 20;

std::string timeText(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 60)
    return fmt::format("{} s", whole);
  if (whole < 3600)
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

ProgressLine::ProgressLine(std::string step, bool isWanted) : step_(std::move(step)) {
  if (isWanted && ::isatty(STDERR_FILENO) == 1)
    painter_ = std::thread([this] { showUntilEnd(); });
}

ProgressLine::~ProgressLine() {
  if (!painter_.joinable())
    return;
  {
    const std::scoped_lock lock(mutex_);
    hasEnded_ = true;
  }
  endOfStep_.notify_one();
  painter_.join();
}

void ProgressLine::showUntilEnd() {
  std::unique_lock lock(mutex_);
  const auto hasEnded = [this] { return hasEnded_; };
  if (endOfStep_.wait_for(lock, kBeforeFirst, hasEnded))
    return;
  do {
    show();
  } while (!endOfStep_.wait_for(lock, kBetween, hasEnded));
  printToStandardError(kEraseLine);
}

void ProgressLine::show() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  printToStandardError(kEraseLine + progressText(step_, done_, seconds));
}

std::string progressText(const std::string& step, double done, double seconds) {
  if (!(done > 0.0))
    return fmt::format("{}, {:.0f} s", step, std::floor(seconds));
  const int filled = static_cast<int>(std::floor(done * kBarWidth));
  return fmt::format("{} [{:<{}}] {:3.0f} %, {} left", step,
                     std::string(static_cast<std::size_t>(filled), '='), kBarWidth,
                     std::floor(100.0 * done), timeText(seconds * (1.0 - done) / done));
}

}  // namespace planetree::tool
