#pragma once

#include "render/image.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace planetree::test {

/// A PNG file as it was read.
struct PngFile {
  render::Image image;
  std::map<std::string, std::string> texts;  ///< its text chunks, by their keyword
  bool isSrgb = false;                       ///< whether it says that it is
};

/// Reads a PNG file with eight bits a channel; nothing if it is not one, or damaged.
[[nodiscard]] std::optional<PngFile> readPng(std::span<const std::byte> bytes);
[[nodiscard]] std::optional<PngFile> readPng(const std::string& bytes);
[[nodiscard]] std::optional<PngFile> readPng(const std::filesystem::path& path);

}  // namespace planetree::test
