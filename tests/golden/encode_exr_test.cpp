#include "render/file/encode_exr.hpp"

#include "support/read_exr.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>

namespace planetree::test {
namespace {

using render::Channel;
using render::ChannelImage;
using render::ChannelType;
using render::encodeExr;
using render::Metadata;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::optional<ExrFile> reread(const ChannelImage& image, const Metadata& metadata = {}) {
  const std::vector<std::byte> bytes = encodeExr(image, metadata);
  return readExr(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

TEST(EncodeExr, GivesBackEveryBitOfAFloat) {
  std::mt19937 random(1);
  for (const render::ImageSize& size : {render::ImageSize{1, 1}, {1, 40}, {40, 1}, {33, 50}}) {
    Channel channel{.name = "Z", .type = ChannelType::Float, .values = {}};
    for (std::size_t i = 0; i < size.pixelCount(); ++i)
      channel.values.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
    channel.values[0] = kInfinity;
    const auto file = reread({size, {channel}});
    ASSERT_TRUE(file);
    EXPECT_EQ(file->width, size.width);
    EXPECT_EQ(file->height, size.height);
    const ExrChannel& read = file->channels.at("Z");
    EXPECT_FALSE(read.isHalf);
    ASSERT_EQ(read.values.size(), channel.values.size());
    EXPECT_EQ(
        std::memcmp(read.values.data(), channel.values.data(), read.values.size() * sizeof(float)),
        0);
  }
}

TEST(EncodeExr, RoundsHalvesToElevenBits) {
  const Channel channel{.name = "R",
                        .type = ChannelType::Half,
                        .values = {0.0f, 1.0f, 0.25f, 2048.0f, 2049.0f, 1e6f}};
  const auto file = reread({{3, 2}, {channel}});
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->channels.at("R").isHalf);
  EXPECT_EQ(file->channels.at("R").values,
            (std::vector<float>{0.0f, 1.0f, 0.25f, 2048.0f, 2048.0f, kInfinity}));
}

TEST(EncodeExr, KeepsManyChannelsOfBothKindsApart) {
  ChannelImage image{.size = {2, 2}, .channels = {}};
  for (int i = 0; i < 12; ++i) {
    const auto value = static_cast<float>(i);
    image.channels.push_back({.name = "layer." + std::to_string(i),
                              .type = i % 2 == 0 ? ChannelType::Half : ChannelType::Float,
                              .values = {value, value + 0.25f, value + 0.5f, value + 0.75f}});
  }
  const auto file = reread(image);
  ASSERT_TRUE(file);
  ASSERT_EQ(file->channels.size(), image.channels.size());
  for (const Channel& channel : image.channels)
    EXPECT_EQ(file->channels.at(channel.name).values, channel.values) << channel.name;
}

TEST(EncodeExr, GivesBackTheMetadata) {
  const Channel channel{.name = "Y", .type = ChannelType::Float, .values = {1.0f}};
  const auto file = reread({{1, 1}, {channel}},
                           {{"Software", "planetree"}, {"Tree Options", ""}, {"Model", "兔.obj"}});
  ASSERT_TRUE(file);
  EXPECT_EQ(file->texts, (std::map<std::string, std::string>{
                             {"software", "planetree"}, {"treeOptions", ""}, {"model", "兔.obj"}}));
}

}  // namespace
}  // namespace planetree::test
