#pragma once

#include "scene/read_scene.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Scenes in the `.ray` format that stand in the tests themselves.
namespace planetree::test {

inline const std::filesystem::path kSceneFolder =
    std::filesystem::path(PLANETREE_REPOSITORY) / "data/scenes";

/// The whole text of a scene. Textures are those of data/scenes.
inline scene::SceneDescription readText(std::string_view text) {
  return scene::readRayScene(std::as_bytes(std::span(text)), "test.ray", kSceneFolder);
}

/// The statements of a scene, from the second line on.
inline scene::SceneDescription readStatements(const std::string& statements) {
  return readText("SBT-raytracer 1.0\n" + statements);
}

/// What the error says; "no error" if there is none.
inline std::string errorOfText(std::string_view text) {
  try {
    static_cast<void>(readText(text));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::MalformedFile);
    EXPECT_EQ(error.file(), "test.ray");
    EXPECT_GE(error.line(), 1);
    EXPECT_GE(error.column(), 1);
    return error.what();
  }
  return "no error";
}
inline std::string errorOf(const std::string& statements) {
  return errorOfText("SBT-raytracer 1.0\n" + statements);
}

}  // namespace planetree::test
