#pragma once

#include <planetree/detail/object_range.hpp>
#include <planetree/mesh/triangle_mesh.hpp>
#include <planetree/object.hpp>

#include <concepts>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace planetree {

/// What a geometry of a scene carries beside its shape.
struct GeometryOptions {
  /// Queries see the geometry only if their own mask shares a bit with this one.
  std::uint32_t mask = 0xFFFF'FFFFu;
  /// Never touched by the library; `KdTree::userPointer(hit.geometry)` returns it.
  void* userPointer = nullptr;
};

/// Several meshes and lists of shapes that go into one tree. Each `add` makes one geometry and
/// returns its id, counted from 0: the `geometry` of a hit. The index of a face or shape within its
/// geometry is the `primitive`.
///
/// What is handed over by value is owned by the scene and by every tree built from it. What is
/// handed over as a view or span stays the caller's: it must outlive those trees and must not
/// change while one exists.
///
/// Not to be changed from several threads at once.
template <std::floating_point T>
class Scene {
 public:
  using Scalar = T;

  std::uint32_t add(TriangleMesh<T> mesh, const GeometryOptions& options = {});
  std::uint32_t add(TriangleMeshView<T> mesh, const GeometryOptions& options = {});

  template <Object O>
  requires std::same_as<ScalarOf<O>, T> std::uint32_t add(std::vector<O> objects,
                                                          const GeometryOptions& options = {}) {
    return add(detail::ownedEntry(std::move(objects)), options);
  }
  template <Object O>
  requires std::same_as<ScalarOf<O>, T> std::uint32_t add(std::span<const O> objects,
                                                          const GeometryOptions& options = {}) {
    return add(detail::viewedEntry(objects), options);
  }
  template <Object O>
  requires std::same_as<ScalarOf<O>, T> std::uint32_t add(std::span<O> objects,
                                                          const GeometryOptions& options = {}) {
    return add(std::span<const O>(objects), options);
  }
  /// A geometry of a single object.
  template <Object O>
  requires std::same_as<ScalarOf<O>, T> std::uint32_t add(O object,
                                                          const GeometryOptions& options = {}) {
    std::vector<O> objects;
    objects.push_back(std::move(object));
    return add(std::move(objects), options);
  }

  [[nodiscard]] std::size_t geometryCount() const noexcept { return entries_.size(); }
  [[nodiscard]] std::span<const detail::GeometryEntry<T>> entries() const noexcept {
    return entries_;
  }

 private:
  std::uint32_t add(detail::GeometryEntry<T> entry, const GeometryOptions& options);

  std::vector<detail::GeometryEntry<T>> entries_;
};

extern template class Scene<float>;
extern template class Scene<double>;

}  // namespace planetree
