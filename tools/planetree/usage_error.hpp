#pragma once

#include <stdexcept>
#include <string>

namespace planetree::tool {

/// The command line asks for something that cannot be; the tool ends with status 2.
class UsageError : public std::runtime_error {
 public:
  /// `problem` names the option, without a full stop; `advice` says what to try, as a sentence.
  UsageError(const std::string& problem, const std::string& advice)
      : std::runtime_error(problem + ". " + advice) {}
};

}  // namespace planetree::tool
