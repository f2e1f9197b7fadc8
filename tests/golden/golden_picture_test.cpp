#include "golden/expect_golden.hpp"

#include "render/framing.hpp"
#include "render/overlay/heat_legend.hpp"
#include "render/render_image.hpp"
#include "render/still_life.hpp"

#include <planetree/build_tree.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <string>

// Small pictures of the still life are compared with those in data/golden; see expect_golden.hpp.

namespace planetree::test {
namespace {

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

class Golden : public testing::TestWithParam<GoldenPicture> {};

TEST_P(Golden, PictureOfTheStillLifeIsAsBefore) {
  expectGolden(renderStillLife(GetParam()), GetParam().name, GetParam().tolerance);
}

INSTANTIATE_TEST_SUITE_P(Modes, Golden, testing::ValuesIn(kPictures), [](const auto& suite) {
  std::string name = suite.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace planetree::test
