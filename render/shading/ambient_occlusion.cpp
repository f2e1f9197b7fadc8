#include "render/shading/ambient_occlusion.hpp"

#include "render/shading/backdrop.hpp"
#include "render/shading/surface_point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planetree::render {

namespace {

/// The part of the scene's diagonal beyond which a surface shades no more. With an infinite reach
/// rooms would be black: every ray in them ends at a wall.
constexpr float kReach = 0.15f;

constexpr Vec3f kClay{0.74f, 0.72f, 0.69f};

// The dome: cool from above, warm from below, and one large soft lamp.
constexpr Vec3f kSkyLight{0.62f, 0.68f, 0.78f};
constexpr Vec3f kGroundLight{0.30f, 0.27f, 0.25f};
constexpr Vec3f kKeyLight{1.30f, 1.18f, 1.00f};

/// What comes from a direction that is blocked: surfaces nearby are lit too and pass some light on.
constexpr Vec3f kBounce{0.085f, 0.075f, 0.070f};

Vec3f product(const Vec3f& a, const Vec3f& b) noexcept {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

}  // namespace

AmbientOcclusion::AmbientOcclusion(const Box3& scene, const CameraAxes& axes, const Vec3f& up,
                                   std::vector<Vec3f> albedos)
    : scene_(scene),
      reach_(kReach * diagonal(scene)),
      up_(normalized(up)),
      keyDirection_(Vec3f(normalized(axes.up * 0.8 - axes.right * 0.65 - axes.forward * 0.55))),
      albedos_(std::move(albedos)) {}

FilmSample AmbientOcclusion::shade(RayCounter& tracer, const Rayf& cameraRay,
                                   const Point2& direction) const noexcept {
  const auto hit = tracer.findIntersection(cameraRay);
  if (!hit)
    return {};
  const Vec3f normal = normalTowardViewer(*hit, cameraRay);
  const Vec3f point = cameraRay.at(hit->t);
  const Rayf shadowRay{.origin = point + normal * surfaceOffset(scene_, point),
                       .direction = cosineDistributed(normal, direction),
                       .tMax = reach_};
  const Vec3f light = tracer.isOccluded(shadowRay) ? kBounce : domeLight(shadowRay.direction);
  return {.value = product(albedo(*hit), light), .coverage = 1.0f};
}

Vec3f AmbientOcclusion::albedo(const Hitf& hit) const noexcept {
  return hit.geometry < albedos_.size() ? albedos_[hit.geometry] : kClay;
}

Vec3f AmbientOcclusion::domeLight(const Vec3f& direction) const noexcept {
  const float height = 0.5f + 0.5f * dot(direction, up_);
  const float towardKey = std::max(0.0f, dot(direction, keyDirection_));
  return kGroundLight * (1.0f - height) + kSkyLight * height +
         kKeyLight * (towardKey * towardKey * towardKey);
}

DevelopedImage AmbientOcclusion::develop(const Film& film) const {
  Image image(film.size());
  for (std::uint32_t y = 0; y < image.size.height; ++y) {
    for (std::uint32_t x = 0; x < image.size.width; ++x) {
      const FilmSample& sample = film.at(x, y);
      const Vec3f light = sample.value + backdrop(image.size, x, y) * (1.0f - sample.coverage);
      image.at(x, y) =
          quantized({srgbEncoded(light.x), srgbEncoded(light.y), srgbEncoded(light.z)});
    }
  }
  return {.image = std::move(image), .range = {}};
}

}  // namespace planetree::render
