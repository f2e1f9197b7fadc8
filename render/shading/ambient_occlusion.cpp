#include "render/shading/ambient_occlusion.hpp"

#include "render/image.hpp"
#include "render/shading/albedo.hpp"
#include "render/shading/surface_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace planetree::render {

namespace {

/// The part of the scene's diagonal beyond which a surface shades no more. With an infinite reach
/// rooms would be black: every ray in them ends at a wall.
constexpr float kReach = 0.15f;

constexpr Vec3f kClay{0.71f, 0.68f, 0.64f};

// The dome: cool from above, warm from below, and one large soft lamp.
constexpr Vec3f kSkyLight{0.21f, 0.27f, 0.37f};
constexpr Vec3f kGroundLight{0.10f, 0.085f, 0.075f};
constexpr Vec3f kKeyLight{1.46f, 1.34f, 1.18f};

/// The part of the light that reaches a point from blocked directions all the same: surfaces nearby
/// are lit too and pass some of it on.
constexpr float kBounce = 0.16f;

Vec3f product(const Vec3f& a, const Vec3f& b) noexcept {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

}  // namespace

AmbientOcclusion::AmbientOcclusion(const Box3& bounds, const CameraAxes& axes, const Vec3f& up,
                                   std::vector<Vec3f> albedos)
    : bounds_(bounds),
      reach_(kReach * diagonal(bounds)),
      up_(normalized(up)),
      keyDirection_(Vec3f(normalized(axes.up * 0.75 - axes.right * 0.8 - axes.forward * 0.3))),
      albedos_(std::move(albedos)) {}

AmbientOcclusion::AmbientOcclusion(const scene::BuiltScene& scene, const CameraAxes& axes,
                                   const Vec3f& up)
    : AmbientOcclusion(scene.tree().bounds(), axes, up, {}) {
  scene_ = &scene;
}

std::vector<FilmSample> AmbientOcclusion::shade(RayCounter& tracer, CameraRays& camera) const {
  const std::vector<Hitf>& hits = camera.hits(tracer);
  const std::vector<std::uint8_t> areBlocked = tracer.areOccluded(raysFromSurfaces(camera, hits));
  auto isBlocked = areBlocked.begin();
  std::vector<FilmSample> samples(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!isSurface(hits[i]))
      continue;
    float open = 0.0f;
    for (std::uint32_t k = 0; k < kDirectionsPerSample; ++k)
      open += *isBlocked++ != 0 ? kBounce : 1.0f;
    open /= static_cast<float>(kDirectionsPerSample);
    const Vec3f light = openLight(normalTowardViewer(hits[i], camera.rays[i]));
    samples[i] = {.value = product(albedo(camera.rays[i], hits[i]), light) * open,
                  .coverage = 1.0f};
  }
  return samples;
}

std::vector<Rayf> AmbientOcclusion::raysFromSurfaces(const CameraRays& camera,
                                                     const std::vector<Hitf>& hits) const {
  std::vector<Rayf> rays;
  rays.reserve(hits.size() * kDirectionsPerSample);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!isSurface(hits[i]))
      continue;
    const Vec3f normal = normalTowardViewer(hits[i], camera.rays[i]);
    const Vec3f point = camera.rays[i].at(hits[i].t);
    const Vec3f origin = point + normal * surfaceOffset(bounds_, point);
    for (const Point2& direction : camera.directions[i])
      rays.push_back(
          {.origin = origin, .direction = cosineDistributed(normal, direction), .tMax = reach_});
  }
  return rays;
}

Vec3f AmbientOcclusion::albedo(const Rayf& ray, const Hitf& hit) const {
  if (scene_ != nullptr)
    return srgbDecoded(passedOnColour(scene_->surface(ray, hit)));
  return hit.geometry < albedos_.size() ? albedos_[hit.geometry] : kClay;
}

Vec3f AmbientOcclusion::openLight(const Vec3f& normal) const noexcept {
  // The dome is sky or ground by (1 + d.up) / 2 and a lamp of ((1 + d.key) / 2)^2 for a direction
  // d. With d distributed by the cosine around n, the mean of d.k is 2/3 n.k and that of (d.k)^2 is
  // 1/4 + 1/4 (n.k)^2.
  const float height = 0.5f + dot(normal, up_) / 3.0f;
  const float c = dot(normal, keyDirection_);
  const float key = (1.25f + (4.0f / 3.0f) * c + 0.25f * c * c) / 4.0f;
  return kGroundLight * (1.0f - height) + kSkyLight * height + kKeyLight * key;
}

Development AmbientOcclusion::develop(const Film& /*film*/) const {
  const auto light = [](const FilmSample& sample) { return Light{sample.value, sample.coverage}; };
  return {.light = light, .hasBackdrop = true, .measurements = {}, .range = {}};
}

}  // namespace planetree::render
