#pragma once

#include "render/image.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace planetree::render {

/// How a channel is stored: colours in 16 bits, which is all that eyes can use, measured values in
/// 32.
enum class ChannelType : std::uint8_t { Half, Float };

/// One number for each pixel, row by row from the top left.
struct Channel {
  std::string name;
  ChannelType type = ChannelType::Float;
  std::vector<float> values;
};

/// A picture as numbers.
struct ChannelImage {
  ImageSize size;
  std::vector<Channel> channels;

  /// Where its upper left corner is in a whole picture of this size, of which it is a part; a size
  /// without pixels if it is none.
  std::uint32_t firstX = 0;
  std::uint32_t firstY = 0;
  ImageSize wholeSize = {};
};

}  // namespace planetree::render
