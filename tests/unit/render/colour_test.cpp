#include "render/colour_map.hpp"
#include "render/image.hpp"

#include <gtest/gtest.h>

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
