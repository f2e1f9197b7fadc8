#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace planetree::scene::detail {

/// Whether stb_image would take the bytes for a JPEG file.
[[nodiscard]] bool isJpeg(std::span<const std::byte> bytes) noexcept;

/// A copy of a JPEG file that is safe to be decoded by stb_image; nothing if there is none.
///
/// stb_image 2.27 writes beyond its tables where a file defines more than the 256 codes that a
/// Huffman table can have ("stbi__build_huffman"). Which definitions it comes to see depends on how
/// it finds its way through a damaged file; so all that could be one is looked at, after what
/// cameras add, which may look like anything, is left out.
[[nodiscard]] std::optional<std::vector<std::byte>> guardedJpeg(std::span<const std::byte> bytes);

}  // namespace planetree::scene::detail
