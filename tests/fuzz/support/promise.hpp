#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace planetree::fuzz {

/// Ends the program, which is how a target tells what it has found.
[[noreturn]] inline void reportBroken(std::string_view promise, const std::string& details = {}) {
  std::fprintf(stderr, "\nBROKEN PROMISE: %.*s\n%s\n", static_cast<int>(promise.size()),
               promise.data(), details.c_str());
  std::fflush(stderr);
  std::abort();
}

inline void require(bool holds, std::string_view promise) {
  if (!holds)
    reportBroken(promise);
}

/// The same with details, which are made only if it does not hold.
template <class Describe>
void require(bool holds, std::string_view promise, const Describe& describe) {
  if (!holds)
    reportBroken(promise, describe());
}

}  // namespace planetree::fuzz
