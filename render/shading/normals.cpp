#include "render/shading/normals.hpp"

#include "render/image.hpp"
#include "render/shading/surface_point.hpp"

#include <cstddef>
#include <vector>

namespace planetree::render {

namespace {

/// The mean over the rays that hit something.
Vec3f meanNormal(const FilmSample& sample) noexcept {
  return sample.coverage > 0.0f ? sample.value / sample.coverage : Vec3f{};
}

Light normalColour(const FilmSample& sample) noexcept {
  const Vec3f half{0.5f, 0.5f, 0.5f};
  return {srgbDecoded(half + 0.5f * meanNormal(sample)) * sample.coverage, sample.coverage};
}

}  // namespace

std::vector<FilmSample> Normals::shade(RayCounter& tracer, CameraRays& camera) const {
  const std::vector<Hitf>& hits = camera.hits(tracer);
  std::vector<FilmSample> samples(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!isSurface(hits[i]))
      continue;
    Vec3f normal = normalTowardViewer(hits[i], camera.rays[i]);
    if (scene_ != nullptr) {
      const Vec3f shaded(scene_->surface(camera.rays[i], hits[i]).normal);
      // The side is that of the face: near an outline an interpolated normal may look away.
      normal = dot(shaded, normal) < 0.0f ? -shaded : shaded;
    }
    samples[i] = {.value = normal, .coverage = 1.0f};
  }
  return samples;
}

Development Normals::develop(const Film& /*film*/) const {
  return {.light = &normalColour,
          .hasBackdrop = true,
          .measurements = {{"N.X", [](const FilmSample& sample) { return meanNormal(sample).x; }},
                           {"N.Y", [](const FilmSample& sample) { return meanNormal(sample).y; }},
                           {"N.Z", [](const FilmSample& sample) { return meanNormal(sample).z; }}},
          .range = {}};
}

}  // namespace planetree::render
