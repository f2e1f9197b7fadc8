#pragma once

#include "import/import_mesh.hpp"

#include "scene/scene_description.hpp"

#include <planetree/mesh/triangle_mesh.hpp>

#include <chrono>
#include <concepts>
#include <cstdint>
#include <filesystem>

namespace planetree::importing {

/// What a reading process is, and what it may use.
struct ReaderLimits {
  std::filesystem::path program;   ///< speaks as message.hpp says
  std::chrono::milliseconds time;  ///< until its last word
  std::uint64_t memory = 0;        ///< bytes of address space
};

/// `planetree-assimp`, and limits that leave much room for an honest file of this size.
[[nodiscard]] ReaderLimits usualLimits(std::uint64_t fileSize);

/// Has the program read the file. Throws `Error`, also if the program is missing, crashes, takes
/// too long or does not speak as it should.
template <std::floating_point T>
[[nodiscard]] TriangleMesh<T> readWithAssimp(const std::filesystem::path& path,
                                             const ReaderLimits& limits,
                                             ImportReport* report = nullptr);

/// The same for a scene, without default lighting and without a name.
[[nodiscard]] scene::SceneDescription readSceneWithAssimp(const std::filesystem::path& path,
                                                          const ReaderLimits& limits,
                                                          ImportReport* report = nullptr);

extern template TriangleMesh<float> readWithAssimp<float>(const std::filesystem::path&,
                                                          const ReaderLimits&, ImportReport*);
extern template TriangleMesh<double> readWithAssimp<double>(const std::filesystem::path&,
                                                            const ReaderLimits&, ImportReport*);

}  // namespace planetree::importing
