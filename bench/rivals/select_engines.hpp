#pragma once

#include "bench/rivals/engines.hpp"

#include <string>
#include <vector>

/// Who takes part, by the names on the command line: of libraries, or of modes like
/// "embree3:high-robust". Without names, all libraries that join unasked do.
namespace planetree::bench {

/// "embree3:high-robust"
[[nodiscard]] std::string fullName(const Engine& engine);

/// `withPackets` says that modes for batches take part with their library. Throws `UsageError` for
/// an unknown name, and `std::runtime_error` for that of a library that was not found.
[[nodiscard]] EngineList selectEngines(const std::vector<std::string>& names, bool withPackets);

/// A line for each library that would take part, but was not found.
[[nodiscard]] std::vector<std::string> whoIsMissing(const std::vector<std::string>& names);

}  // namespace planetree::bench
