#pragma once

#include "render/image.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace planetree::test {

/// The picture in a PNG file, or nothing if there is none. Kept apart from the code that writes, so
/// that the two cannot share a mistake.
[[nodiscard]] std::optional<render::Image> readPng(std::span<const std::byte> bytes);
[[nodiscard]] std::optional<render::Image> readPng(const std::filesystem::path& path);

}  // namespace planetree::test
