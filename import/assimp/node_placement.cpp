#include "import/assimp/node_placement.hpp"

#include "import/assimp/items.hpp"

namespace planetree::importing {

std::vector<PlacedNode> placedNodes(const aiScene& scene) {
  struct Visit {
    const aiNode* node;
    Placement parent;
  };
  std::vector<PlacedNode> nodes;
  std::vector<Visit> visits;
  if (scene.mRootNode)
    visits.push_back({scene.mRootNode, Placement()});
  while (!visits.empty()) {
    const Visit visit = visits.back();
    visits.pop_back();
    const Placement placement = visit.parent.of(Placement(visit.node->mTransformation));
    nodes.push_back({visit.node, placement});
    // The last one first: the visits then come in the order of the file.
    const auto children = items(visit.node->mChildren, visit.node->mNumChildren);
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
      if (*child)
        visits.push_back({*child, placement});
    }
  }
  return nodes;
}

}  // namespace planetree::importing
