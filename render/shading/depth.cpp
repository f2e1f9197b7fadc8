#include "render/shading/depth.hpp"

#include "render/value_percentile.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace planetree::render {

namespace {

/// The grey of the farthest surface: it must differ from the black of nothing.
constexpr float kFarthestGrey = 0.12f;

/// A thin foreground or a far glimpse must not take the contrast from all the rest.
constexpr double kNearPercentile = 0.001;
constexpr double kFarPercentile = 0.999;

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

FilmSample Depth::shade(RayCounter& tracer, const Rayf& cameraRay,
                        const DirectionPoints& /*directions*/) const noexcept {
  const auto hit = tracer.findIntersection(cameraRay);
  if (!hit)
    return {};
  const float depth = hit->t * dot(cameraRay.direction, viewDirection_);
  return {.value = {depth, 0.0f, 0.0f}, .coverage = 1.0f};
}

DevelopedImage Depth::develop(const Film& film) const {
  Image image(film.size());
  std::vector<float> depths = coveredDepths(film);
  if (depths.empty())
    return {.image = std::move(image), .range = {}};
  const float nearest = valuePercentile(depths, kNearPercentile);
  const float farthest = valuePercentile(depths, kFarPercentile);
  const float span = farthest > nearest ? farthest - nearest : 1.0f;

  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const FilmSample& sample = film.samples()[i];
    if (!(sample.coverage > 0.0f))
      continue;
    const float place = std::clamp((meanDepth(sample) - nearest) / span, 0.0f, 1.0f);
    const float grey = (1.0f - place * (1.0f - kFarthestGrey)) * sample.coverage;
    image.pixels[i] = quantized({grey, grey, grey});
  }
  return {.image = std::move(image),
          .range = ValueRange{.darkest = static_cast<double>(farthest),
                              .brightest = static_cast<double>(nearest)}};
}

}  // namespace planetree::render
