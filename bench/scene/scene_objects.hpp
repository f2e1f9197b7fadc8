#pragma once

#include <planetree/mesh/triangle_mesh.hpp>
#include <planetree/shape/geometry.hpp>
#include <planetree/shape/sphere.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <variant>

namespace planetree::bench {

/// A shape that was chosen at run time.
using VirtualShape = std::unique_ptr<const Geometry<float>>;

/// What a scene is made of, by reference: the triangles of a mesh, spheres, or shapes of any kind.
/// The arrays must outlive it.
class SceneObjects {
 public:
  // Implicit: wherever objects are asked for, a mesh is an answer.
  SceneObjects(const TriangleMesh<float>& mesh) : objects_(&mesh) {}
  SceneObjects(std::span<const Sphere<float>> spheres) : objects_(spheres) {}
  SceneObjects(std::span<const VirtualShape> shapes) : objects_(shapes) {}

  /// The mesh, or null if these are shapes.
  [[nodiscard]] const TriangleMesh<float>* mesh() const noexcept {
    const auto* const mesh = std::get_if<const TriangleMesh<float>*>(&objects_);
    return mesh != nullptr ? *mesh : nullptr;
  }

  /// Calls `visitor` with the view of the mesh, or with the span of the shapes: with something that
  /// `buildTree` takes, and whose `operator[]` gives an `Object`.
  template <class Visitor>
  decltype(auto) visit(Visitor&& visitor) const {
    return std::visit(
        [&](const auto& objects) -> decltype(auto) { return visitor(viewOf(objects)); }, objects_);
  }

  [[nodiscard]] std::size_t size() const {
    return visit([](const auto& objects) { return objects.size(); });
  }

 private:
  static TriangleMeshView<float> viewOf(const TriangleMesh<float>* mesh) { return mesh->view(); }
  template <class S>
  static std::span<const S> viewOf(std::span<const S> shapes) {
    return shapes;
  }

  std::variant<const TriangleMesh<float>*, std::span<const Sphere<float>>,
               std::span<const VirtualShape>>
      objects_;
};

}  // namespace planetree::bench
