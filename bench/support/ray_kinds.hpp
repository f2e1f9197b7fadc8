#pragma once

#include "bench/scene/scene_objects.hpp"
#include "render/camera.hpp"

#include <planetree/geometry/ray.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

/// The rays that everything is measured with. They are a function of the objects and the camera
/// alone: the same on every machine but for the rounding of sine, cosine and tangent, and for any
/// engine, since planetree's own tree says where the primary rays end.
///
/// All have unit directions and tMin = 0.
namespace planetree::bench {

enum class RayKind : std::uint8_t {
  /// A pinhole picture in row order; nearest hit.
  Primary,
  /// From the hit of each primary ray one cosine-distributed ray, in the order of the pixels, as
  /// long as 15 % of the diagonal of the scene; any hit.
  AmbientOcclusion,
  /// From the hit of each primary ray one cosine-distributed ray without end, in the order of the
  /// pixels; nearest hit.
  Diffuse,
  /// Origins uniform in the bounds enlarged by 5 % to each side, directions uniform; nearest hit.
  Random,
};

inline constexpr std::array kRayKinds = {RayKind::Primary, RayKind::AmbientOcclusion,
                                         RayKind::Diffuse, RayKind::Random};

/// "primary", "ao", "diffuse", "random".
[[nodiscard]] std::string_view rayKindName(RayKind kind) noexcept;

/// Whether the rays only ask if there is a hit.
[[nodiscard]] constexpr bool asksForAnyHit(RayKind kind) noexcept {
  return kind == RayKind::AmbientOcclusion;
}

struct RaySet {
  RayKind kind = RayKind::Primary;
  std::vector<Rayf> rays;
  /// Pixels to a row where the rays are those of a picture, row by row; 0 where they are not.
  std::size_t pictureWidth = 0;
};

/// How many rays there are: primary ones are `pictureSize` squared, `ao` and `diffuse` ones as many
/// as of them hit.
struct RayCounts {
  std::size_t pictureSize = 1024;
  std::size_t randomCount = 1'000'000;
};

/// The rays of each kind asked for, in that order. Where no object can be hit there are no rays of
/// the kinds that start on one.
[[nodiscard]] std::vector<RaySet> makeRaySets(const SceneObjects& objects,
                                              const render::Camera& camera,
                                              const std::vector<RayKind>& kinds,
                                              const RayCounts& counts);

}  // namespace planetree::bench
