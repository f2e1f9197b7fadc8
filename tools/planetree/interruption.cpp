#include "interruption.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>

namespace planetree::tool {

namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

/// Held during a pause, and by the handler until the program has ended. A thread that holds it has
/// all of `kSignals` blocked, so that no handler ever waits for the thread that it has interrupted.
std::atomic_flag isBusy = ATOMIC_FLAG_INIT;

// Guarded by `isBusy`.
const char* fileToRemove = nullptr;

// Set before there are handlers.
pid_t ownProcess = 0;
bool isTerminal = false;

sigset_t signalSet() noexcept {
  sigset_t set;
  ::sigemptyset(&set);
  for (const int signal : kSignals)
    ::sigaddset(&set, signal);
  return set;
}

void acquire() noexcept {
  while (isBusy.test_and_set(std::memory_order_acquire)) {
  }
}

// From here on, only what may be called in a signal handler.

void print(const char* text) noexcept {
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text, std::strlen(text));
}

void end(int signal) {
  // A forked process has its parent's handlers, but neither its files nor its say.
  if (::getpid() == ownProcess) {
    acquire();
    const bool isFileGone = fileToRemove != nullptr && ::unlink(fileToRemove) == 0;
    // The start of the line may hold a progress line, or the ^C that the terminal shows.
    print(isTerminal ? "\r\x1b[Kplanetree: interrupted" : "planetree: interrupted");
    print(isFileGone ? ", and no file was written\n" : "\n");
  }
  struct sigaction usual = {};
  usual.sa_handler = SIG_DFL;
  ::sigaction(signal, &usual, nullptr);
  // Takes effect when the handler returns: until then the signal is blocked.
  ::raise(signal);
}

}  // namespace

void endOnInterruption() noexcept {
  ownProcess = ::getpid();
  isTerminal = ::isatty(STDERR_FILENO) == 1;
  struct sigaction action = {};
  action.sa_handler = &end;
  action.sa_mask = signalSet();
  for (const int signal : kSignals) {
    struct sigaction previous = {};
    ::sigaction(signal, nullptr, &previous);
    if (previous.sa_handler != SIG_IGN)
      ::sigaction(signal, &action, nullptr);
  }
}

InterruptionPause::InterruptionPause() noexcept {
  const sigset_t set = signalSet();
  ::pthread_sigmask(SIG_BLOCK, &set, &previousMask_);
  acquire();
}

InterruptionPause::~InterruptionPause() {
  isBusy.clear(std::memory_order_release);
  ::pthread_sigmask(SIG_SETMASK, &previousMask_, nullptr);
}

void removeOnInterruption(const char* path) noexcept {
  fileToRemove = path;
}

}  // namespace planetree::tool
