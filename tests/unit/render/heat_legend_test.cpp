#include "render/overlay/heat_legend.hpp"

#include "render/colour_map.hpp"
#include "render/overlay/stroke_font.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace planetree::render {
namespace {

constexpr Rgb8 kWhite{255, 255, 255};
constexpr Rgb8 kBlack{0, 0, 0};

ValueRange rangeTo(double brightest, double highest) {
  return {.darkest = 0.0, .brightest = brightest, .lowest = 1.0, .mean = 2.0, .highest = highest};
}

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> all;
  for (const Tick& tick : ticks)
    all.push_back(tick.label);
  return all;
}

TEST(ScaleTicks, AreRoundNumbersBetweenTheEnds) {
  EXPECT_EQ(labels(scaleTicks(rangeTo(100.0, 90.0), 6)),
            (std::vector<std::string>{"0", "20", "40", "60", "80", "100"}));
  EXPECT_EQ(labels(scaleTicks(rangeTo(130.0, 90.0), 6)),
            (std::vector<std::string>{"0", "50", "100", "130"}));
}

TEST(ScaleTicks, TheLastHasAPlusIfThereIsMore) {
  EXPECT_EQ(labels(scaleTicks(rangeTo(8.0, 8.0), 4)).back(), "8");
  EXPECT_EQ(labels(scaleTicks(rangeTo(8.0, 8.5), 4)).back(), "8+");
}

TEST(ScaleTicks, LabelsSayTheValuesOfTheirTicksAndKeepTheirDistance) {
  for (const double end : {1.0, 2.0, 7.0, 19.0, 55.0, 99.0, 110.0, 640.0, 3300.0, 4294967295.0}) {
    for (const int count : {1, 2, 3, 5, 10}) {
      const std::vector<Tick> ticks = scaleTicks(rangeTo(end, end), count);
      ASSERT_GE(ticks.size(), 2u);
      EXPECT_EQ(ticks.front().value, 0.0);
      EXPECT_EQ(ticks.back().value, end);
      EXPECT_LE(static_cast<int>(ticks.size()), count + 2) << end;
      for (std::size_t i = 0; i < ticks.size(); ++i) {
        EXPECT_NEAR(std::stod(ticks[i].label), ticks[i].value, 0.05 + 1e-6 * end) << end;
        if (i > 0) {
          EXPECT_GE(ticks[i].value - ticks[i - 1].value, 0.6 * end / count) << end;
        }
      }
    }
  }
}

/// The part of a picture from one row on.
std::vector<Rgb8> rowsFrom(const Image& image, std::uint32_t y) {
  return {image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * image.size.width,
          image.pixels.end()};
}

TEST(WithHeatLegend, LeavesThePictureAsItIs) {
  Image picture({300, 50});
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 256), 7};
  const Image image = withHeatLegend(picture, rangeTo(50.0, 60.0));
  EXPECT_EQ(image.size.width, 300u);
  EXPECT_TRUE(std::equal(picture.pixels.begin(), picture.pixels.end(), image.pixels.begin()));
}

bool isAbout(const Rgb8& a, const Vec3f& colour) {
  const Rgb8 b = quantized(colour);
  constexpr int kNear = 3;
  return std::abs(a.red - b.red) <= kNear && std::abs(a.green - b.green) <= kNear &&
         std::abs(a.blue - b.blue) <= kNear;
}

TEST(WithHeatLegend, ItsBarShowsTheColoursWhereItsScaleHasThem) {
  for (const ImageSize& size : {ImageSize{320, 240}, {800, 600}, {1920, 1080}}) {
    Image picture(size);
    std::fill(picture.pixels.begin(), picture.pixels.end(), kWhite);
    const Image image = withHeatLegend(picture, rangeTo(50.0, 50.0));
    std::uint32_t barRows = 0;
    for (std::uint32_t y = 0; y < image.size.height; ++y) {
      const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * size.width;
      const auto isOf = [](float value) {
        return [value](const Rgb8& pixel) { return isAbout(pixel, infernoColour(value)); };
      };
      const auto first = std::find_if(row, row + size.width, isOf(0.0f));
      const auto last = std::find_if(row, row + size.width, isOf(1.0f));
      if (last - first < size.width / 2 || last == row + size.width)
        continue;
      ++barRows;
      for (const float value : {0.25f, 0.5f, 0.75f}) {
        const auto place = first + std::lround(value * static_cast<float>(last - first));
        EXPECT_TRUE(std::any_of(place - 4, place + 5, isOf(value))) << size.width << ", " << value;
      }
    }
    EXPECT_GE(barRows, 8u) << size.width;
  }
}

TEST(WithHeatLegend, ItsNumbersAreThoseOfTheRange) {
  const Image picture({400, 30});
  const ValueRange range = rangeTo(50.0, 60.0);
  const auto legend = [&](const ValueRange& r) {
    return rowsFrom(withHeatLegend(picture, r), picture.size.height);
  };
  for (double ValueRange::*number :
       {&ValueRange::lowest, &ValueRange::mean, &ValueRange::highest, &ValueRange::brightest}) {
    ValueRange other = range;
    other.*number += 1.0;
    EXPECT_NE(legend(other), legend(range));
  }
}

