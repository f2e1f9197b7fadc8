#include "render/shading/depth.hpp"

#include "render/image.hpp"
#include "render/shading/surface_point.hpp"
#include "render/value_percentile.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace planetree::render {

namespace {

/// The grey of the farthest surface: it must differ from the black of nothing.
constexpr float kFarthestGrey = 0.12f;

/// A thin foreground or a far glimpse must not take the contrast from all the rest.
constexpr double kNearPercentile = 0.001;
constexpr double kFarPercentile = 0.999;

/// The depth of a pixel that shows no surface.
constexpr float kNowhere = std::numeric_limits<float>::infinity();

float meanDepth(const FilmSample& sample) noexcept {
  return sample.value.x / sample.coverage;
}

std::vector<float> coveredDepths(const Film& film) {
  std::vector<float> depths;
  for (const FilmSample& sample : film.samples()) {
    if (sample.coverage > 0.0f)
      depths.push_back(meanDepth(sample));
  }
  return depths;
}

}  // namespace

std::vector<FilmSample> Depth::shade(RayCounter& tracer, CameraRays& camera) const {
  const std::vector<Hitf>& hits = camera.hits(tracer);
  std::vector<FilmSample> samples(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!isSurface(hits[i]))
      continue;
    const float depth = hits[i].t * dot(camera.rays[i].direction, viewDirection_);
    samples[i] = {.value = {depth, 0.0f, 0.0f}, .coverage = 1.0f};
  }
  return samples;
}

Development Depth::develop(const Film& film) const {
  std::vector<float> depths = coveredDepths(film);
  const Measurement depth{"Z", [](const FilmSample& sample) {
                            return sample.coverage > 0.0f ? meanDepth(sample) : kNowhere;
                          }};
  if (depths.empty()) {
    return {
        .light = [](const FilmSample&) { return Light{}; }, .measurements = {depth}, .range = {}};
  }
  const float nearest = valuePercentile(depths, kNearPercentile);
  const float farthest = valuePercentile(depths, kFarPercentile);
  const ValueRange range{
      .darkest = static_cast<double>(farthest),
      .brightest = static_cast<double>(nearest),
      .lowest = static_cast<double>(*std::min_element(depths.begin(), depths.end())),
      .mean = meanValue(depths),
      .highest = static_cast<double>(*std::max_element(depths.begin(), depths.end()))};
  const auto grey = [nearest, span = farthest > nearest ? farthest - nearest
                                                        : 1.0f](const FilmSample& sample) -> Light {
    if (!(sample.coverage > 0.0f))
      return {};
    const float place = std::clamp((meanDepth(sample) - nearest) / span, 0.0f, 1.0f);
    const float shown = srgbDecoded(1.0f - place * (1.0f - kFarthestGrey)) * sample.coverage;
    return {{shown, shown, shown}, sample.coverage};
  };
  return {.light = grey, .measurements = {depth}, .range = range};
}

}  // namespace planetree::render
