#include "render/file/encode_png.hpp"

#include "support/read_png.hpp"

#include <gtest/gtest.h>

#include <random>

namespace planetree::test {
namespace {

using render::encodePng;
using render::Image;
using render::ImageSize;
using render::Metadata;

TEST(EncodePng, GivesBackEveryPixel) {
  std::mt19937 random(1);
  for (const ImageSize& size : {ImageSize{1, 1}, {1, 7}, {7, 1}, {33, 20}, {300, 200}}) {
    Image image(size);
    for (render::Rgb8& pixel : image.pixels) {
      pixel = {static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
               static_cast<std::uint8_t>(random())};
    }
    const auto read = readPng(encodePng(image));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->image.size, image.size);
    EXPECT_EQ(read->image.pixels, image.pixels);
  }
}

TEST(EncodePng, GivesBackTheMetadata) {
  const Metadata metadata = {{"Software", "planetree"},
                             {"Empty", ""},
                             {"Model", "Häschen \xE5\x85\x94.obj"},
                             {"Long", std::string(100'000, 'x')}};
  const auto read = readPng(encodePng(Image({2, 2}), metadata));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->texts.size(), metadata.size());
  for (const render::MetadataEntry& entry : metadata)
    EXPECT_EQ(read->texts.at(entry.key), entry.text);
}

TEST(EncodePng, SaysThatItIsSrgb) {
  EXPECT_TRUE(readPng(encodePng(Image({2, 2})))->isSrgb);
}

TEST(EncodePng, TakesPicturesThatAreWiderThanAMillionPixels) {
  const ImageSize size{1'200'000, 1};
  const auto bytes = encodePng(Image(size));
  EXPECT_LT(bytes.size(), 100'000u);
  EXPECT_GT(bytes.size(), 1000u);
}

}  // namespace
}  // namespace planetree::test
