#include "render/colour_map.hpp"
#include "render/image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace planetree::render {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Relative luminance of a colour in linear light (ITU-R BT.709), here of encoded channels: good
/// enough to tell brighter from darker.
float brightness(const Vec3f& colour) {
  return 0.2126f * colour.x + 0.7152f * colour.y + 0.0722f * colour.z;
}

TEST(InfernoColour, GetsBrighterAllTheWay) {
  for (int i = 0; i < 1000; ++i) {
    EXPECT_LT(brightness(infernoColour(static_cast<float>(i) / 1000.0f)),
              brightness(infernoColour(static_cast<float>(i + 1) / 1000.0f)))
        << i;
  }
}

TEST(InfernoColour, RunsFromBlackToPaleYellow) {
  EXPECT_EQ(quantized(infernoColour(0.0f)), (Rgb8{0x00, 0x00, 0x04}));
  EXPECT_EQ(quantized(infernoColour(0.5f)), (Rgb8{0xBB, 0x37, 0x54}));
  EXPECT_EQ(quantized(infernoColour(1.0f)), (Rgb8{0xFC, 0xFF, 0xA4}));
}

/// A colour in Oklab, where equal distances look equally large (Ottosson, "A perceptual color space
/// for image processing", 2020).
Vec3d oklab(const Vec3f& colour) {
  const Vec3d c(srgbDecoded(colour));
  const double l = std::cbrt(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
  const double m = std::cbrt(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
  const double s = std::cbrt(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

// The darkest part is left out: there no colour space is good, and black is far from everything.
TEST(InfernoColour, EqualStepsLookEquallyLarge) {
  constexpr int kSteps = 32;
  double shortest = 1.0;
  double longest = 0.0;
  for (int i = 3; i < kSteps; ++i) {
    const auto at = [](int step) {
      return oklab(infernoColour(static_cast<float>(step) / kSteps));
    };
    const double step = length(at(i + 1) - at(i));
    shortest = std::min(shortest, step);
    longest = std::max(longest, step);
  }
  EXPECT_LT(longest, 1.4 * shortest);
}

TEST(SrgbDecoded, IsTheInverseOfEncoding) {
  for (int i = 0; i <= 255; ++i) {
    const float encoded = static_cast<float>(i) / 255.0f;
    EXPECT_NEAR(srgbEncoded(srgbDecoded(encoded)), encoded, 1e-6f);
    EXPECT_EQ(quantized(srgbEncoded(srgbDecoded(Vec3f{encoded, encoded, encoded}))).red, i);
  }
}

TEST(InfernoColour, ClampsAndTakesNanAsZero) {
  EXPECT_EQ(infernoColour(-5.0f), infernoColour(0.0f));
  EXPECT_EQ(infernoColour(kNan), infernoColour(0.0f));
  EXPECT_EQ(infernoColour(5.0f), infernoColour(1.0f));
  EXPECT_EQ(infernoColour(std::numeric_limits<float>::infinity()), infernoColour(1.0f));
}

TEST(Quantized, RoundsToTheNearestStepAndClamps) {
  EXPECT_EQ(quantized({0.0f, 0.5f, 1.0f}), (Rgb8{0, 128, 255}));
  EXPECT_EQ(quantized({0.0019f, 0.0020f, 254.4f / 255.0f}), (Rgb8{0, 1, 254}));
  EXPECT_EQ(quantized({-1.0f, 2.0f, kNan}), (Rgb8{0, 255, 0}));
}

TEST(SrgbEncoded, KeepsBlackAndWhiteAndBrightensTheMiddle) {
  EXPECT_EQ(srgbEncoded(0.0f), 0.0f);
  EXPECT_NEAR(static_cast<double>(srgbEncoded(1.0f)), 1.0, 1e-6);
  EXPECT_NEAR(static_cast<double>(srgbEncoded(0.2140411f)), 0.5, 1e-6);
}

}  // namespace
}  // namespace planetree::render
