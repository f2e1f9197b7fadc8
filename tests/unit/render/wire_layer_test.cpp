#include "render/overlay/wire_layer.hpp"

#include "render/overlay/draw_cells.hpp"
#include "render/overlay/line_coverage.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/shape/shapes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace planetree::render {
namespace {

// --- lines in the plane ---

using Coverages = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;

Coverages coverages(const Line2& line, double width, const ImageSize& size) {
  Coverages found;
  forEachCoveredPixel(line, width, size,
                      [&](std::uint32_t x, std::uint32_t y, double coverage, double) {
                        EXPECT_FALSE(found.contains({x, y})) << "visited twice";
                        found[{x, y}] = coverage;
                      });
  return found;
}

TEST(ForEachCoveredPixel, ALineThroughPixelCentresCoversTheseWholly) {
  const Coverages level = coverages({{2.5, 3.5}, {6.5, 3.5}}, 1.0, {10, 10});
  for (std::uint32_t x = 2; x <= 6; ++x)
    EXPECT_EQ(level.at({x, 3}), 1.0);
  EXPECT_FALSE(level.contains({4, 2}));
  EXPECT_FALSE(level.contains({4, 4}));
  const Coverages steep = coverages({{2.5, 3.5}, {2.5, 7.5}}, 1.0, {10, 10});
  for (std::uint32_t y = 3; y <= 7; ++y)
    EXPECT_EQ(steep.at({2, y}), 1.0);
}

TEST(ForEachCoveredPixel, ALineBetweenTwoRowsCoversHalfOfEach) {
  const Coverages found = coverages({{2.5, 4.0}, {6.5, 4.0}}, 1.0, {10, 10});
  EXPECT_EQ(found.at({4, 3}), 0.5);
  EXPECT_EQ(found.at({4, 4}), 0.5);
}

TEST(ForEachCoveredPixel, FindsAllPixelsThatAreNear) {
  const ImageSize size{40, 30};
  for (const Line2& line : {Line2{{3.2, 4.1}, {35.7, 22.9}}, Line2{{30.0, 2.0}, {28.5, 27.0}},
                            Line2{{-20.0, 40.0}, {60.0, -15.0}}, Line2{{7.7, 7.7}, {7.7, 7.7}}}) {
    for (const double width : {1.0, 4.5}) {
      const Coverages found = coverages(line, width, size);
      const Point2 way{line.b.x - line.a.x, line.b.y - line.a.y};
      const double squared = way.x * way.x + way.y * way.y;
      for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
          const Point2 from{x + 0.5 - line.a.x, y + 0.5 - line.a.y};
          const double t =
              squared > 0.0
                  ? std::fmin(std::fmax((from.x * way.x + from.y * way.y) / squared, 0.0), 1.0)
                  : 0.0;
          const double distance = std::hypot(from.x - t * way.x, from.y - t * way.y);
          const double coverage = std::fmin(width / 2.0 + 0.5 - distance, 1.0);
          const auto pixel = found.find({x, y});
          const double actual = pixel == found.end() ? 0.0 : pixel->second;
          EXPECT_NEAR(actual, std::fmax(coverage, 0.0), 1e-12) << x << ", " << y;
        }
      }
    }
  }
}

// --- lines in space ---

constexpr ImageSize kSize{40, 40};
constexpr WireStyle kStyle{
    .colour = {1.0f, 0.5f, 0.0f}, .width = 1.0, .seen = 1.0f, .hidden = 0.25f};

/// At z = 5, looking down the z axis. At z = 0 the picture shows x and y from -5 to 5: four pixels
/// to the unit, and (0, 0) is the corner of four pixels in its middle.
PinholeCamera straightCamera() {
  return {{.eye = {0.0f, 0.0f, 5.0f}, .fovDegrees = 90.0f}, 1.0};
}

float alpha(const WireLayer& layer, std::uint32_t x, std::uint32_t y) {
  return layer.light(x, y).alpha;
}

