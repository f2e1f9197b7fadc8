#pragma once

#include <planetree/node/node_layout.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/traversal/query_options.hpp>

#include "support/byte_stream.hpp"

#include <array>
#include <cmath>

namespace planetree::fuzz {

/// Build options of all kinds, most of which the library takes.
[[nodiscard]] inline BuildOptions takeBuildOptions(ByteStream& input) noexcept {
  const std::array presets = {BuildOptions::balanced(), BuildOptions::fast(), BuildOptions::high(),
                              BuildOptions::textbook()};
  BuildOptions options = presets[input.takeBelow(4)];
  options.threadCount = 1;
  const std::uint8_t changes = input.takeByte();
  if ((changes & 1u) != 0)
    options.leafSize = input.takeByte();
  if ((changes & 2u) != 0)
    options.depthLimit = input.takeBelow(kMaxTreeDepth + 3);
  if ((changes & 4u) != 0) {
    const std::uint8_t rules = input.takeByte();
    options.stopsByCost = (rules & 1u) != 0;
    options.allowsEmptyCells = (rules & 2u) != 0;
    options.clipsReferences = (rules & 4u) != 0;
    options.exactPlanes = (rules & 8u) != 0;
    options.retractsSplits = (rules & 16u) != 0;
    options.planarRule = (rules & 32u) != 0 ? PlanarRule::CheaperSide : PlanarRule::NormalSign;
  }
  if ((changes & 8u) != 0)
    options.referencesPerObject = input.takeByte();
  if ((changes & 16u) != 0)
    options.cost.faceCost = options.cost.intersectionCost = input.takeByte() / 64.0;
  if ((changes & 32u) != 0)
    options.cost.traversalCost = input.takeByte() / 64.0;
  if ((changes & 64u) != 0)
    options.cost.emptyBonus = input.takeByte() / 255.0;
  if ((changes & 128u) != 0) {
    // Any bits at all.
    CostModel& cost = options.cost;
    double* const members[] = {&cost.traversalCost, &cost.intersectionCost, &cost.faceCost,
                               &cost.emptyBonus};
    double& member = *members[input.takeBelow(4)];
    member = input.take<double>();
  }
  return options;
}

/// Whether the library says that it takes them.
[[nodiscard]] inline bool areValid(const BuildOptions& options) noexcept {
  const auto isCost = [](double cost) { return cost >= 0.0 && std::isfinite(cost); };
  const CostModel& cost = options.cost;
  return (!options.depthLimit ||
          (*options.depthLimit >= 1 && *options.depthLimit <= kMaxTreeDepth)) &&
         isCost(cost.traversalCost) && isCost(cost.intersectionCost) && isCost(cost.faceCost) &&
         cost.emptyBonus >= 0.0 && cost.emptyBonus < 1.0;
}

[[nodiscard]] inline QueryOptions takeQueryOptions(ByteStream& input) noexcept {
  QueryOptions options;
  const std::uint8_t choices = input.takeByte();
  options.cullsBackFaces = (choices & 1u) != 0;
  options.crossings = (choices & 2u) != 0;
  if ((choices & 4u) != 0)
    options.skip = {.geometry = 0, .primitive = input.takeByte()};
  if ((choices & 8u) != 0)
    options.mask = input.takeByte();
  return options;
}

}  // namespace planetree::fuzz
