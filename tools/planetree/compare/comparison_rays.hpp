#pragma once

#include "render/camera.hpp"
#include "render/tracer.hpp"

#include <planetree/geometry/ray.hpp>

#include <cstdint>
#include <vector>

namespace planetree::tool {

/// The rays that trees of one subject are compared with: the same for all of them.
struct ComparisonRays {
  std::vector<Rayf> primary;  ///< a picture, row by row; the nearest hit is asked for
  /// From each of their hits one, short, as ambient occlusion sends them; any hit.
  std::vector<Rayf> ao;
  std::vector<Rayf> random;  ///< from anywhere to anywhere in the bounds; the nearest hit
};

/// `pictureSize` squared primary and random rays. The tree says where the primary ones end; which
/// one it is makes no difference.
[[nodiscard]] ComparisonRays makeComparisonRays(const render::Tracer& tracer,
                                                const render::PinholeCamera& camera,
                                                std::uint32_t pictureSize);

}  // namespace planetree::tool
