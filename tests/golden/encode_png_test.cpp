#include "read_png.hpp"

#include <gtest/gtest.h>

#include <random>

namespace planetree::test {
namespace {

using render::encodePng;
using render::Image;
using render::ImageSize;

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
    EXPECT_EQ(read->size, image.size);
    EXPECT_EQ(read->pixels, image.pixels);
  }
}

}  // namespace
}  // namespace planetree::test
