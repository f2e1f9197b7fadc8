#pragma once

#include "scene/json_format/json_text.hpp"
#include "scene/json_format/json_value.hpp"
#include "scene/read_scene.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace planetree::scene::json_format {

/// The path of a file that the scene names. Throws `Error` if it is no path.
[[nodiscard]] std::filesystem::path filePathOf(const JsonText& text, const Value& value,
                                               const std::filesystem::path& folder,
                                               std::string_view what);

/// An error of a file that the scene names, with the place where it does.
[[nodiscard]] Error errorOfFile(const JsonText& text, const Value& value, std::string_view what,
                                const Error& error);

/// Reads textures, each file once.
class TextureTable {
 public:
  TextureTable(const JsonText& text, const std::filesystem::path& folder,
               const SceneFileReaders& readers, SceneDescription& scene) noexcept
      : text_(text), folder_(folder), readers_(readers), scene_(scene) {}

  /// The index of the texture in a file; `value` is its name.
  [[nodiscard]] std::uint32_t read(const Value& value);
  /// That of a texture that has one colour everywhere.
  [[nodiscard]] std::uint32_t addColour(const Vec3d& colour);

 private:
  const JsonText& text_;
  const std::filesystem::path& folder_;
  const SceneFileReaders& readers_;
  SceneDescription& scene_;
  std::map<std::string, std::uint32_t> indices_;  ///< by the name of the file
};

}  // namespace planetree::scene::json_format
