#pragma once

#include "render/shading/shading.hpp"
#include "scene/build_scene.hpp"

#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace planetree::render {

/// What can be chosen about Whitted's shading.
struct WhittedSettings {
  std::uint32_t depthLimit = 5;  ///< how often a ray may be reflected or refracted; at most 64
  bool isSmooth = true;          ///< normals are interpolated where the corners of a mesh have them
  bool hasShadows = true;
};

/// Turner Whitted, "An improved illumination model for shaded display", CACM 1980: surfaces have
/// the light of the lamps they see, what they mirror, and what they let through. The terms are
/// those of docs/ray_format.md, with shadows in the colour of what the light has passed.
///
/// In contrast to the paper rays are not followed one by one to their end. The light of a sample is
/// a sum over paths, each with the factor that is left of it, so that all rays of one depth can be
/// asked for together; see trace_batch.hpp for what that is worth.
class Whitted final : public Shading {
 public:
  /// The scene must outlive the shading.
  Whitted(const scene::BuiltScene& scene, const WhittedSettings& settings);

  /// The light that comes back along each ray, unclamped. Directions need unit length.
  [[nodiscard]] std::vector<Vec3d> radiance(RayCounter& tracer, std::span<const Rayf> rays) const;

  /// The same for rays whose first hits are known.
  [[nodiscard]] std::vector<Vec3d> radiance(RayCounter& tracer, std::span<const Rayf> rays,
                                            std::span<const Hitf> hits) const;

  [[nodiscard]] std::vector<FilmSample> shade(RayCounter& tracer,
                                              CameraRays& camera) const override;
  [[nodiscard]] Development develop(const Film& film) const override;

 private:
  const scene::BuiltScene& scene_;
  WhittedSettings settings_;
};

}  // namespace planetree::render
