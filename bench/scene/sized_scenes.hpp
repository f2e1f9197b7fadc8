#pragma once

#include "bench/scene/load_scene.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Scenes of any size, made in code: what building costs is measured over three orders of magnitude
/// of one kind of scene. They are the same everywhere but for the rounding of the mathematical
/// functions, and never change: figures of different years are compared on them.
namespace planetree::bench {

/// A name such as "terrain-10k" or "scatter-4m", which stands where otherwise a file is named.
struct SizedSceneName {
  std::string family;           ///< "terrain" or "scatter"
  std::uint64_t triangles = 0;  ///< about as many as the scene has
};

inline constexpr std::uint64_t kFewestSizedTriangles = 1'000;
inline constexpr std::uint64_t kMostSizedTriangles = 100'000'000;

/// A family, a dash and a number of triangles, in which k stands for thousands and m for millions;
/// nothing for all other names.
[[nodiscard]] std::optional<SizedSceneName> sizedSceneName(std::string_view name);

/// The mountains of `makeTerrain` with about as many triangles as asked for, and details down
/// to the size of a few of them.
[[nodiscard]] TriangleMesh<float> makeSizedTerrain(std::uint64_t triangles);

/// Small rings and balls of any size and orientation, in clusters of different density within a
/// cube: a soup of many separate meshes with much empty space. It has at least as many triangles as
/// asked for, and a few hundred more at most.
[[nodiscard]] TriangleMesh<float> makeScatter(std::uint64_t triangles);

/// The scene of that name, looked at from outside.
[[nodiscard]] BenchScene makeSizedScene(const SizedSceneName& size, std::string name);

}  // namespace planetree::bench
