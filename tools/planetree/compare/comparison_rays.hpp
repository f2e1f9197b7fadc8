#pragma once

#include "render/camera.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/geometry/ray.hpp>
#include <planetree/mesh/face.hpp>

#include <cstdint>
#include <vector>

namespace planetree::tool {

/// The rays that trees of one mesh are compared with: the same for all of them.
struct ComparisonRays {
  std::vector<Rayf> primary;  ///< a picture, row by row; the nearest hit is asked for
  /// From each of their hits one, short, as ambient occlusion sends them; any hit.
  std::vector<Rayf> ao;
  std::vector<Rayf> random;  ///< from anywhere to anywhere in the bounds; the nearest hit
};

/// `pictureSize` squared primary and random rays. The tree says where the primary ones end; which
/// one it is makes no difference.
[[nodiscard]] ComparisonRays makeComparisonRays(const KdTree<Face<float>>& tree,
                                                const render::Camera& camera,
                                                std::uint32_t pictureSize);

}  // namespace planetree::tool
