#pragma once

#include <cstdint>

namespace planetree::tool {

/// What a picture's file is.
enum class PictureFormat : std::uint8_t {
  Png,  ///< as a screen shows it
  Exr,  ///< in numbers
};

}  // namespace planetree::tool
