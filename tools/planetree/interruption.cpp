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

std::atomic<bool> isDelayed = false;
std::atomic<int> keptSignal = 0;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "handlers may use them");

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

void startLine() noexcept {
  // The start of the line may hold a progress line, or the ^C that the terminal shows.
  if (isTerminal)
    print("\r\x1b[K");
}

void endBy(int signal) noexcept {
  struct sigaction usual = {};
  usual.sa_handler = SIG_DFL;
  ::sigaction(signal, &usual, nullptr);
  // In a handler it takes effect when that returns: until then the signal is blocked.
  ::raise(signal);
}

void end(int signal) {
  int none = 0;
  if (isDelayed && keptSignal.compare_exchange_strong(none, signal))
    return;
  // A forked process has its parent's handlers, but neither its files nor its say.
  if (::getpid() == ownProcess) {
    acquire();
    const bool isFileGone = fileToRemove != nullptr && ::unlink(fileToRemove) == 0;
    startLine();
    print("planetree: interrupted");
    print(isFileGone ? ", and no file was written\n" : "\n");
  }
  endBy(signal);
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

InterruptionDelay::InterruptionDelay() noexcept {
  isDelayed = true;
}

InterruptionDelay::~InterruptionDelay() {
  isDelayed = false;
}

int keptInterruption() noexcept {
  return keptSignal;
}

void endByKeptInterruption(const std::string& line) noexcept {
  const int signal = keptSignal;
  if (signal == 0)
    return;
  if (line.empty()) {
    ::raise(signal);
    return;
  }
  startLine();
  print(line.c_str());
  print("\n");
  endBy(signal);
}

void removeOnInterruption(const char* path) noexcept {
  fileToRemove = path;
}

}  // namespace planetree::tool
