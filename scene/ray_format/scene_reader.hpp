#pragma once

#include "scene/ray_format/camera_reader.hpp"
#include "scene/ray_format/material_reader.hpp"
#include "scene/ray_format/shape_reader.hpp"
#include "scene/ray_format/texture_reader.hpp"
#include "scene/ray_format/token_reader.hpp"
#include "scene/scene_description.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace planetree::scene::ray_format {

/// Reads a whole scene. Groups and transforms that are open are kept on a stack of its own, so that
/// no depth of nesting exhausts that of the thread.
class SceneReader {
 public:
  /// All must outlive it.
  SceneReader(const Lexer& lexer, const std::filesystem::path& folder, SceneDescription& scene);

  void read();

 private:
  enum class LevelKind : std::uint8_t { Scene, Group, Transform };

  /// The scene, or a group or transform in it that is not closed yet.
  struct Level {
    LevelKind kind;
    Token begin;  ///< its brace or keyword
    Surroundings surroundings;
    bool isFilled = false;  ///< a transform that has what it transforms
  };

  void readHeader();
  /// One statement, in the innermost level; false at the end of the scene.
  [[nodiscard]] bool readStatement();
  void readInScene(const Token& token);
  void readInGroup(const Token& token);
  void readInTransform(const Token& token);
  /// A shape, or the beginning of a transform or group; false if it is something else.
  [[nodiscard]] bool readElement(const Token& token);
  void readMaterial();
  void open(LevelKind kind, const Token& begin, const Surroundings& surroundings);
  void close();
  [[nodiscard]] Error unclosed() const;

  Remarks remarks_;
  TokenReader tokens_;
  SceneDescription& scene_;
  TextureReader textures_;
  MaterialReader materials_;
  CameraReader camera_;
  std::vector<Level> levels_;
};

}  // namespace planetree::scene::ray_format
