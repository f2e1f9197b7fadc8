#pragma once

#include <stdexcept>
#include <string>

namespace planetree::bench {

// How planetree-bench ends.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;

/// The command line asks for something that cannot be; the program ends with `kWrongUsage`.
class UsageError : public std::runtime_error {
 public:
  /// `problem` comes without a full stop; `advice` says what to try, as a sentence.
  UsageError(const std::string& problem, const std::string& advice)
      : std::runtime_error(problem + ". " + advice) {}
};

}  // namespace planetree::bench
