#include "bench/rivals/select_engines.hpp"

#include "bench/usage_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace planetree::bench {

namespace {

bool isNamed(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether a library takes part: nobody was named, or it was, alone or with one of its modes.
bool takesPart(const Rival& rival, const std::vector<std::string>& names) {
  if (names.empty())
    return rival.joinsUnasked;
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return name == rival.name || name.starts_with(rival.name + ":");
  });
}

std::string howToGet(const Rival& rival) {
  return fmt::format(
      "{} was not found when this was built. Run scripts/bench.sh, which installs it "
      "and builds anew.",
      rival.package);
}

}  // namespace

std::string fullName(const Engine& engine) {
  return engine.name() + ":" + engine.mode();
}

EngineList selectEngines(const std::vector<std::string>& names, bool withPackets) {
  EngineList selected;
  std::set<std::string> known;
  for (const Rival& rival : rivals()) {
    known.insert(rival.name);
    if (!rival.engines) {
      if (!names.empty() && takesPart(rival, names))
        throw std::runtime_error(fmt::format("{}: {}", rival.name, howToGet(rival)));
      continue;
    }
    const bool isWhole = names.empty() ? rival.joinsUnasked : isNamed(names, rival.name);
    const auto select = [&](EngineList (*engines)(), bool joinsWithTheLibrary) {
      for (auto& engine : engines ? engines() : EngineList{}) {
        const std::string full = fullName(*engine);
        known.insert(full);
        if ((isWhole && joinsWithTheLibrary) || isNamed(names, full))
          selected.push_back(std::move(engine));
      }
    };
    select(rival.engines, true);
    select(rival.enginesByName, false);
    select(rival.enginesForBatches, withPackets);
  }
  for (const std::string& name : names) {
    if (!known.contains(name)) {
      throw UsageError(fmt::format("--engines: there is no {}", name),
                       fmt::format("Known are {}.", fmt::join(known, ", ")));
    }
  }
  return selected;
}

std::vector<std::string> whoIsMissing(const std::vector<std::string>& names) {
  std::vector<std::string> lines;
  for (const Rival& rival : rivals()) {
    if (!rival.engines && names.empty() && rival.joinsUnasked)
      lines.push_back(fmt::format("{} is left out: {}", rival.name, howToGet(rival)));
  }
  return lines;
}

}  // namespace planetree::bench
