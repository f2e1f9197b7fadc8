#include "support/read_png.hpp"

#include "render/file/encode_png.hpp"
#include "render/framing.hpp"
#include "render/overlay/heat_legend.hpp"
#include "render/render_image.hpp"
#include "render/still_life.hpp"

#include <planetree/build_tree.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <ostream>
#include <string>

// Small pictures of the still life are compared with those in data/golden. After a change that is
// meant to alter them, look at the new ones and keep them:
//
//     PLANETREE_UPDATE_GOLDENS=1 <build folder>/bin/golden
//
// A picture that differs is left in the build folder for comparison.

namespace planetree::test {
namespace {

namespace fs = std::filesystem;

using render::Image;
using render::RenderMode;

/// One picture and how far it may be from its golden one: the root of the mean square difference of
/// the channels, in steps of 1/255.
struct GoldenPicture {
  RenderMode mode;
  std::string name;
  double tolerance;
  std::optional<std::uint32_t> cellDepth = {};
};

// Other compilers round the shading differently, and at the outlines a ray may then see another
// object: a few pixels of ten thousand. The heat shows the tree itself, where a split may move for
// the same reason, and with it everything behind.
const GoldenPicture kPictures[] = {{RenderMode::AmbientOcclusion, "ao", 2.0},
                                   {RenderMode::Normals, "normals", 2.0},
                                   {RenderMode::Depth, "depth", 2.0},
                                   {RenderMode::Heat, "heat", 6.0},
                                   {RenderMode::AmbientOcclusion, "cells", 6.0, 5},
                                   {RenderMode::Heat, "heat-cells", 6.0, 8}};

void PrintTo(const GoldenPicture& picture, std::ostream* out) {
  *out << picture.name;
}

Image renderStillLife(const GoldenPicture& picture) {
  static const render::StillLife stillLife = render::makeStillLife();
  static const render::TreeTracer<AnyObject<float>> tracer(buildTree(stillLife.scene));
  const render::ImageSize size{160, 120};
  const render::Framing framing{.aspect = static_cast<double>(size.width) / size.height};
  const auto rendering = renderImage(tracer, {.size = size,
                                              .camera = *frameCamera(stillLife.outline, framing),
                                              .mode = picture.mode,
                                              .samplesPerPixel = 16,
                                              .albedos = stillLife.albedos,
                                              .cellDepth = picture.cellDepth});
  const Image image = shownImage(rendering);
  return picture.mode == RenderMode::Heat ? withHeatLegend(image, *rendering.range) : image;
}

double rootMeanSquare(const Image& a, const Image& b) {
  double sum = 0.0;
  const auto addSquare = [&sum](int first, int second) {
    sum += (first - second) * (first - second);
  };
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    addSquare(a.pixels[i].red, b.pixels[i].red);
    addSquare(a.pixels[i].green, b.pixels[i].green);
    addSquare(a.pixels[i].blue, b.pixels[i].blue);
  }
  return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

void writePng(const Image& image, const fs::path& path) {
  const std::vector<std::byte> png = encodePng(image);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  ASSERT_TRUE(file.flush()) << path;
}

class Golden : public testing::TestWithParam<GoldenPicture> {};

TEST_P(Golden, PictureOfTheStillLifeIsAsBefore) {
  const Image actual = renderStillLife(GetParam());
  const fs::path goldenPath = fs::path(PLANETREE_GOLDEN_FOLDER) / (GetParam().name + ".png");
  if (std::getenv("PLANETREE_UPDATE_GOLDENS") != nullptr) {
    writePng(actual, goldenPath);
    GTEST_SKIP() << "kept as the new " << goldenPath;
  }
  const auto golden = readPng(goldenPath);
  ASSERT_TRUE(golden) << goldenPath << " is missing; PLANETREE_UPDATE_GOLDENS=1 makes it";
  ASSERT_EQ(actual.size, golden->image.size);
  const double difference = rootMeanSquare(actual, golden->image);
  if (difference <= GetParam().tolerance)
    return;
  const fs::path actualPath = fs::path(PLANETREE_ACTUAL_FOLDER) / (GetParam().name + ".png");
  writePng(actual, actualPath);
  ADD_FAILURE() << actualPath << " differs from " << goldenPath << " by " << difference
                << "/255 in the root mean square";
}

INSTANTIATE_TEST_SUITE_P(Modes, Golden, testing::ValuesIn(kPictures), [](const auto& suite) {
  std::string name = suite.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace planetree::test
