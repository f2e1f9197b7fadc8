#pragma once

#include "picture_format.hpp"
#include "picture_metadata.hpp"
#include "render_command.hpp"

#include "render/image.hpp"

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

/// The file of a picture: what it is called, and what is in it.
namespace planetree::tool {

[[nodiscard]] std::string_view formatName(PictureFormat format) noexcept;
[[nodiscard]] PictureFormat chosenFormat(const RenderCommand& command);

[[nodiscard]] std::filesystem::path outputPath(const RenderCommand& command);
[[nodiscard]] bool isStandardOutput(const RenderCommand& command);

/// A name that promises another kind of file is refused, as is one that would make the picture
/// replace its model.
void checkOutputName(const RenderCommand& command);

/// The bytes of a picture's file, and how large the picture is with its legend.
struct PictureFile {
  std::vector<std::byte> bytes;
  render::ImageSize size;
};

[[nodiscard]] PictureFile encodePicture(const FinishedPicture& picture);

}  // namespace planetree::tool
