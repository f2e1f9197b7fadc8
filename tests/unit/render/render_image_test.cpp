#include "render/render_image.hpp"

#include "render/still_life.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/shape/shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace planetree::render {
namespace {

TreeTracer<Sphere<float>> sphereTracer() {
  return TreeTracer<Sphere<float>>(buildTree(std::vector<Sphere<float>>{{.radius = 1.0f}}));
}

RenderSettings sphereSettings() {
  return {.size = {40, 30}, .camera = {.eye = {0.0f, 0.0f, 4.0f}}, .samplesPerPixel = 4};
}

constexpr RenderMode kModes[] = {RenderMode::AmbientOcclusion, RenderMode::Normals,
                                 RenderMode::Depth, RenderMode::Heat};

TEST(RenderImage, IsTheSameForAnyNumberOfThreads) {
  const auto tracer = sphereTracer();
  for (const RenderMode mode : kModes) {
    RenderSettings settings = sphereSettings();
    settings.mode = mode;
    settings.threadCount = 1;
    const auto one = renderImage(tracer, settings);
    settings.threadCount = 5;
    const auto five = renderImage(tracer, settings);
    ASSERT_TRUE(one.isComplete && five.isComplete);
    EXPECT_EQ(shownImage(one).pixels, shownImage(five).pixels);
    EXPECT_EQ(one.rayCount, five.rayCount);
  }
}

TEST(RenderImage, CountsEveryRay) {
  const auto tracer = sphereTracer();
  RenderSettings settings = sphereSettings();
  settings.mode = RenderMode::Normals;
  EXPECT_EQ(renderImage(tracer, settings).rayCount, 40u * 30u * 4u);
}

TEST(RenderImage, ShowsTheSphereInTheMiddleAndTheBackdropAround) {
  const auto tracer = sphereTracer();
  RenderSettings settings = sphereSettings();
  settings.mode = RenderMode::Normals;
  const Image image = shownImage(renderImage(tracer, settings));
  const Rgb8 middle = image.at(20, 15);
  EXPECT_NEAR(middle.red, 128, 8);
  EXPECT_NEAR(middle.green, 128, 8);
  EXPECT_GT(middle.blue, 250);
  const Rgb8 corner = image.at(0, 0);
  EXPECT_NEAR(corner.red, corner.blue, 20);
  EXPECT_GT(corner.red, 150);
}

TEST(RenderImage, StopsWhenItIsToldTo) {
  const auto tracer = sphereTracer();
  RenderSettings settings = sphereSettings();
  settings.size = {400, 300};
  std::atomic<int> calls = 0;
  settings.keepsGoing = [&](double) { return ++calls < 10; };
  EXPECT_FALSE(renderImage(tracer, settings).isComplete);
  EXPECT_LT(calls, 10 + 400 * 300 / 16) << "it went on";
}

TEST(RenderImage, ReportsProgressUpToTheEnd) {
  const auto tracer = sphereTracer();
  RenderSettings settings = sphereSettings();
  settings.threadCount = 1;
  std::vector<double> reports;
  settings.keepsGoing = [&](double done) {
    reports.push_back(done);
    return true;
  };
  EXPECT_TRUE(renderImage(tracer, settings).isComplete);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_EQ(reports.back(), 1.0);
}

TEST(RenderImage, ATreeWithoutObjectsGivesABackdrop) {
  const TreeTracer<Sphere<float>> tracer{KdTree<Sphere<float>>()};
  for (const RenderMode mode : kModes) {
    RenderSettings settings = sphereSettings();
    settings.mode = mode;
    EXPECT_TRUE(renderImage(tracer, settings).isComplete);
  }
}

const Channel& channelNamed(const ChannelImage& image, const std::string& name) {
  const auto found = std::find_if(image.channels.begin(), image.channels.end(),
                                  [&](const Channel& channel) { return channel.name == name; });
  EXPECT_NE(found, image.channels.end()) << name;
  return *found;
}

TEST(ChannelImage, HasTheVeryNumbersOfTheFilm) {
  const auto tracer = sphereTracer();
  RenderSettings settings = sphereSettings();
  settings.mode = RenderMode::Heat;
  const Rendering rendering = renderImage(tracer, settings);
  const ChannelImage image = channelImage(rendering);
  EXPECT_EQ(image.size, settings.size);
  const std::vector<float>& objects = channelNamed(image, "steps.objects").values;
  ASSERT_EQ(objects.size(), rendering.film.samples().size());
  for (std::size_t i = 0; i < objects.size(); ++i)
    EXPECT_EQ(objects[i], rendering.film.samples()[i].value.z);
}

TEST(ChannelImage, IsThePictureWithoutItsBackdrop) {
  const auto tracer = sphereTracer();
  const Rendering rendering = renderImage(tracer, sphereSettings());
  const ChannelImage image = channelImage(rendering);
  const std::size_t corner = 0;
  for (const char* name : {"R", "G", "B", "A"})
    EXPECT_EQ(channelNamed(image, name).values[corner], 0.0f) << name;
  const std::size_t middle = 15 * 40 + 20;
  EXPECT_EQ(channelNamed(image, "A").values[middle], 1.0f);
  EXPECT_EQ(quantized(srgbEncoded({channelNamed(image, "R").values[middle],
                                   channelNamed(image, "G").values[middle],
                                   channelNamed(image, "B").values[middle]})),
            shownImage(rendering).at(20, 15));
}

TEST(RenderImage, CellsChangeThePictureButNotTheFilm) {
  const auto tracer = sphereTracer();
  RenderSettings settings = sphereSettings();
  const Rendering plain = renderImage(tracer, settings);
  settings.cellDepth = 1;
  const Rendering withCells = renderImage(tracer, settings);
  EXPECT_NE(shownImage(plain).pixels, shownImage(withCells).pixels);
  for (std::size_t i = 0; i < plain.film.samples().size(); ++i)
    EXPECT_EQ(plain.film.samples()[i].value, withCells.film.samples()[i].value);
  EXPECT_EQ(withCells.rayCount, plain.rayCount + 4 * settings.size.pixelCount());
}

TEST(StillLife, HasAColourForEveryGeometryAndLosesNoObject) {
  const StillLife stillLife = makeStillLife();
  EXPECT_EQ(stillLife.albedos.size(), stillLife.scene.geometryCount());
  const auto tree = buildTree(stillLife.scene);
  EXPECT_EQ(tree.report().skippedCount, 0u);
}

TEST(MakeTorusKnot, IsClosedAndConsistentlyTurned) {
  const TriangleMesh<float> knot = makeTorusKnot(40, 6, 0.2);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const FaceIndices& face : knot.faces) {
    for (std::size_t i = 0; i < 3; ++i)
      ++edges[{face[i], face[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first})) << "an open edge";
  }
}

TEST(MakeTorusKnot, HasItsNormalsOutside) {
  const TriangleMesh<float> knot = makeTorusKnot(90, 12, 0.15);
  double volume = 0.0;
  for (const FaceIndices& face : knot.faces) {
    const Vec3d a(knot.positions[face[0]]);
    volume += dot(a, cross(Vec3d(knot.positions[face[1]]), Vec3d(knot.positions[face[2]]))) / 6.0;
  }
  EXPECT_GT(volume, 0.0);
}

}  // namespace
}  // namespace planetree::render
