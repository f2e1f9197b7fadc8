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
};

}  // namespace planetree::render
