#pragma once

#include <csignal>

namespace planetree::tool {

/// While one exists, Ctrl-C and SIGTERM do not end the program but are remembered, so that work can
/// stop in order. There may be one at a time.
class Interruption {
 public:
  Interruption() noexcept;
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  [[nodiscard]] bool isRequested() const noexcept;

 private:
  struct sigaction previousInterrupt_ = {};
  struct sigaction previousTerminate_ = {};
};

}  // namespace planetree::tool
