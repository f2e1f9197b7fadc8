#include "render/shading/ambient_occlusion.hpp"
#include "render/shading/depth.hpp"
#include "render/shading/heat.hpp"
#include "render/shading/normals.hpp"
#include "render/shading/surface_point.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/shape/shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace planetree::render {
namespace {

template <Object O>
std::unique_ptr<Tracer> tracerOf(std::vector<O> objects) {
  return std::make_unique<TreeTracer<O>>(buildTree(std::move(objects)));
}

/// A floor of edge 2 at y = 0.
std::unique_ptr<Tracer> floorTracer() {
  return tracerOf(
      std::vector<Square<float>>{{.edgeU = {2.0f, 0.0f, 0.0f}, .edgeV = {0.0f, 0.0f, 2.0f}}});
}

/// The room between -1 and 1, from inside.
std::unique_ptr<Tracer> roomTracer() {
  return tracerOf(
      std::vector<Box<float>>{{.lower = {-1.0f, -1.0f, -1.0f}, .upper = {1.0f, 1.0f, 1.0f}}});
}

/// What one ray sees.
FilmSample shade(const Shading& shading, RayCounter& tracer, const Rayf& ray,
                 const DirectionPoints& directions = {}) {
  CameraRays camera{.rays = {ray}, .directions = {directions}};
  return shading.shade(tracer, camera).front();
}

constexpr Rayf kDownward{.origin = {0.1f, 1.0f, 0.2f}, .direction = {0.0f, -1.0f, 0.0f}};
constexpr Rayf kUpward{.origin = {0.1f, 0.5f, 0.2f}, .direction = {0.0f, 1.0f, 0.0f}};

AmbientOcclusion ambientOcclusion(const Tracer& tracer) {
  const Vec3f up{0.0f, 1.0f, 0.0f};
  return {tracer.bounds(), cameraAxes({0.0, -1.0, -1.0}, Vec3d(up)), up, {{1.0f, 1.0f, 1.0f}}};
}

/// The light that 64 rays see on the same spot.
float meanLight(const AmbientOcclusion& shading, const Tracer& tracer, const Rayf& ray) {
  const SamplePoints points(64, 0);
  RayCounter counter(tracer);
  float sum = 0.0f;
  for (std::uint32_t i = 0; i < 64; ++i) {
    sum += shade(shading, counter, ray, points.at(0, 0, i).directions).value.y;
  }
  return sum / 64.0f;
}

TEST(AmbientOcclusion, AnOpenFloorShadesNothing) {
  const auto tracer = floorTracer();
  const AmbientOcclusion shading = ambientOcclusion(*tracer);
  RayCounter counter(*tracer);
  const float once = shade(shading, counter, kDownward).value.y;
  EXPECT_NEAR(meanLight(shading, *tracer, kDownward), once, 1e-6f);
}

TEST(AmbientOcclusion, CornersAreDarkerThanOpenPlaces) {
  const auto tracer = roomTracer();
  const AmbientOcclusion shading = ambientOcclusion(*tracer);
  const float middle = meanLight(shading, *tracer, kDownward);
  Rayf corner = kDownward;
  corner.origin = {0.95f, 0.5f, 0.95f};
  EXPECT_LT(meanLight(shading, *tracer, corner), 0.6f * middle);
}

TEST(AmbientOcclusion, TriesDirectionsFromSurfacesOnly) {
  const auto tracer = floorTracer();
  const AmbientOcclusion shading = ambientOcclusion(*tracer);
  RayCounter counter(*tracer);
  EXPECT_EQ(shade(shading, counter, kDownward).coverage, 1.0f);
  EXPECT_EQ(counter.rayCount(), 1 + kDirectionsPerSample);
  EXPECT_EQ(shade(shading, counter, kUpward).coverage, 0.0f);
  EXPECT_EQ(counter.rayCount(), 2 + kDirectionsPerSample);
}

TEST(AmbientOcclusion, GeometriesWithoutAColourAreOfClay) {
  const auto tracer = floorTracer();
  const Vec3f up{0.0f, 1.0f, 0.0f};
  const CameraAxes axes = cameraAxes({0.0, -1.0, -1.0}, Vec3d(up));
  const AmbientOcclusion red(tracer->bounds(), axes, up, {{1.0f, 0.0f, 0.0f}});
  const AmbientOcclusion clay(tracer->bounds(), axes, up, {});
  RayCounter counter(*tracer);
  EXPECT_EQ(shade(red, counter, kDownward).value.y, 0.0f);
  EXPECT_GT(shade(clay, counter, kDownward).value.y, 0.0f);
}

TEST(Normals, FaceTheViewerFromEitherSide) {
  const auto tracer = floorTracer();
  RayCounter counter(*tracer);
  const Vec3f above = shade(Normals(), counter, kDownward).value;
  EXPECT_EQ(above, (Vec3f{0.0f, 1.0f, 0.0f}));
  Rayf fromBelow = kUpward;
  fromBelow.origin.y = -1.0f;
  EXPECT_EQ(shade(Normals(), counter, fromBelow).value, (Vec3f{0.0f, -1.0f, 0.0f}));
}

Film filmOf(const std::vector<FilmSample>& samples) {
  Film film({static_cast<std::uint32_t>(samples.size()), 1});
  for (std::uint32_t x = 0; x < samples.size(); ++x)
    film.at(x, 0) = samples[x];
  return film;
}

FilmSample valueSample(float value, float coverage) {
  return {.value = {value * coverage, 0.0f, 0.0f}, .coverage = coverage};
}

/// The pixels of a one-row film, as they are shown.
std::vector<Rgb8> shown(const Development& development, const Film& film) {
  std::vector<Rgb8> pixels;
  for (const FilmSample& sample : film.samples())
    pixels.push_back(quantized(srgbEncoded(development.light(sample).colour)));
  return pixels;
}

/// What is measured in the first pixel of a film.
float measured(const Development& development, const std::string& channel, const Film& film) {
  for (const Measurement& measurement : development.measurements) {
    if (measurement.channel == channel)
      return measurement.value(film.at(0, 0));
  }
  ADD_FAILURE() << "nothing is measured as " << channel;
  return 0.0f;
}

TEST(Normals, AreShownAroundTheMiddleOfTheColoursAndMeasuredAsTheyAre) {
  const Film film =
      filmOf({{.value = {0.0f, 1.0f, 0.0f}, .coverage = 1.0f}, {.value = {}, .coverage = 0.0f}});
  const Development development = Normals().develop(film);
  EXPECT_EQ(shown(development, film)[0], (Rgb8{128, 255, 128}));
  EXPECT_EQ(development.light(film.at(1, 0)).alpha, 0.0f);
  EXPECT_EQ(measured(development, "N.X", film), 0.0f);
  EXPECT_EQ(measured(development, "N.Y", film), 1.0f);
  EXPECT_EQ(measured(development, "N.Z", film), 0.0f);
}

TEST(Normals, OfPartlyCoveredPixelsAreThoseOfWhatCoversThem) {
  const Film film = filmOf({{.value = {0.0f, 0.0f, -0.5f}, .coverage = 0.5f}});
  EXPECT_EQ(measured(Normals().develop(film), "N.Z", film), -1.0f);
}

TEST(Depth, IsMeasuredAlongTheViewDirection) {
  const auto tracer = floorTracer();
  RayCounter counter(*tracer);
  const Rayf slanted{.origin = {0.0f, 0.5f, 0.0f}, .direction = {0.6f, -0.8f, 0.0f}};
  const FilmSample sample = shade(Depth({0.0f, -1.0f, 0.0f}), counter, slanted);
  EXPECT_NEAR(sample.value.x, 0.5f, 1e-6f);
}

TEST(Depth, NearIsWhiteFarIsDarkAndNothingIsBlack) {
  const Film film =
      filmOf({valueSample(2.0f, 1.0f), valueSample(3.0f, 1.0f), valueSample(4.0f, 1.0f), {}});
  const Development development = Depth({}).develop(film);
  const std::vector<Rgb8> pixels = shown(development, film);
  EXPECT_EQ(pixels[0].red, 255);
  EXPECT_LT(pixels[1].red, 255);
  EXPECT_LT(pixels[2].red, pixels[1].red);
  EXPECT_GT(pixels[2].red, 0);
  EXPECT_EQ(pixels[3].red, 0);
  ASSERT_TRUE(development.range);
  EXPECT_EQ(development.range->brightest, 2.0);
  EXPECT_EQ(development.range->darkest, 4.0);
  EXPECT_EQ(development.range->lowest, 2.0);
  EXPECT_EQ(development.range->mean, 3.0);
  EXPECT_EQ(development.range->highest, 4.0);
}

TEST(Depth, APartlyCoveredPixelHasTheDepthOfWhatCoversIt) {
  const Film film = filmOf({valueSample(2.0f, 0.5f), valueSample(2.0f, 1.0f), {}});
  const Development development = Depth({}).develop(film);
  EXPECT_EQ(measured(development, "Z", film), 2.0f);
  EXPECT_EQ(development.light(film.at(0, 0)).colour, (Vec3f{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(development.light(film.at(0, 0)).alpha, 0.5f);
}

TEST(Depth, APictureOfNothingIsBlackInfinitelyFarAndHasNoRange) {
  const Film film = filmOf({{}, {}});
  const Development development = Depth({}).develop(film);
  EXPECT_EQ(shown(development, film)[0], Rgb8{});
  EXPECT_EQ(measured(development, "Z", film), std::numeric_limits<float>::infinity());
  EXPECT_FALSE(development.range);
}

TEST(Heat, CountsSplitNodesAndObjects) {
  std::vector<Sphere<float>> spheres;
  for (int i = 0; i < 100; ++i) {
    spheres.push_back({.center = {static_cast<float>(i), 0.0f, 0.0f}, .radius = 0.3f});
  }
  const auto tree = buildTree(std::move(spheres));
  const TreeTracer<Sphere<float>> tracer(tree);
  const Rayf ray{.origin = {-5.0f, 0.1f, 0.0f}, .direction = {1.0f, 0.0f, 0.0f}};
  StepCounts steps;
  const bool isHit = tree.findIntersection(ray, steps).has_value();
  ASSERT_TRUE(isHit);
  ASSERT_GT(steps.splitNodes, 0u);
  RayCounter counter(tracer);
  const Film film = filmOf({shade(Heat(), counter, ray)});
  const Development development = Heat().develop(film);
  EXPECT_EQ(measured(development, "steps.splitNodes", film), static_cast<float>(steps.splitNodes));
  EXPECT_EQ(measured(development, "steps.leafNodes", film), static_cast<float>(steps.leafNodes));
  EXPECT_EQ(measured(development, "steps.objects", film), static_cast<float>(steps.objects));
  EXPECT_EQ(measured(development, "steps", film),
            static_cast<float>(steps.splitNodes + steps.objects));
}

FilmSample stepSample(float splitNodes, float objects) {
  return {.value = {splitNodes, 0.0f, objects}};
}

TEST(Heat, RaysThatMissShowTheirWorkToo) {
  const Film film = filmOf({{}, stepSample(30.0f, 20.0f), stepSample(0.0f, 100.0f)});
  const Development development = Heat().develop(film);
  EXPECT_EQ(shown(development, film),
            (std::vector<Rgb8>{{0x00, 0x00, 0x04}, {0xBB, 0x37, 0x54}, {0xFC, 0xFF, 0xA4}}));
  for (const FilmSample& sample : film.samples())
    EXPECT_EQ(development.light(sample).alpha, 1.0f);
  ASSERT_TRUE(development.range);
  EXPECT_EQ(development.range->brightest, 100.0);
  EXPECT_EQ(development.range->lowest, 0.0);
  EXPECT_EQ(development.range->mean, 50.0);
  EXPECT_EQ(development.range->highest, 100.0);
}

TEST(Heat, ItsScaleEndsAtANumberOfTwoDigits) {
  for (const auto& [highest, end] : {std::pair{0.0f, 1.0},
                                     {0.5f, 1.0},
                                     {7.2f, 8.0},
                                     {88.3f, 89.0},
                                     {100.0f, 100.0},
                                     {101.0f, 110.0},
                                     {1234.0f, 1300.0}}) {
    const Film film = filmOf({stepSample(highest, 0.0f)});
    EXPECT_EQ(Heat().develop(film).range->brightest, end) << highest;
  }
}

TEST(Heat, AGivenScaleIsKeptWhateverThePictureHas) {
  for (const float highest : {10.0f, 400.0f}) {
    const Film film = filmOf({stepSample(10.0f, 0.0f), stepSample(highest, 0.0f)});
    const Development development = Heat(20.0).develop(film);
    EXPECT_EQ(development.range->brightest, 20.0);
    EXPECT_EQ(shown(development, film)[0], (Rgb8{0xBB, 0x37, 0x54})) << highest;
  }
}

TEST(SurfaceOffset, GrowsWithTheSceneAndWithTheDistanceFromTheOrigin) {
  const Box3 small{.lower = {0.0f, 0.0f, 0.0f}, .upper = {1.0f, 0.0f, 0.0f}};
  const Box3 large{.lower = {0.0f, 0.0f, 0.0f}, .upper = {100.0f, 0.0f, 0.0f}};
  EXPECT_GT(surfaceOffset(small, {}), 0.0f);
  EXPECT_NEAR(surfaceOffset(large, {}), 100.0f * surfaceOffset(small, {}), 1e-6f);
  const Vec3f far{1e5f, 0.0f, 0.0f};
  EXPECT_NE(far.x + surfaceOffset(small, far), far.x) << "lost in rounding";
}

}  // namespace
}  // namespace planetree::render
