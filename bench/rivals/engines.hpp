#pragma once

#include "bench/rivals/engine.hpp"

#include <memory>
#include <string>
#include <vector>

namespace planetree::bench {

using EngineList = std::vector<std::unique_ptr<Engine>>;

// One function for each library. They are defined only where the library was found.
[[nodiscard]] EngineList planetreeEngines();
[[nodiscard]] EngineList planetreeEnginesByName();
[[nodiscard]] EngineList embree3Engines();
[[nodiscard]] EngineList embree3EnginesForBatches();
[[nodiscard]] EngineList cgalEngines();

/// A library that may take part, and what is known without it.
struct Rival {
  std::string name;
  EngineList (*engines)();   ///< null where the library was not found when this was built
  std::string package;       ///< the Debian package that has it
  bool joinsUnasked = true;  ///< whether it takes part where nobody was named
  /// More modes, each of which takes part only where it is named itself.
  EngineList (*enginesByName)() = nullptr;
  /// Modes that trace several rays at once: they take part in batches with the library, and
  /// elsewhere only where they are named themselves.
  EngineList (*enginesForBatches)() = nullptr;
};

/// planetree first.
[[nodiscard]] const std::vector<Rival>& rivals();

}  // namespace planetree::bench
