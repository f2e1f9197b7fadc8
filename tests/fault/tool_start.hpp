#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Programs with outputs that fail.
namespace planetree::test {

struct OutputStart {
  std::string program;
  std::vector<std::string> arguments;
  std::filesystem::path folder;
  std::optional<std::uint64_t> largestFile = {};  ///< bytes, as on a disk that is nearly full
  std::optional<std::uint64_t> memory = {};       ///< bytes of addresses
  std::vector<int> closedStreams = {};            ///< as by the shell's >&-
  std::filesystem::path standardInput = {};       ///< a file, open to write to as well, as by <>
  std::filesystem::path standardOutput = {};      ///< a file; without one a pipe, which is read
  /// So many bytes of standard output are read before its pipe is closed.
  std::optional<std::size_t> readBytes = {};
  bool ignoresClosedPipes = false;  ///< SIGPIPE, from its start
};

struct OutputResult {
  int status = -1;  ///< exit status; -1 if a signal ended it
  int signal = 0;   ///< the signal that ended it
  std::string out;
  std::string err;
};

/// Runs the program to its end. What it says on standard error goes through a pipe, which no limit
/// of files concerns.
[[nodiscard]] OutputResult run(const OutputStart& start);

}  // namespace planetree::test
