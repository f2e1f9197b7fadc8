#include "progress_line.hpp"

#include "talk.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <utility>

namespace planetree::tool {

namespace {

constexpr std::chrono::milliseconds kBetweenUpdates{100};
constexpr const char* kEraseLine = "\r\x1b[K";

std::string timeText(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 60)
    return fmt::format("{} s", whole);
  if (whole < 3600)
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

ProgressLine::ProgressLine(std::string step, bool isWanted)
    : step_(std::move(step)), isShown_(isWanted && ::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (isShown_)
    std::fputs(kEraseLine, stderr);
}

void ProgressLine::update(double done) {
  if (!isShown_)
    return;
  // A thread that finds another one printing has nothing newer to say.
  const std::unique_lock lock(mutex_, std::try_to_lock);
  const Clock::time_point now = Clock::now();
  if (!lock || now - lastShown_ < kBetweenUpdates || !(done > 0.0))
    return;
  lastShown_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  printToStandardError(fmt::format("{}{} {:3.0f} %, {} left", kEraseLine, step_,
                                   std::floor(100.0 * done),
                                   timeText(elapsed * (1.0 - done) / done)));
}

}  // namespace planetree::tool
