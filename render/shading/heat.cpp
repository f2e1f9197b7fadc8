#include "render/shading/heat.hpp"

#include "render/colour_map.hpp"
#include "render/image.hpp"
#include "render/value_percentile.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace planetree::render {

namespace {

constexpr double kBrightestPercentile = 0.995;

// Where a sample keeps its counts.

float splitNodes(const FilmSample& sample) noexcept {
  return sample.value.x;
}
float leafNodes(const FilmSample& sample) noexcept {
  return sample.value.y;
}
float objects(const FilmSample& sample) noexcept {
  return sample.value.z;
}

/// What the colours show.
float steps(const FilmSample& sample) noexcept {
  return splitNodes(sample) + objects(sample);
}

/// The next number that two digits can write: the ends of a scale are to be read.
double roundedUp(double value) noexcept {
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(value)) - 1.0));
  return std::ceil(value / unit) * unit;
}

/// Below one step a ray there is nothing to tell apart; 1 also keeps the division finite.
double chosenBrightest(std::vector<float> values) {
  return roundedUp(
      std::max(1.0, static_cast<double>(valuePercentile(values, kBrightestPercentile))));
}

}  // namespace

// Ray by ray: only so does a search count the nodes of the tree as the user knows them.
std::vector<FilmSample> Heat::shade(RayCounter& tracer, CameraRays& camera) const {
  std::vector<FilmSample> samples;
  samples.reserve(camera.rays.size());
  for (const RayCounter::CountedSearch& search : tracer.countSteps(camera.rays)) {
    const StepCounts& counts = search.steps;
    samples.push_back(
        {.value = {static_cast<float>(counts.splitNodes), static_cast<float>(counts.leafNodes),
                   static_cast<float>(counts.objects)},
         .coverage = search.isHit ? 1.0f : 0.0f});
  }
  return samples;
}

Development Heat::develop(const Film& film) const {
  std::vector<float> values;
  values.reserve(film.samples().size());
  for (const FilmSample& sample : film.samples())
    values.push_back(steps(sample));

  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const ValueRange range{.darkest = 0.0,
                         .brightest = brightest_ ? *brightest_ : chosenBrightest(values),
                         .lowest = static_cast<double>(*lowest),
                         .mean = meanValue(values),
                         .highest = static_cast<double>(*highest)};
  const auto light = [brightest = static_cast<float>(range.brightest)](const FilmSample& sample) {
    return Light{srgbDecoded(infernoColour(steps(sample) / brightest)), 1.0f};
  };
  return {.light = light,
          .measurements = {{"steps", &steps},
                           {"steps.splitNodes", &splitNodes},
                           {"steps.leafNodes", &leafNodes},
                           {"steps.objects", &objects}},
          .range = range};
}

}  // namespace planetree::render
