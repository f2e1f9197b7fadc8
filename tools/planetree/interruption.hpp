#pragma once

#include <csignal>

/// How Ctrl-C, SIGTERM and a closed terminal end the tool: at once, whatever it is doing; with one
/// line on standard error; without a half-written file; and by the signal itself, so that a shell
/// shows status 128 + signal and ends the loop that the tool runs in.
///
/// Nothing is asked again and again whether it should stop: neither a builder nor a reader knows of
/// signals, and none of them can be slow to answer.
namespace planetree::tool {

/// Installs the handlers; to be called before there are threads. What the program was started to
/// ignore (nohup, background jobs) it goes on ignoring.
void endOnInterruption() noexcept;

/// While one exists, no signal ends the tool. For short moments in which a file and what
/// `removeOnInterruption` knows of it change together.
class InterruptionPause {
 public:
  InterruptionPause() noexcept;
  InterruptionPause(const InterruptionPause&) = delete;
  InterruptionPause& operator=(const InterruptionPause&) = delete;
  ~InterruptionPause();

 private:
  sigset_t previousMask_ = {};
};

/// A signal that ends the tool removes this file first; null if there is none. There is one such
/// file at a time. To be called during a pause; the text must live until the next call.
void removeOnInterruption(const char* path) noexcept;

}  // namespace planetree::tool
