#pragma once

#include <string>

/// What was measured, and on what.
namespace planetree::bench {

/// The commit that planetree was built from, with "-dirty" if its sources had changes; "unknown"
/// outside of a git checkout.
[[nodiscard]] std::string commit();

/// "g++ 12.2.0".
[[nodiscard]] std::string compiler();

/// CMake's build type; anything but Release is no basis for figures.
[[nodiscard]] std::string buildType();

/// "AMD EPYC, 2 threads, Linux 6.1".
[[nodiscard]] std::string machine();

/// How many threads were running or waiting to run, on average over the last minute; below zero if
/// the system does not say.
[[nodiscard]] double loadAverage();

/// The threads that the machine runs at a time, at least 1.
[[nodiscard]] unsigned hardwareThreads();

}  // namespace planetree::bench