TEST(WireLayer, APointOfALineLandsWhereTheCameraSeesIt) {
  WireLayer layer(kSize, kStyle);
  // y = 1.125 is 4.5 pixels above the middle: the centre of row 20 - 5 = 15.
  layer.draw({-3.0, 1.125, 0.0}, {2.0, 1.125, 0.0}, straightCamera(), SurfaceDepths(kSize));
  EXPECT_FLOAT_EQ(alpha(layer, 8, 15), 1.0f);
  EXPECT_FLOAT_EQ(alpha(layer, 20, 15), 1.0f);
  EXPECT_FLOAT_EQ(alpha(layer, 27, 15), 1.0f);
  EXPECT_EQ(alpha(layer, 5, 15), 0.0f) << "before its end";
  EXPECT_EQ(alpha(layer, 31, 15), 0.0f) << "behind its end";
  EXPECT_EQ(alpha(layer, 20, 13), 0.0f);
  EXPECT_EQ(alpha(layer, 20, 17), 0.0f);
}

TEST(WireLayer, ColoursAreMultipliedByTheirCoverage) {
  WireLayer layer(kSize, kStyle);
  layer.draw({-3.0, 1.0, 0.0}, {2.0, 1.0, 0.0}, straightCamera(), SurfaceDepths(kSize));
  const Light light = layer.light(20, 15);
  EXPECT_FLOAT_EQ(light.alpha, 0.5f);
  EXPECT_FLOAT_EQ(light.colour.x, 0.5f);
  EXPECT_FLOAT_EQ(light.colour.y, 0.25f);
}

TEST(WireLayer, LinesOnTopOfEachOtherCountOnce) {
  WireLayer once(kSize, kStyle);
  WireLayer twice(kSize, kStyle);
  for (int i = 0; i < 2; ++i) {
    if (i == 0)
      once.draw({-3.0, 1.0, 0.0}, {2.0, 2.0, 0.0}, straightCamera(), SurfaceDepths(kSize));
    twice.draw({-3.0, 1.0, 0.0}, {2.0, 2.0, 0.0}, straightCamera(), SurfaceDepths(kSize));
  }
  for (std::uint32_t y = 0; y < kSize.height; ++y) {
    for (std::uint32_t x = 0; x < kSize.width; ++x)
      EXPECT_EQ(alpha(once, x, y), alpha(twice, x, y));
  }
}

TEST(WireLayer, WhatIsBehindASurfaceShinesThroughItFaintly) {
  SurfaceDepths depths(kSize);
  depths.at(20, 15).fill(3.0f);  // in front of the line, which is at depth 5
  depths.at(22, 15).fill(6.0f);  // behind it
  depths.at(24, 15) = {3.0f, 3.0f, 6.0f, 6.0f};
  WireLayer layer(kSize, kStyle);
  layer.draw({-3.0, 1.125, 0.0}, {3.0, 1.125, 0.0}, straightCamera(), depths);
  EXPECT_FLOAT_EQ(alpha(layer, 20, 15), 0.25f);
  EXPECT_FLOAT_EQ(alpha(layer, 22, 15), 1.0f);
  EXPECT_FLOAT_EQ(alpha(layer, 24, 15), 0.5f);
}

TEST(WireLayer, ALineOnASurfaceIsSeen) {
  SurfaceDepths depths(kSize);
  depths.at(20, 15).fill(std::nextafter(5.0f, 0.0f));
  WireLayer layer(kSize, kStyle);
  layer.draw({-3.0, 1.125, 0.0}, {3.0, 1.125, 0.0}, straightCamera(), depths);
  EXPECT_FLOAT_EQ(alpha(layer, 20, 15), 1.0f);
}

TEST(WireLayer, DepthAlongASlantedLineIsThatOfSpaceNotOfThePicture) {
  // From depth 1, at the picture's right edge, to depth 9, at 20 + 20 / 9: the pixel whose centre
  // is at 24.5 sees depth 20 / 4.5 = 4.4. Depths that changed evenly along the picture would
  // give 8.
  const auto alphaBehind = [](float surface) {
    SurfaceDepths depths(kSize);
    depths.at(24, 19).fill(surface);
    WireLayer layer(kSize, kStyle);
    layer.draw({1.0, 0.0, 4.0}, {1.0, 0.0, -4.0}, straightCamera(), depths);
    return alpha(layer, 24, 19);
  };
  EXPECT_FLOAT_EQ(alphaBehind(5.0f), 0.5f);
  EXPECT_FLOAT_EQ(alphaBehind(3.0f), 0.125f);
}

