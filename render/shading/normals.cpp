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

std::vector<FilmSample> Normals::shade(RayCounter& tracer, const CameraRays& camera) const {
  const std::vector<Hitf> hits = tracer.findIntersections(camera.rays);
  std::vector<FilmSample> samples(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (isSurface(hits[i]))
      samples[i] = {.value = normalTowardViewer(hits[i], camera.rays[i]), .coverage = 1.0f};
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
