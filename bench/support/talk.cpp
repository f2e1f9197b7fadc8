#include "bench/support/talk.hpp"

#include "bench/support/build_info.hpp"

#include <planetree/traversal/instruction_set.hpp>

#include <fmt/format.h>

#include <cstdio>

namespace planetree::bench {

void say(const std::string& line) {
  fmt::print(stderr, "{}\n", line);
}

void warnOfUnfitMachine() {
  if (buildType() != "Release") {
    say(fmt::format("This is a {} build: its figures mean nothing. Use the preset `release`.",
                    buildType()));
  }
  // The load of this process itself, starting, is not half a thread yet.
  if (loadAverage() > 0.5) {
    say(
        fmt::format("The machine is busy ({:.1f} threads were running): trust only the ratios, or "
                    "end what else runs.",
                    loadAverage()));
  }
}

std::string headLine() {
  return fmt::format("{}; {}; {}; commit {}\n", machine(), activeInstructionSet(), compiler(),
                     commit());
}

}  // namespace planetree::bench
