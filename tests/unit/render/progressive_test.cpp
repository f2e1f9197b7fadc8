#include "scene_pictures.hpp"

#include "render/still_life.hpp"

#include <planetree/build_tree.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

/// Pictures that come piece by piece, in part, or not to their end.
namespace planetree::test {
namespace {

using render::FilmSample;
using render::ImageSize;
using render::PixelWindow;
using render::Rendering;
using render::RenderMode;
using render::RenderSettings;
using render::SampleGrid;

constexpr RenderMode kModes[] = {
    RenderMode::AmbientOcclusion, RenderMode::Normals, RenderMode::Depth, RenderMode::Heat,
    RenderMode::Whitted,          RenderMode::Albedo};

const ScenePicture& manyShapesPicture() {
  static const ScenePicture picture(manyShapes(60, 3));
  return picture;
}

/// Whether one film is a part of another, bit by bit.
testing::AssertionResult isPart(const Rendering& part, const Rendering& whole) {
  for (std::uint32_t y = 0; y < part.window.size.height; ++y) {
    for (std::uint32_t x = 0; x < part.window.size.width; ++x) {
      const FilmSample& a = part.film.at(x, y);
      const FilmSample& b = whole.film.at(part.window.x + x, part.window.y + y);
      if (a.value != b.value || a.coverage != b.coverage)
        return testing::AssertionFailure() << "pixel " << x << ", " << y;
    }
  }
  return testing::AssertionSuccess();
}

RenderSettings settingsFor(RenderMode mode) {
  RenderSettings settings = manyShapesPicture().settings({70, 50}, mode);
  settings.samplesPerPixel = 7;
  if (mode == RenderMode::Whitted)
    settings.grid = SampleGrid{.side = 3, .threshold = 0.1f};
  else
    settings.grid = {};
  return settings;
}

Rendering renderShapes(const RenderSettings& settings) {
  return renderImage(manyShapesPicture().tracer, settings);
}

TEST(ProgressiveRendering, EndsWithTheVerySamePicture) {
  for (const RenderMode mode : kModes) {
    RenderSettings settings = settingsFor(mode);
    const Rendering atOnce = renderShapes(settings);
    settings.isProgressive = true;
    settings.threadCount = 3;
    const Rendering inPasses = renderShapes(settings);
    EXPECT_TRUE(isPart(inPasses, atOnce));
    EXPECT_EQ(inPasses.rayCount, atOnce.rayCount);
    EXPECT_TRUE(inPasses.isComplete);
    EXPECT_EQ(inPasses.done, 1.0);
  }
}

TEST(RenderImage, IsTheSameForAnyNumberOfThreadsInEveryModeOfAScene) {
  for (const RenderMode mode : kModes) {
    RenderSettings settings = settingsFor(mode);
    settings.threadCount = 1;
    const Rendering one = renderShapes(settings);
    settings.threadCount = 4;
    EXPECT_TRUE(isPart(renderShapes(settings), one));
  }
}

TEST(Crop, HasTheVeryPixelsOfTheWholePicture) {
  for (const RenderMode mode : kModes) {
    RenderSettings settings = settingsFor(mode);
    const Rendering whole = renderShapes(settings);
    for (const PixelWindow& window : {PixelWindow{.x = 0, .y = 0, .size = {20, 10}},
                                      PixelWindow{.x = 23, .y = 17, .size = {1, 1}},
                                      PixelWindow{.x = 31, .y = 12, .size = {39, 38}}}) {
      settings.crop = window;
      const Rendering part = renderShapes(settings);
      EXPECT_EQ(part.film.size(), window.size);
      EXPECT_TRUE(isPart(part, whole));
      EXPECT_LT(part.rayCount, whole.rayCount);
    }
  }
}

TEST(Crop, ShowsThePixelsThatTheWholePictureShows) {
  RenderSettings settings = settingsFor(RenderMode::AmbientOcclusion);
  settings.cellDepth = 3;
  const render::Image whole = shownImage(renderShapes(settings));
  settings.crop = PixelWindow{.x = 11, .y = 5, .size = {30, 20}};
  const render::Image part = shownImage(renderShapes(settings));
  for (std::uint32_t y = 0; y < 20; ++y) {
    for (std::uint32_t x = 0; x < 30; ++x)
      ASSERT_EQ(part.at(x, y), whole.at(11 + x, 5 + y));
  }
}

TEST(Previews, AreWholePicturesOfTheSamplesSoFar) {
  RenderSettings settings = settingsFor(RenderMode::AmbientOcclusion);
  settings.isProgressive = true;
  settings.previewSeconds = 0.0;
  settings.threadCount = 2;
  std::atomic<int> atOnce = 0;
  int count = 0;
  double lastDone = 0.0;
  settings.onPreview = [&](const Rendering& preview) {
    EXPECT_EQ(++atOnce, 1);
    ++count;
    EXPECT_FALSE(preview.isComplete);
    EXPECT_EQ(preview.film.size(), settings.size);
    EXPECT_GT(preview.done, 0.0);
    EXPECT_GE(preview.done, lastDone);
    lastDone = preview.done;
    --atOnce;
  };
  const Rendering rendering = renderShapes(settings);
  EXPECT_GT(count, 1);
  settings.onPreview = {};
  EXPECT_TRUE(isPart(renderShapes(settings), rendering));
}

TEST(Previews, ComeInTheirIntervalAndNotOtherwise) {
  RenderSettings settings = settingsFor(RenderMode::Normals);
  settings.previewSeconds = 3600.0;
  settings.onPreview = [](const Rendering&) { FAIL(); };
  EXPECT_TRUE(renderShapes(settings).isComplete);
}

TEST(StoppedRendering, HasWholeTilesAndNothingElsewhere) {
  RenderSettings settings = settingsFor(RenderMode::Normals);
  settings.size = {160, 160};
  const Rendering whole = renderShapes(settings);
  settings.threadCount = 1;
  settings.keepsGoing = [](double done) { return done < 0.4; };
  const Rendering stopped = renderShapes(settings);
  EXPECT_FALSE(stopped.isComplete);
  EXPECT_GT(stopped.done, 0.2);
  EXPECT_LT(stopped.done, 0.5);
  std::size_t equal = 0;
  for (std::size_t i = 0; i < whole.film.samples().size(); ++i) {
    const FilmSample& sample = stopped.film.samples()[i];
    if (sample.value == whole.film.samples()[i].value)
      ++equal;
    else
      EXPECT_EQ(sample.coverage, 0.0f) << i;
  }
  EXPECT_GT(equal, whole.film.samples().size() / 5);
}

TEST(StoppedRendering, HasAllPixelsIfItIsProgressive) {
  const Vec3f white{1.0f, 1.0f, 1.0f};
  const ScenePicture picture(halfPlane(6.0));
  RenderSettings settings = picture.settings({64, 64});
  settings.grid = SampleGrid{.side = 8};
  settings.isProgressive = true;
  settings.keepsGoing = [](double done) { return done < 0.3; };
  const Rendering stopped = renderImage(picture.tracer, settings);
  EXPECT_FALSE(stopped.isComplete);
  for (const FilmSample& sample : stopped.film.samples()) {
    EXPECT_EQ(sample.value, white);
    EXPECT_EQ(sample.coverage, 1.0f);
  }
}

TEST(SampleGrid, IsThatOfTheRayFormat) {
  // Pixel (i, j) of w x h, from the lower left: x = i / w + k / (n w), y = j / h + l / (n h).
  constexpr std::uint32_t kSide = 3;
  const SampleGrid grid{.side = kSide};
  std::uint32_t sample = 0;
  for (std::uint32_t l = 0; l < kSide; ++l) {
    for (std::uint32_t k = 0; k < kSide; ++k) {
      const render::Point2 point = gridPoint(grid, sample++);
      EXPECT_DOUBLE_EQ(point.x, k / 3.0);
      EXPECT_DOUBLE_EQ(point.y, 1.0 - l / 3.0);
    }
  }
  EXPECT_EQ(sample, grid.samplesPerPixel());
}

/// The part of a pixel's samples that lie left of an edge at `edge` pixels from the left.
float partLeftOf(double edge, std::uint32_t x, std::uint32_t side) {
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < side; ++k)
    count += x + k / static_cast<double>(side) < edge ? 1 : 0;
  return static_cast<float>(count) / static_cast<float>(side);
}

TEST(AdaptiveAntialiasing, SamplesAnEdgeAndNothingElse) {
  constexpr std::uint32_t kWidth = 20;
  constexpr std::uint32_t kSide = 8;
  // In pixels from the left; the edge falls between two samples of a pixel.
  constexpr double kEdge = 7.7;
  const ScenePicture picture(halfPlane(kEdge / kWidth - 0.5));
  RenderSettings settings = picture.settings({kWidth, 10});
  settings.grid = SampleGrid{.side = kSide, .threshold = 0.5f};
  const Rendering rendering = renderImage(picture.tracer, settings);
  for (std::uint32_t y = 0; y < 10; ++y) {
    for (std::uint32_t x = 0; x < kWidth; ++x)
      EXPECT_NEAR(rendering.film.at(x, y).value.x, partLeftOf(kEdge, x, kSide), 1e-6f) << x;
  }
  // Pixels 7 and 8 differ from each other.
  EXPECT_EQ(rendering.rayCount, 10 * (kWidth + 2 * (kSide * kSide - 1)));
}

TEST(AdaptiveAntialiasing, WithoutAThresholdEveryPixelHasAllSamples) {
  const ScenePicture picture(halfPlane(0.01));
  RenderSettings settings = picture.settings({16, 8});
  settings.grid = SampleGrid{.side = 4};
  EXPECT_EQ(renderImage(picture.tracer, settings).rayCount, 16u * 8u * 16u);
}

TEST(AdaptiveAntialiasing, DifferencesUpToTheThresholdAreLeft) {
  scene::SceneDescription description = halfPlane(0.01);
  description.materials.front().emissive.value = {0.0, 0.25, 0.0};
  const ScenePicture picture(description);
  RenderSettings settings = picture.settings({16, 8});
  settings.grid = SampleGrid{.side = 4, .threshold = 0.25f};
  EXPECT_EQ(renderImage(picture.tracer, settings).rayCount, 16u * 8u);
  settings.grid->threshold = 0.249f;
  EXPECT_GT(renderImage(picture.tracer, settings).rayCount, 16u * 8u);
}

TEST(RenderImage, TellsWhereTheTimeGoes) {
  const Rendering rendering = renderShapes(settingsFor(RenderMode::Whitted));
  EXPECT_GT(rendering.tracingSeconds, 0.0);
  EXPECT_GT(rendering.shadingSeconds, 0.0);
  const double threads = std::max(1u, std::thread::hardware_concurrency());
  EXPECT_LE(rendering.tracingSeconds + rendering.shadingSeconds, threads * rendering.seconds);
}

const std::vector<float>& channel(const render::ChannelImage& image, const std::string& name) {
  static const std::vector<float> none;
  for (const render::Channel& channel : image.channels) {
    if (channel.name == name)
      return channel.values;
  }
  ADD_FAILURE() << name;
  return none;
}

TEST(Layers, OfWhittedAreAlbedoNormalAndDepthOfTheFirstHit) {
  scene::SceneDescription description = halfPlane(-0.05);
  description.materials.front().diffuse.value = {0.5, 1.0, 0.0};
  const ScenePicture picture(description);
  RenderSettings settings = picture.settings({4, 4});
  settings.hasLayers = true;
  const Rendering rendering = renderImage(picture.tracer, settings);
  EXPECT_EQ(rendering.rayCount, 16u) << "first hits are traced once";
  const render::ChannelImage image = channelImage(rendering);
  for (std::size_t i = 0; i < 16; ++i) {
    const bool isSeen = i % 4 < 2;
    EXPECT_EQ(channel(image, "R")[i], isSeen ? 1.0f : 0.0f);
    EXPECT_FLOAT_EQ(channel(image, "albedo.R")[i], isSeen ? render::srgbDecoded(0.5f) : 0.0f);
    EXPECT_FLOAT_EQ(channel(image, "albedo.G")[i], isSeen ? 1.0f : 0.0f);
    EXPECT_EQ(channel(image, "albedo.B")[i], 0.0f);
    EXPECT_EQ(channel(image, "N.X")[i], 0.0f);
    EXPECT_EQ(channel(image, "N.Z")[i], isSeen ? 1.0f : 0.0f);
    EXPECT_FLOAT_EQ(channel(image, "Z")[i], isSeen ? 1.0f : std::numeric_limits<float>::infinity());
  }
}

TEST(Layers, AreNotThereUnlessTheyAreWanted) {
  const ScenePicture picture(halfPlane(0.0));
  const Rendering rendering = renderImage(picture.tracer, picture.settings({4, 4}));
  EXPECT_EQ(channelImage(rendering).channels.size(), 4u);
}

TEST(ChannelImage, OfWhittedIsInLinearLightAndShownAsItIs) {
  scene::SceneDescription description = halfPlane(6.0);
  description.materials.front().emissive.value = {0.5, 0.25, 2.0};
  const ScenePicture picture(description);
  const Rendering rendering = renderImage(picture.tracer, picture.settings({2, 2}));
  EXPECT_EQ(shownImage(rendering).at(0, 0), (render::Rgb8{128, 64, 255}));
  const render::ChannelImage image = channelImage(rendering);
  EXPECT_FLOAT_EQ(channel(image, "R")[0], render::srgbDecoded(0.5f));
  EXPECT_FLOAT_EQ(channel(image, "B")[0], 1.0f);
}

TEST(Albedo, IsTheDiffuseColourInFrontOfTheBackdrop) {
  scene::SceneDescription description = halfPlane(0.0);
  description.materials.front().diffuse.value = {0.2, 0.6, 1.0};
  const ScenePicture picture(description);
  const Rendering rendering =
      renderImage(picture.tracer, picture.settings({4, 4}, RenderMode::Albedo));
  EXPECT_EQ(shownImage(rendering).at(0, 0), (render::Rgb8{51, 153, 255}));
  EXPECT_EQ(rendering.film.at(3, 0).coverage, 0.0f);
}

TEST(AmbientOcclusion, HasTheColoursOfAScene) {
  scene::SceneDescription description = halfPlane(6.0);
  description.materials.front().diffuse.value = {1.0, 0.0, 0.0};
  const ScenePicture picture(description);
  const Rendering rendering =
      renderImage(picture.tracer, picture.settings({4, 4}, RenderMode::AmbientOcclusion));
  EXPECT_GT(rendering.film.at(1, 1).value.x, 0.1f);
  EXPECT_EQ(rendering.film.at(1, 1).value.y, 0.0f);
}

TEST(AmbientOcclusion, ShowsTheShapesOfMirrorsAndGlass) {
  scene::SceneDescription description = halfPlane(6.0);
  description.materials.front().diffuse.value = {0.0, 0.0, 0.0};
  description.materials.front().reflective.value = {0.8, 0.0, 0.0};
  description.materials.front().transmissive.value = {0.0, 0.8, 0.0};
  const ScenePicture picture(description);
  const Rendering rendering =
      renderImage(picture.tracer, picture.settings({4, 4}, RenderMode::AmbientOcclusion));
  EXPECT_GT(rendering.film.at(1, 1).value.x, 0.1f);
  EXPECT_GT(rendering.film.at(1, 1).value.y, 0.1f);
  EXPECT_EQ(rendering.film.at(1, 1).value.z, 0.0f);
}

TEST(PinholeCamera, OfAViewTakesItsAxesAsTheyAre) {
  const scene::View view{
      .eye = {1, 2, 3}, .look = {0.5, 0.1, -2}, .u = {3, 0.5, 0}, .v = {0.1, 1.5, 0.2}};
  const render::PinholeCamera camera(view);
  for (const double x : {0.0, 0.3, 1.0}) {
    for (const double y : {0.0, 0.6, 1.0}) {
      const Rayf ray = camera.ray(x, 1.0 - y);
      EXPECT_NEAR(length(Vec3d(ray.direction) - view.direction(x, y)), 0.0, 1e-6);
      const Vec3d seen =
          camera.viewCoordinates(view.eye + (view.look + view.u * (x - 0.5) + view.v * (y - 0.5)));
      EXPECT_NEAR(seen.x / seen.z, 2.0 * x - 1.0, 1e-12);
      EXPECT_NEAR(seen.y / seen.z, 2.0 * y - 1.0, 1e-12);
      EXPECT_NEAR(seen.z, length(view.look), 1e-12);
    }
  }
  EXPECT_NEAR(length(camera.axes().right), 1.0, 1e-12);
}

}  // namespace
}  // namespace planetree::test
