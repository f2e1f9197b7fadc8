#pragma once

#include "talk.hpp"

#include "import/import_mesh.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/mesh/triangle_mesh.hpp>

#include <concepts>
#include <filesystem>
#include <string>

namespace planetree::tool {

/// A model as it was read.
template <std::floating_point T>
struct Model {
  std::string name;  ///< for errors
  TriangleMesh<T> mesh;
  importing::ImportReport report;
};

/// Reads a model and says what it has. Throws `Error` if it cannot be read or has no triangles.
template <std::floating_point T>
[[nodiscard]] Model<T> readModel(const std::filesystem::path& path, const Talk& talk);

/// Throws `Error` if none of the triangles can be hit. `name` is that of the model.
void requireHittable(const BuildReport& report, const std::string& name);

/// Builds the tree, which takes the mesh, and says how that went; `control` is told nothing, a line
/// of progress is. Throws `Error` if none of the triangles can be hit, and as `buildTree` does.
template <std::floating_point T>
[[nodiscard]] KdTree<Face<T>> buildModelTree(Model<T> model, const BuildOptions& options,
                                             const BuildControl& control, const Talk& talk);

extern template Model<float> readModel<float>(const std::filesystem::path&, const Talk&);
extern template Model<double> readModel<double>(const std::filesystem::path&, const Talk&);
extern template KdTree<Face<float>> buildModelTree<float>(Model<float>, const BuildOptions&,
                                                          const BuildControl&, const Talk&);
extern template KdTree<Face<double>> buildModelTree<double>(Model<double>, const BuildOptions&,
                                                            const BuildControl&, const Talk&);

}  // namespace planetree::tool
