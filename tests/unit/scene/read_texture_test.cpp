#include "scene/texture.hpp"

#include "support/random.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace planetree::test {
namespace {

using scene::readTexture;
using scene::Texture;
using scene::TextureEdges;

const std::filesystem::path kTextureFolder =
    std::filesystem::path(PLANETREE_REPOSITORY) / "data/scenes/textures";

using Bytes = std::vector<std::uint8_t>;

Texture read(const Bytes& bytes) {
  return readTexture(std::as_bytes(std::span(bytes)), "test.png");
}

/// The code of the error; `InvalidOption`, which no image has, if there is none.
ErrorCode codeOf(const Bytes& bytes) {
  try {
    static_cast<void>(read(bytes));
  } catch (const Error& error) {
    EXPECT_EQ(error.file(), "test.png");
    EXPECT_FALSE(error.advice().empty());
    return error.code();
  }
  return ErrorCode::InvalidOption;
}

Bytes bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

void append(Bytes& bytes, std::uint32_t value, std::size_t count, bool isBigEndian) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t shift = 8 * (isBigEndian ? count - 1 - i : i);
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

/// Blue, green and red of each texel, row by row from below.
Bytes bmp(std::uint32_t width, std::uint32_t height, const Bytes& rows) {
  Bytes bytes = {'B', 'M'};
  for (const std::uint32_t value :
       {static_cast<std::uint32_t>(54 + rows.size()), 0u, 54u, 40u, width, height})
    append(bytes, value, 4, false);
  append(bytes, 1, 2, false);
  append(bytes, 24, 2, false);
  for (int i = 0; i < 6; ++i)
    append(bytes, 0, 4, false);
  bytes.insert(bytes.end(), rows.begin(), rows.end());
  return bytes;
}

/// The same order of texels.
Bytes tga(std::uint32_t width, std::uint32_t height, const Bytes& rows) {
  Bytes bytes = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  append(bytes, width, 2, false);
  append(bytes, height, 2, false);
  bytes.push_back(24);
  bytes.push_back(0);
  bytes.insert(bytes.end(), rows.begin(), rows.end());
  return bytes;
}

/// With checksums of zero, which the decoder does not look at.
Bytes png(std::uint32_t width, std::uint32_t height, const Bytes& compressed) {
  Bytes bytes = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  const auto chunk = [&](const std::string& kind, const Bytes& data) {
    append(bytes, static_cast<std::uint32_t>(data.size()), 4, true);
    bytes.insert(bytes.end(), kind.begin(), kind.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    append(bytes, 0, 4, true);
  };
  Bytes head;
  append(head, width, 4, true);
  append(head, height, 4, true);
  head.insert(head.end(), {8, 2, 0, 0, 0});
  chunk("IHDR", head);
  chunk("IDAT", compressed);
  chunk("IEND", {});
  return bytes;
}

/// A zlib stream of a zero that is repeated 258 times for every 13 bits.
Bytes manyZeros(std::size_t repeatCount) {
  Bytes bytes = {0x78, 0x01};
  std::uint32_t bits = 0;
  int bitCount = 0;
  const auto put = [&](std::uint32_t code, int length) {
    for (int i = length - 1; i >= 0; --i) {
      bits |= (code >> i & 1u) << bitCount;
      if (++bitCount == 8) {
        bytes.push_back(static_cast<std::uint8_t>(bits));
        bits = 0;
        bitCount = 0;
      }
    }
  };
  put(1, 1);           // the last block
  put(0b10, 2);        // with fixed codes: 01, lowest bit first
  put(0b00110000, 8);  // the literal 0
  for (std::size_t i = 0; i < repeatCount; ++i) {
    put(0b11000101, 8);  // 258 bytes
    put(0, 5);           // like the one before
  }
  put(0, 7);
  put(0, 7);
  append(bytes, 0, 4, true);
  return bytes;
}

/// 8 x 8 texels of (200, 100, 50), nearly.
const Bytes kJpeg = {
    0xFF, 0xD8, 0xFF, 0xE0, 0x00, 0x10, 0x4A, 0x46, 0x49, 0x46, 0x00, 0x01, 0x01, 0x00, 0x00, 0x01,
    0x00, 0x01, 0x00, 0x00, 0xFF, 0xDB, 0x00, 0x43, 0x00, 0x03, 0x02, 0x02, 0x03, 0x02, 0x02, 0x03,
    0x03, 0x03, 0x03, 0x04, 0x03, 0x03, 0x04, 0x05, 0x08, 0x05, 0x05, 0x04, 0x04, 0x05, 0x0A, 0x07,
    0x07, 0x06, 0x08, 0x0C, 0x0A, 0x0C, 0x0C, 0x0B, 0x0A, 0x0B, 0x0B, 0x0D, 0x0E, 0x12, 0x10, 0x0D,
    0x0E, 0x11, 0x0E, 0x0B, 0x0B, 0x10, 0x16, 0x10, 0x11, 0x13, 0x14, 0x15, 0x15, 0x15, 0x0C, 0x0F,
    0x17, 0x18, 0x16, 0x14, 0x18, 0x12, 0x14, 0x15, 0x14, 0xFF, 0xDB, 0x00, 0x43, 0x01, 0x03, 0x04,
    0x04, 0x05, 0x04, 0x05, 0x09, 0x05, 0x05, 0x09, 0x14, 0x0D, 0x0B, 0x0D, 0x14, 0x14, 0x14, 0x14,
    0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14,
    0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14,
    0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0x14, 0xFF, 0xC0,
    0x00, 0x11, 0x08, 0x00, 0x08, 0x00, 0x08, 0x03, 0x01, 0x11, 0x00, 0x02, 0x11, 0x01, 0x03, 0x11,
    0x01, 0xFF, 0xC4, 0x00, 0x14, 0x00, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04, 0xFF, 0xC4, 0x00, 0x14, 0x10, 0x01, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xC4, 0x00,
    0x15, 0x01, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x07, 0x08, 0xFF, 0xC4, 0x00, 0x14, 0x11, 0x01, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0xFF, 0xDA, 0x00, 0x0C, 0x03, 0x01,
    0x00, 0x02, 0x11, 0x03, 0x11, 0x00, 0x3F, 0x00, 0x20, 0x3D, 0x48, 0x3F, 0xFF, 0xD9};

void expectColour(const Vec3f& texel, int red, int green, int blue, float tolerance = 0.0f) {
  EXPECT_NEAR(texel.x, static_cast<float>(red) / 255.0f, tolerance);
  EXPECT_NEAR(texel.y, static_cast<float>(green) / 255.0f, tolerance);
  EXPECT_NEAR(texel.z, static_cast<float>(blue) / 255.0f, tolerance);
}

TEST(ReadTexture, GivesRowsFromTheTop) {
  // 2 x 2, with two bytes at the end of each row of the BMP.
  const Bytes below = {3, 2, 1, 6, 5, 4};
  const Bytes above = {9, 8, 7, 255, 0, 12};
  const Bytes gap = {0, 0};
  Bytes withGaps;
  Bytes without;
  for (const Bytes& row : {below, above}) {
    withGaps.insert(withGaps.end(), row.begin(), row.end());
    withGaps.insert(withGaps.end(), gap.begin(), gap.end());
    without.insert(without.end(), row.begin(), row.end());
  }
  for (const Bytes& bytes : {bmp(2, 2, withGaps), tga(2, 2, without)}) {
    const Texture texture = read(bytes);
    ASSERT_EQ(texture.width(), 2u);
    ASSERT_EQ(texture.height(), 2u);
    expectColour(texture.texel(0, 0), 7, 8, 9);
    expectColour(texture.texel(1, 0), 12, 0, 255);
    expectColour(texture.texel(0, 1), 1, 2, 3);
    expectColour(texture.texel(1, 1), 4, 5, 6);
  }
}

TEST(ReadTexture, ReadsJpeg) {
  const Texture texture = read(kJpeg);
  ASSERT_EQ(texture.width(), 8u);
  expectColour(texture.texel(3, 4), 200, 100, 50, 0.02f);
}

TEST(ReadTexture, ReadsPng) {
  const Texture texture = readTexture(kTextureFolder / "chequer.png");
  ASSERT_EQ(texture.width(), 200u);
  ASSERT_EQ(texture.height(), 200u);
  expectColour(texture.texel(5, 5), 230, 224, 209);
  expectColour(texture.texel(25, 5), 41, 51, 66);
  const Texture black = read(png(2, 3, manyZeros(1)));
  EXPECT_EQ(black.height(), 3u);
  expectColour(black.texel(1, 2), 0, 0, 0);
}

// stb_image writes beyond its tables for these; see jpeg_guard.hpp.
const Bytes kTooManyCodes = {0xFF, 0xC4, 0x00, 0x13, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,
                             0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};

Bytes inserted(Bytes bytes, std::size_t offset, const Bytes& what) {
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(offset), what.begin(), what.end());
  return bytes;
}

TEST(ReadTexture, RefusesJpegWithMoreCodesThanThereCanBe) {
  constexpr std::size_t kBehindStart = 2;
  const std::size_t end = kJpeg.size() - 2;
  EXPECT_EQ(codeOf(inserted(kJpeg, kBehindStart, kTooManyCodes)), ErrorCode::MalformedFile);
  EXPECT_EQ(codeOf(inserted(kJpeg, end, kTooManyCodes)), ErrorCode::MalformedFile);
  EXPECT_EQ(codeOf(inserted(kJpeg, end - 3, kTooManyCodes)), ErrorCode::MalformedFile);
  // The second table of a segment, and one of which the file has only the beginning.
  Bytes second = {0xFF, 0xC4, 0x00, 0x25, 0x00};
  second.resize(second.size() + 16, 0);
  second.insert(second.end(), kTooManyCodes.begin() + 4, kTooManyCodes.end());
  EXPECT_EQ(codeOf(inserted(kJpeg, kBehindStart, second)), ErrorCode::MalformedFile);
  const Bytes cut(kTooManyCodes.begin(), kTooManyCodes.begin() + 9);
  EXPECT_EQ(codeOf(inserted({0xFF, 0xD8}, kBehindStart, cut)), ErrorCode::MalformedFile);
}

TEST(ReadTexture, ReadsJpegWhoseCommentsLookLikeTables) {
  for (const std::uint8_t marker : Bytes{0xE1, 0xE2, 0xEF, 0xFE}) {
    Bytes comment = {0xFF, marker, 0x00, static_cast<std::uint8_t>(2 + kTooManyCodes.size())};
    comment.insert(comment.end(), kTooManyCodes.begin(), kTooManyCodes.end());
    expectColour(read(inserted(kJpeg, 2, comment)).texel(0, 0), 200, 100, 50, 0.02f);
  }
  // Some cameras put a second image behind the first.
  expectColour(read(inserted(kJpeg, kJpeg.size(), kTooManyCodes)).texel(0, 0), 200, 100, 50, 0.02f);
}

TEST(ReadTexture, RefusesWhatIsNoImage) {
  EXPECT_EQ(codeOf({}), ErrorCode::UnknownFormat);
  EXPECT_EQ(codeOf({'h', 'e', 'l', 'l', 'o'}), ErrorCode::UnknownFormat);
  EXPECT_EQ(codeOf({0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'}), ErrorCode::MalformedFile);
  EXPECT_THROW(static_cast<void>(readTexture("no/such/image.png")), Error);
}

TEST(ReadTexture, RefusesImagesThatAreTooLargeBeforeItDecodesThem) {
  EXPECT_EQ(codeOf(png(1u << 14, (1u << 13) + 1, manyZeros(1))), ErrorCode::CapacityExceeded);
  EXPECT_EQ(codeOf(bmp(1u << 20, 1u << 20, {})), ErrorCode::CapacityExceeded);
  EXPECT_NE(codeOf(png(0x7FFFFFFF, 0x7FFFFFFF, manyZeros(1))), ErrorCode::InvalidOption);
  EXPECT_NE(codeOf(png(0xFFFFFFFF, 1, manyZeros(1))), ErrorCode::InvalidOption);
  EXPECT_NE(codeOf(png(0, 1, manyZeros(1))), ErrorCode::InvalidOption);
}

TEST(ReadTexture, RefusesTexelsThatTheFileCannotHold) {
  EXPECT_EQ(codeOf(bmp(10'000, 10'000, {})), ErrorCode::MalformedFile);
  EXPECT_EQ(codeOf(tga(10'000, 10'000, {1, 2, 3})), ErrorCode::MalformedFile);
  EXPECT_EQ(codeOf(png(10'000, 10'000, manyZeros(1))), ErrorCode::MalformedFile);
}

TEST(ReadTexture, ReadsWhatIsCompressedAsFarAsItGoes) {
  constexpr std::uint32_t kSide = 1000;
  const std::size_t size = (3 * kSide + 1) * kSide;
  EXPECT_EQ(read(png(kSide, kSide, manyZeros(size / 258 + 1))).width(), kSide);
}

TEST(ReadTexture, RefusesMoreTexelsThanItsHeadPromises) {
  // 160 kB that would become 25 MB, for an image of a few texels.
  EXPECT_EQ(codeOf(png(2, 3, manyZeros(100'000))), ErrorCode::MalformedFile);
}

TEST(ReadTexture, RefusesPngThatEndsEarly) {
  const Bytes whole = bytesOf(kTextureFolder / "bricks.png");
  for (std::size_t size = 0; size + 12 < whole.size(); ++size)
    EXPECT_NE(codeOf(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))),
              ErrorCode::InvalidOption)
        << size;
}

TEST(ReadTexture, WithBytesChangedIsAnErrorOrAnImage) {
  Random random(3);
  const Bytes rows(3 * 64, 77);
  for (const Bytes& whole :
       {bytesOf(kTextureFolder / "bricks.png"), bytesOf(kTextureFolder / "sky.png"), kJpeg,
        bmp(8, 8, rows), tga(8, 8, rows)}) {
    for (int i = 0; i < 1000; ++i) {
      Bytes bytes = whole;
      for (int change = 0; change < 3; ++change)
        bytes[random.below(bytes.size())] = static_cast<std::uint8_t>(random.below(256));
      if (random.chance(0.2))
        bytes.resize(random.below(bytes.size()));
      try {
        const Texture texture = read(bytes);
        EXPECT_GT(texture.width(), 0u);
        EXPECT_GT(texture.height(), 0u);
      } catch (const Error& error) {
        EXPECT_EQ(error.file(), "test.png");
      }
    }
  }
}

TEST(Texture, IsBilinearBetweenTheMiddlesOfItsTexels) {
  const Texture texture(2, 2, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  for (const TextureEdges edges :
       {TextureEdges::Repeated, TextureEdges::Wrapped, TextureEdges::Clamped}) {
    EXPECT_EQ(texture.at(0.25, 0.75, edges), (Vec3d{0, 0, 0}));  // v goes up, rows go down
    EXPECT_EQ(texture.at(0.75, 0.75, edges), (Vec3d{1, 0, 0}));
    EXPECT_EQ(texture.at(0.25, 0.25, edges), (Vec3d{0, 1, 0}));
    EXPECT_EQ(texture.at(0.75, 0.25, edges), (Vec3d{0, 0, 1}));
    EXPECT_EQ(texture.at(0.5, 0.5, edges), (Vec3d{0.25, 0.25, 0.25}));
    EXPECT_EQ(texture.at(0.625, 0.75, edges), (Vec3d{0.75, 0, 0}));
  }
}

TEST(Texture, GoesOnBeyondItsEdgesAsItIsAskedTo) {
  // White at the upper left, black elsewhere.
  const Texture texture(2, 2, {{1, 1, 1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  const auto at = [&](double u, double v, TextureEdges edges) { return texture.at(u, v, edges).x; };
  // On the left edge, in the middle of the upper row.
  EXPECT_EQ(at(0, 0.75, TextureEdges::Repeated), 0.5);
  EXPECT_EQ(at(0, 0.75, TextureEdges::Wrapped), 0.5);
  EXPECT_EQ(at(0, 0.75, TextureEdges::Clamped), 1.0);
  // On the upper edge, in the middle of the left column.
  EXPECT_EQ(at(0.25, 1, TextureEdges::Repeated), 0.5);
  EXPECT_EQ(at(0.25, 1, TextureEdges::Wrapped), 1.0);
  EXPECT_EQ(at(0.25, 1, TextureEdges::Clamped), 1.0);
  // Beyond them.
  EXPECT_EQ(at(-0.75, 0.75, TextureEdges::Wrapped), 1.0);
  EXPECT_EQ(at(-0.75, 5, TextureEdges::Clamped), 1.0);
}

TEST(Texture, RepeatsAndTakesWhatIsNotFiniteForZero) {
  const Texture texture(2, 1, {{0, 0, 0}, {1, 1, 1}});
  const auto at = [&](double u, double v) { return texture.at(u, v, TextureEdges::Repeated); };
  EXPECT_EQ(at(0, 0), (Vec3d{0.5, 0.5, 0.5}));  // between the last and the first
  EXPECT_EQ(at(3.75, -7), at(0.75, 0));
  EXPECT_EQ(at(-0.25, 0), at(0.75, 0));
  EXPECT_EQ(at(std::nan(""), std::numeric_limits<double>::infinity()), at(0, 0));
  for (const double u : {1e300, -1e300, -1e-300, 0x1.fffffffffffffp-1}) {
    for (const TextureEdges edges :
         {TextureEdges::Repeated, TextureEdges::Wrapped, TextureEdges::Clamped}) {
      const Vec3d colour = texture.at(u, u, edges);
      EXPECT_GE(colour.x, 0.0) << u;
      EXPECT_LE(colour.x, 1.0) << u;
    }
  }
}

}  // namespace
}  // namespace planetree::test
