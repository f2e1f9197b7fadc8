#include "render/shading/albedo.hpp"

#include "render/shading/surface_point.hpp"

#include <algorithm>
#include <cstddef>

namespace planetree::render {

namespace {

/// The mean over the rays that hit, in linear light, times the part that they are.
Vec3f coveredAlbedo(const FilmSample& sample) noexcept {
  if (!(sample.coverage > 0.0f))
    return {};
  return srgbDecoded(sample.value / sample.coverage) * sample.coverage;
}

Vec3f clampedColour(const Vec3d& colour) noexcept {
  const auto clamped = [](double channel) {
    return static_cast<float>(std::clamp(channel, 0.0, 1.0));
  };
  return {clamped(colour.x), clamped(colour.y), clamped(colour.z)};
}

}  // namespace

Vec3f diffuseColour(const scene::SurfacePoint& surface) noexcept {
  return clampedColour(surface.material.diffuse);
}

Vec3f passedOnColour(const scene::SurfacePoint& surface) noexcept {
  const scene::MaterialSample& material = surface.material;
  return clampedColour(material.diffuse + material.reflective + material.transmissive);
}

std::vector<FilmSample> Albedo::shade(RayCounter& tracer, CameraRays& camera) const {
  const std::vector<Hitf>& hits = camera.hits(tracer);
  std::vector<FilmSample> samples(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (isSurface(hits[i]))
      samples[i] = {.value = diffuseColour(scene_.surface(camera.rays[i], hits[i])),
                    .coverage = 1.0f};
  }
  return samples;
}

Development Albedo::develop(const Film& /*film*/) const {
  const auto channel = [](const char* name, Axis axis) {
    return Measurement{name,
                       [axis](const FilmSample& sample) { return coveredAlbedo(sample)[axis]; },
                       ChannelType::Half};
  };
  return {.light =
              [](const FilmSample& sample) {
                return Light{coveredAlbedo(sample), sample.coverage};
              },
          .hasBackdrop = true,
          .measurements = {channel("albedo.R", Axis::X), channel("albedo.G", Axis::Y),
                           channel("albedo.B", Axis::Z)},
          .range = {}};
}

}  // namespace planetree::render
