#include "render/shading/ambient_occlusion.hpp"
#include "render/shading/depth.hpp"
#include "render/shading/heat.hpp"
#include "render/shading/normals.hpp"
#include "render/shading/surface_point.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/shape/shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
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
    sum += shading.shade(counter, ray, points.at(0, 0, i).directions).value.y;
  }
  return sum / 64.0f;
}

TEST(AmbientOcclusion, AnOpenFloorShadesNothing) {
  const auto tracer = floorTracer();
  const AmbientOcclusion shading = ambientOcclusion(*tracer);
  RayCounter counter(*tracer);
  const float once = shading.shade(counter, kDownward, {}).value.y;
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
  EXPECT_EQ(shading.shade(counter, kDownward, {}).coverage, 1.0f);
  EXPECT_EQ(counter.rayCount(), 1 + kDirectionsPerSample);
  EXPECT_EQ(shading.shade(counter, kUpward, {}).coverage, 0.0f);
  EXPECT_EQ(counter.rayCount(), 2 + kDirectionsPerSample);
}

TEST(AmbientOcclusion, GeometriesWithoutAColourAreOfClay) {
  const auto tracer = floorTracer();
  const Vec3f up{0.0f, 1.0f, 0.0f};
  const CameraAxes axes = cameraAxes({0.0, -1.0, -1.0}, Vec3d(up));
  const AmbientOcclusion red(tracer->bounds(), axes, up, {{1.0f, 0.0f, 0.0f}});
  const AmbientOcclusion clay(tracer->bounds(), axes, up, {});
  RayCounter counter(*tracer);
  EXPECT_EQ(red.shade(counter, kDownward, {}).value.y, 0.0f);
  EXPECT_GT(clay.shade(counter, kDownward, {}).value.y, 0.0f);
}

TEST(Normals, FaceTheViewerFromEitherSide) {
  const auto tracer = floorTracer();
  RayCounter counter(*tracer);
  const Vec3f above = Normals().shade(counter, kDownward, {}).value;
  EXPECT_EQ(above, (Vec3f{0.5f, 1.0f, 0.5f}));
  Rayf fromBelow = kUpward;
  fromBelow.origin.y = -1.0f;
  EXPECT_EQ(Normals().shade(counter, fromBelow, {}).value, (Vec3f{0.5f, 0.0f, 0.5f}));
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

TEST(Depth, IsMeasuredAlongTheViewDirection) {
  const auto tracer = floorTracer();
  RayCounter counter(*tracer);
  const Rayf slanted{.origin = {0.0f, 0.5f, 0.0f}, .direction = {0.6f, -0.8f, 0.0f}};
  const FilmSample sample = Depth({0.0f, -1.0f, 0.0f}).shade(counter, slanted, {});
  EXPECT_NEAR(sample.value.x, 0.5f, 1e-6f);
}

TEST(Depth, NearIsWhiteFarIsDarkAndNothingIsBlack) {
  const DevelopedImage developed = Depth({}).develop(
      filmOf({valueSample(2.0f, 1.0f), valueSample(3.0f, 1.0f), valueSample(4.0f, 1.0f), {}}));
  const std::vector<Rgb8>& pixels = developed.image.pixels;
  EXPECT_EQ(pixels[0].red, 255);
  EXPECT_LT(pixels[1].red, 255);
  EXPECT_LT(pixels[2].red, pixels[1].red);
  EXPECT_GT(pixels[2].red, 0);
  EXPECT_EQ(pixels[3].red, 0);
  ASSERT_TRUE(developed.range);
  EXPECT_EQ(developed.range->brightest, 2.0);
  EXPECT_EQ(developed.range->darkest, 4.0);
}

TEST(Depth, APartlyCoveredPixelHasTheDepthOfWhatCoversIt) {
  const DevelopedImage developed =
      Depth({}).develop(filmOf({valueSample(2.0f, 1.0f), valueSample(2.0f, 0.5f), {}}));
  EXPECT_EQ(developed.image.pixels[1].red, 128);
}

TEST(Depth, APictureOfNothingIsBlackAndHasNoRange) {
  const DevelopedImage developed = Depth({}).develop(filmOf({{}, {}}));
  EXPECT_EQ(developed.image.pixels[0], Rgb8{});
  EXPECT_FALSE(developed.range);
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
  EXPECT_EQ(Heat().shade(counter, ray, {}).value.x,
            static_cast<float>(steps.splitNodes + steps.objects));
}

TEST(Heat, RaysThatMissShowTheirWorkToo) {
  const DevelopedImage developed =
      Heat().develop(filmOf({{}, {.value = {50.0f, 0.0f, 0.0f}}, valueSample(100.0f, 1.0f)}));
  EXPECT_EQ(developed.image.pixels[0], (Rgb8{0x00, 0x00, 0x04}));
  EXPECT_EQ(developed.image.pixels[1], (Rgb8{0xBB, 0x37, 0x54}));
  EXPECT_EQ(developed.image.pixels[2], (Rgb8{0xFC, 0xFF, 0xA4}));
  ASSERT_TRUE(developed.range);
  EXPECT_EQ(developed.range->brightest, 100.0);
  EXPECT_EQ(developed.range->highest, 100.0);
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
