#pragma once

#include "render/file/channel_image.hpp"
#include "render/file/metadata.hpp"

#include <cstddef>
#include <vector>

namespace planetree::render {

/// The picture as an OpenEXR file in memory: scan lines, ZIP compression, which loses nothing.
/// Metadata become string attributes, named as OpenEXR names its own: "Tree Options" is
/// `treeOptions`. Values beyond the range of a half become infinite. The same picture always gives
/// the same bytes. Throws std::bad_alloc if memory runs out.
[[nodiscard]] std::vector<std::byte> encodeExr(const ChannelImage& image,
                                               const Metadata& metadata = {});

}  // namespace planetree::render
