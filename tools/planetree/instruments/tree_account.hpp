#pragma once

#include <planetree/geometry/box3.hpp>
#include <planetree/node/tree_statistics.hpp>
#include <planetree/split/build_report.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planetree::tool {

/// A model and its tree, as `planetree info` shows them.
struct TreeAccount {
  std::string model;   ///< the path as it was given
  std::string format;  ///< "OBJ"
  std::uint64_t vertexCount = 0;
  std::uint64_t triangleCount = 0;                ///< those that were read
  std::uint64_t polygonCount = 0;                 ///< of the file, those that were skipped included
  std::uint64_t skippedPolygonCount = 0;          ///< not read
  std::vector<std::string> skippedPolygons = {};  ///< the first few, with reasons
  std::vector<std::string> skippedTriangles = {};  ///< read, but not in the tree; likewise
  std::uint64_t unreadPrimitiveCount = 0;          ///< points, lines and curves of the file
  std::uint64_t tooLargeCount = 0;                 ///< coordinates that became infinite
  std::vector<std::string> remarks = {};           ///< of the reader, the first few
  double readSeconds = 0.0;
  Box3 bounds = {};
  BuildReport build = {};
  TreeStatistics tree = {};
  std::string_view instructionSet = {};  ///< that queries use, out of those below
  std::span<const std::string_view> supportedInstructionSets = {};

  [[nodiscard]] std::uint64_t objectCount() const noexcept {
    return build.objectCount - build.skippedCount;
  }
  [[nodiscard]] double perObject(std::uint64_t count) const noexcept {
    return objectCount() > 0 ? static_cast<double>(count) / static_cast<double>(objectCount())
                             : 0.0;
  }
  /// Objects in a leaf that is not empty, on average.
  [[nodiscard]] double meanLeafSize() const noexcept {
    const std::uint64_t leafCount = tree.leafNodeCount - tree.emptyLeafCount;
    return leafCount > 0 ? static_cast<double>(tree.referenceCount) / static_cast<double>(leafCount)
                         : 0.0;
  }
};

}  // namespace planetree::tool