TEST(WithHeatLegend, EndsInAnArrowOnlyIfThereIsMore) {
  // The numbers are the same in both but for the maximum, which has as many digits.
  const Image with = withHeatLegend(Image({400, 30}), rangeTo(50.0, 51.0));
  const Image without = withHeatLegend(Image({400, 30}), rangeTo(50.0, 50.0));
  const auto brightest = [](const Image& image) {
    return std::count(image.pixels.begin(), image.pixels.end(), quantized(infernoColour(1.0f)));
  };
  EXPECT_GT(brightest(with), brightest(without) + 10);
}

TEST(WithHeatLegend, NarrowPicturesStandInItsMiddle) {
  Image picture({4, 4});
  std::fill(picture.pixels.begin(), picture.pixels.end(), kBlack);
  const Image image = withHeatLegend(picture, rangeTo(50.0, 60.0));
  ASSERT_GT(image.size.width, 150u);
  const std::uint32_t left = (image.size.width - 4) / 2;
  EXPECT_EQ(image.at(left - 1, 2), kWhite);
  EXPECT_EQ(image.at(left, 2), kBlack);
  EXPECT_EQ(image.at(left + 3, 2), kBlack);
  EXPECT_EQ(image.at(left + 4, 2), kWhite);
}

TEST(WithHeatLegend, NothingReachesTheEdgesOfTheStrip) {
  for (const ImageSize& size : {ImageSize{1, 1}, {200, 10}, {320, 240}, {1000, 10}, {1920, 1080}}) {
    for (const double number : {1.0, 99.9, 1234567.0}) {
      ValueRange range = rangeTo(number, number + 1.0);
      range.lowest = range.mean = number;
      const Image image = withHeatLegend(Image(size), range);
      for (std::uint32_t y = size.height; y < image.size.height; ++y) {
        EXPECT_EQ(image.at(0, y), kWhite) << size.width << ", " << number;
        EXPECT_EQ(image.at(image.size.width - 1, y), kWhite) << size.width << ", " << number;
      }
      for (std::uint32_t x = 0; x < image.size.width; ++x) {
        EXPECT_EQ(image.at(x, size.height), kWhite);
        EXPECT_EQ(image.at(x, image.size.height - 1), kWhite);
      }
    }
  }
}

// --- text ---

Image written(const std::string& text, TextSize size) {
  Image image({static_cast<std::uint32_t>(textWidth(text, size)) + 20,
               static_cast<std::uint32_t>(14.0 * size.unit) + 8});
  std::fill(image.pixels.begin(), image.pixels.end(), kWhite);
  drawText(image, {8.0, 9.0 * size.unit + 4.0}, size, text, kBlack);
  return image;
}

TEST(DrawText, EveryCharacterLooksDifferent) {
  const std::string all = "0123456789abcdefghijklmnopqrstuvwxyz.,:+-=/()";
  std::set<std::string> seen;
  for (const char character : all) {
    const Image image = written(std::string(1, character) + "      ", {1.2});
    std::string key;
    for (std::uint32_t y = 0; y < image.size.height; ++y) {
      for (std::uint32_t x = 0; x < 20; ++x)
        key += std::to_string(image.at(x, y).red) + " ";
    }
    EXPECT_TRUE(seen.insert(key).second) << character;
  }
}

TEST(DrawText, BlanksAndUnknownCharactersLeaveABlank) {
  for (const std::string text : {" ", "\xE2\x82\xAC", "\n"}) {
    const Image image = written(text, {2.0});
    EXPECT_TRUE(std::all_of(image.pixels.begin(), image.pixels.end(),
                            [](const Rgb8& pixel) { return pixel == kWhite; }));
  }
}

TEST(DrawText, StaysWithinItsWidthAndTheHeightOfItsLetters) {
  for (const double unit : {1.0, 1.2, 1.4, 2.8, 5.0}) {
    const std::string text = "steps 0123456789 jpqgy (wide)";
    const Image image = written(text, {unit});
    const double end = 8.0 + textWidth(text, {unit}) + 1.5 * unit + 1.0;
    for (std::uint32_t y = 0; y < image.size.height; ++y) {
      for (std::uint32_t x = 0; x < image.size.width; ++x) {
        if (x < 8.0 - unit - 1.0 || x > end) {
          EXPECT_EQ(image.at(x, y), kWhite) << unit << ": " << x << ", " << y;
        }
      }
    }
  }
}

TEST(TextWidth, GrowsWithTheTextAndTheSize) {
  EXPECT_EQ(textWidth("", {1.0}), 0.0);
  EXPECT_LT(textWidth("1", {1.0}), textWidth("12", {1.0}));
  EXPECT_DOUBLE_EQ(textWidth("12 steps", {3.0}), 3.0 * textWidth("12 steps", {1.0}));
}

}  // namespace
}  // namespace planetree::render
