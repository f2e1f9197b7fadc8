#pragma once

#include "scene/json_format/json_text.hpp"
#include "scene/json_format/json_value.hpp"
#include "scene/read_scene.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace planetree::scene::json_format {

/// Reads the models that a scene names, each file once, and puts their materials and textures
/// beside those of the scene.
class ModelTable {
 public:
  ModelTable(const JsonText& text, const std::filesystem::path& folder,
             const SceneFileReaders& readers, SceneDescription& scene) noexcept
      : text_(text), folder_(folder), readers_(readers), scene_(scene) {}

  /// The shapes of a model where its file has them, but with the materials of the scene; with
  /// `material` all of them have that one. `value` is the name of the file.
  [[nodiscard]] std::vector<PlacedShape> shapesOf(const Value& value,
                                                  std::optional<std::uint32_t> material);

 private:
  const std::vector<PlacedShape>& read(const Value& value);

  const JsonText& text_;
  const std::filesystem::path& folder_;
  const SceneFileReaders& readers_;
  SceneDescription& scene_;
  std::map<std::string, std::vector<PlacedShape>> models_;  ///< by the name of the file
  /// Meshes without materials of their own, by the ones that have them.
  std::map<const MeshShape*, std::shared_ptr<const MeshShape>> plainMeshes_;
};

/// The box around shapes, but for rounding; `Box3` is empty if there are none.
[[nodiscard]] Box3 boundsOf(const std::vector<PlacedShape>& shapes);

}  // namespace planetree::scene::json_format
