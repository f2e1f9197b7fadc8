#pragma once

#include <string>

namespace planetree::bench {

/// One line to standard error.
void say(const std::string& line);

/// Says so if the figures of this build, or of this machine at this moment, mean little.
void warnOfUnfitMachine();

/// What was measured, on what, as a line above tables.
[[nodiscard]] std::string headLine();

}  // namespace planetree::bench
