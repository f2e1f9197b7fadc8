#include "render/shading/heat.hpp"

#include "render/colour_map.hpp"
#include "render/value_percentile.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace planetree::render {

namespace {

constexpr double kBrightestPercentile = 0.995;

}  // namespace

FilmSample Heat::shade(RayCounter& tracer, const Rayf& cameraRay,
                       const DirectionPoints& /*directions*/) const noexcept {
  StepCounts steps;
  const bool isHit = tracer.findIntersection(cameraRay, steps).has_value();
  const auto work = static_cast<float>(steps.splitNodes + steps.objects);
  return {.value = {work, 0.0f, 0.0f}, .coverage = isHit ? 1.0f : 0.0f};
}

DevelopedImage Heat::develop(const Film& film) const {
  Image image(film.size());
  std::vector<float> work;
  work.reserve(film.samples().size());
  for (const FilmSample& sample : film.samples())
    work.push_back(sample.value.x);

  // Below one step a ray there is nothing to tell apart; 1 also keeps the division finite.
  const float brightest = std::max(1.0f, valuePercentile(work, kBrightestPercentile));
  const float highest = *std::max_element(work.begin(), work.end());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = quantized(infernoColour(film.samples()[i].value.x / brightest));
  }
  return {.image = std::move(image),
          .range = ValueRange{.darkest = 0.0,
                              .brightest = static_cast<double>(brightest),
                              .highest = static_cast<double>(highest)}};
}

}  // namespace planetree::render
