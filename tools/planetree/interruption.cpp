#include "interruption.hpp"

#include <atomic>

namespace planetree::tool {

namespace {

std::atomic<bool> isSignalled = false;
static_assert(std::atomic<bool>::is_always_lock_free, "or a signal handler may not write it");

void remember(int /*signal*/) {
  isSignalled = true;
}

}  // namespace

Interruption::Interruption() noexcept {
  isSignalled = false;
  struct sigaction action = {};
  action.sa_handler = &remember;
  ::sigaction(SIGINT, &action, &previousInterrupt_);
  ::sigaction(SIGTERM, &action, &previousTerminate_);
  // A program that was started to ignore Ctrl-C (nohup, a background job) goes on ignoring it.
  if (previousInterrupt_.sa_handler == SIG_IGN)
    ::sigaction(SIGINT, &previousInterrupt_, nullptr);
}

Interruption::~Interruption() {
  ::sigaction(SIGINT, &previousInterrupt_, nullptr);
  ::sigaction(SIGTERM, &previousTerminate_, nullptr);
}

bool Interruption::isRequested() const noexcept {
  return isSignalled;
}

}  // namespace planetree::tool
