#pragma once

#include <csignal>
#include <string>

/// How Ctrl-C, SIGTERM and a closed terminal end the tool: at once, whatever it is doing; with one
/// line on standard error; without a half-written file; and by the signal itself, so that a shell
/// shows status 128 + signal and ends the loop that the tool runs in.
///
/// Neither a builder nor a reader is asked again and again whether it should stop: they know
/// nothing of signals, and none of them can be slow to answer. Rendering does ask, as a picture is
/// worth something before it is complete.
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

/// While one exists, the first signal does not end the tool: it is kept for whoever asks, so that
/// what is there can be saved. The second one ends it at once, as usual. One at a time.
class InterruptionDelay {
 public:
  InterruptionDelay() noexcept;
  InterruptionDelay(const InterruptionDelay&) = delete;
  InterruptionDelay& operator=(const InterruptionDelay&) = delete;
  ~InterruptionDelay();
};

/// The signal that was kept; 0 if there is none.
[[nodiscard]] int keptInterruption() noexcept;

/// Ends the tool by the signal that was kept, as if it had come now, with what is to be said in
/// place of the usual line; empty is the usual one. Returns if none was kept.
void endByKeptInterruption(const std::string& line) noexcept;

/// A signal that ends the tool removes this file first; null if there is none. There is one such
/// file at a time. To be called during a pause; the text must live until the next call.
void removeOnInterruption(const char* path) noexcept;

}  // namespace planetree::tool
