#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planetree::importing {

/// A program whose standard output comes through a pipe. It is a new process image, not a copy of
/// ours made by `fork`: the threads of oneTBB may be running, and in a copy of one thread the locks
/// that the others held stay locked for ever. Only calls that are safe in a signal handler are
/// allowed there, and a reader of models is far from it. A fresh image also has none of our memory,
/// file descriptors, signal handlers and environment.
class ReaderProcess {
 public:
  /// Starts the program. Throws `std::system_error` if that fails.
  ReaderProcess(const std::filesystem::path& program, std::vector<std::string> arguments);
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;
  /// Kills the program if it is still there.
  ~ReaderProcess();

  /// The end of the pipe to read from.
  [[nodiscard]] int output() const noexcept { return output_; }

  /// Closes the pipe, waits for the program to end, and kills it if it has not done so within
  /// `patience`. Returns the signal that ended it, if one did before that.
  std::optional<int> finish(std::chrono::milliseconds patience) noexcept;

 private:
  int output_ = -1;
  pid_t pid_ = -1;
};

}  // namespace planetree::importing
