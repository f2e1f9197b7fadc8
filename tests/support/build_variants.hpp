#pragma once

#include <planetree/split/build_options.hpp>

#include <string>
#include <utility>
#include <vector>

namespace planetree::test {

/// Options that make very different trees of the same objects, which must give the same answers.
inline std::vector<std::pair<std::string, BuildOptions>> buildVariants() {
  BuildOptions deep;
  deep.leafSize = 1;
  deep.depthLimit = 24;
  deep.stopsByCost = false;
  BuildOptions unclipped;
  unclipped.clipsReferences = false;
  BuildOptions leaf;
  leaf.depthLimit = 1;
  // Costs of faces that make small meshes worth a split.
  BuildOptions fast = BuildOptions::fast();
  fast.cost.faceCost = 0.5;
  BuildOptions high = BuildOptions::high();
  high.cost.faceCost = 0.5;
  return {{"defaults", BuildOptions{}},
          {"fast", fast},
          {"high", high},
          {"textbook", BuildOptions::textbook()},
          {"deep", deep},
          {"unclipped", unclipped},
          {"one leaf", leaf}};
}

}  // namespace planetree::test
