#pragma once

#include "import/import_mesh.hpp"

#include "scene/scene_description.hpp"

#include <filesystem>

namespace planetree::importing {

/// Reads a model in any format that `importMesh` reads as a scene: its parts with their normals and
/// texture coordinates, each where the file places it, with materials, textures, lights and the
/// first camera. docs/model_files.md says what becomes of them. A part that is placed several times
/// is there once, and shared.
///
/// glTF, OBJ with its MTL files, COLLADA and the other formats with materials are read by assimp,
/// in a process of its own as with `importMesh`; PLY, STL and OFF, and what comes through a pipe,
/// as `importMesh` does, with one material. An OBJ file that assimp refuses is read so, too, with a
/// remark.
///
/// A texture that cannot be had is no error: its surface gets a plain colour, and `remarks` say so,
/// as they say of faces, points and lines that are left out.
/// A file without lights gets the lighting of `addDefaultLighting`.
///
/// Throws what `importMesh` throws. Any thread may call it.
[[nodiscard]] scene::SceneDescription importScene(const std::filesystem::path& path,
                                                  ImportReport* report = nullptr);

}  // namespace planetree::importing
