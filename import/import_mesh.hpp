#pragma once

#include <planetree/mesh/read_mesh.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace planetree::importing {

/// What importing found beside the mesh. Nothing is dropped in silence.
struct ImportReport : MeshReadReport {
  std::string formatName;            ///< "PLY", "STL", "OBJ", "OFF", or what assimp calls it
  std::vector<std::string> remarks;  ///< what assimp warns of: the first few, each once
  std::uint64_t remarkCount = 0;     ///< all of them, repeated ones too
};

/// Reads a model in any format that planetree knows: PLY, STL, OBJ and OFF as `readMesh` does,
/// and through assimp glTF 2.0, COLLADA, FBX, 3DS and what else it reads.
///
/// A scene of many parts becomes one mesh: each part is there as often as the scene places it, and
/// where it is placed. Only positions and polygons are read, in the pose in which they are stored:
/// no animation, materials, normals or cameras. Polygons become triangles as in `readMesh`, equal
/// vertices become one, and points and lines are counted as unread primitives. A polygon's source
/// index counts through the parts in the order of the scene.
///
/// assimp runs in a process of its own, `planetree-assimp`, since bad bytes can make it crash, run
/// for ever or eat all memory: then the process is ended, and the error says so. What it answers is
/// checked like a file.
///
/// Throws what `readMesh` throws. Any thread may call it.
template <std::floating_point T>
[[nodiscard]] TriangleMesh<T> importMesh(const std::filesystem::path& path,
                                         ImportReport* report = nullptr);

extern template TriangleMesh<float> importMesh<float>(const std::filesystem::path&, ImportReport*);
extern template TriangleMesh<double> importMesh<double>(const std::filesystem::path&,
                                                        ImportReport*);

}  // namespace planetree::importing
