#pragma once

#include "render/file/metadata.hpp"
#include "render/image.hpp"

#include <cstddef>
#include <vector>

namespace planetree::render {

/// The picture as a PNG file in memory, marked as sRGB. Metadata become text chunks in front of the
/// pixels: tEXt where the text is ASCII, iTXt where it is not. The same picture always gives the
/// same bytes. Throws std::bad_alloc if memory runs out.
[[nodiscard]] std::vector<std::byte> encodePng(const Image& image, const Metadata& metadata = {});

}  // namespace planetree::render