TEST(WireLayer, LinesThatPassTheEyeAreCutOff) {
  for (const auto& [a, b] : std::vector<std::pair<Vec3d, Vec3d>>{
           {{0.3, 0.2, -20.0}, {0.3, 0.2, 50.0}},    // past the eye, from front to back
           {{-9.0, 0.5, 5.0}, {9.0, 0.5, 5.0}},      // beside the eye, at depth 0
           {{0.0, 0.0, 0.0}, {0.0, 0.0, 10.0}},      // through the eye
           {{0.0, 0.0, 5.0}, {0.0, 0.0, 5.0}},       // in the eye
           {{-1e30, 1.0, 0.0}, {1e30, 1.0, 0.0}},    // far beyond both sides
           {{1.0, 1.0, 6.0}, {2.0, 1.0, 600.0}}}) {  // behind the eye
    WireLayer layer(kSize, kStyle);
    layer.draw(a, b, straightCamera(), SurfaceDepths(kSize));
    for (std::uint32_t y = 0; y < kSize.height; ++y) {
      for (std::uint32_t x = 0; x < kSize.width; ++x)
        EXPECT_TRUE(std::isfinite(alpha(layer, x, y)));
    }
  }
}

TEST(WireLayer, ALineThatStartsBehindTheEyeIsSeenInFrontOfIt) {
  WireLayer layer(kSize, kStyle);
  // Straight below the middle of the picture, running away: it enters at the lower edge.
  layer.draw({0.125, -1.0, 40.0}, {0.125, -1.0, -1000.0}, straightCamera(), SurfaceDepths(kSize));
  EXPECT_GT(alpha(layer, 20, 21), 0.5f);
  EXPECT_EQ(alpha(layer, 20, 18), 0.0f);
}

TEST(WireLayer, LinesBehindTheEyeAreNotSeen) {
  WireLayer layer(kSize, kStyle);
  layer.draw({-3.0, 1.0, 6.0}, {3.0, -1.0, 9.0}, straightCamera(), SurfaceDepths(kSize));
  for (std::uint32_t y = 0; y < kSize.height; ++y) {
    for (std::uint32_t x = 0; x < kSize.width; ++x)
      EXPECT_EQ(alpha(layer, x, y), 0.0f);
  }
}

// --- cells ---

/// A box in front of the camera, and the edges of its bounds: those of the front face are in front
/// of its surface, those of the back face behind it.
TEST(DrawCells, EdgesOnTheFrontAreSeenAndThoseAtTheBackAreDimmed) {
  const TreeTracer<Box<float>> tracer(buildTree(std::vector<Box<float>>{
      {.lower = {-1.125f, -1.125f, -3.0f}, .upper = {1.125f, 1.125f, 0.0f}}}));
  Progress progress({}, kSize.pixelCount());
  const auto wires = drawCells(tracer, straightCamera(),
                               {.size = kSize, .depth = 1, .colour = {1.0f, 1.0f, 1.0f}}, progress);
  ASSERT_TRUE(wires);
  // The front face is at depth 5: from 20 - 4.5 to 20 + 4.5.
  EXPECT_FLOAT_EQ(alpha(*wires, 15, 20), 1.0f);
  EXPECT_FLOAT_EQ(alpha(*wires, 24, 20), 1.0f);
  EXPECT_FLOAT_EQ(alpha(*wires, 20, 15), 1.0f);
  EXPECT_EQ(alpha(*wires, 12, 20), 0.0f);
  // The back face is at depth 8: 1.125 there is 2.8 pixels from the middle.
  EXPECT_GT(alpha(*wires, 17, 20), 0.05f);
  EXPECT_LT(alpha(*wires, 17, 20), 0.3f);
}

TEST(DrawCells, StopWhenTheyAreToldTo) {
  const TreeTracer<Sphere<float>> tracer(buildTree(std::vector<Sphere<float>>{{.radius = 1.0f}}));
  Progress progress([](double) { return false; }, kSize.pixelCount());
  EXPECT_FALSE(drawCells(tracer, straightCamera(), {.size = kSize}, progress));
}

}  // namespace
}  // namespace planetree::render
