#pragma once

#include <planetree/kd_tree.hpp>
#include <planetree/mesh/triangle_mesh.hpp>
#include <planetree/scene.hpp>
#include <planetree/split/build_control.hpp>
#include <planetree/split/build_options.hpp>

#include <concepts>
#include <span>
#include <utility>
#include <vector>

/// `buildTree`, one overload for each way to hand over objects.
///
/// What comes by value (a vector, a `TriangleMesh`) is owned by the tree; move it in to avoid a
/// copy. What comes as a view (a span, a `TriangleMeshView`) stays the caller's and must outlive
/// the tree unchanged. A scene is a mixture of both.
///
/// Objects that cannot be hit (bad indices, coordinates that are not finite, null pointers) are
/// left out, counted and named in `tree.report()`; the others keep their numbers. Without any
/// object the tree is one empty leaf.
///
/// Throws `Error` with `InvalidOption` for an option out of range, `CapacityExceeded` for more
/// objects, references or nodes than docs/limits.md allows, `MemoryLimitExceeded` and `Cancelled`
/// as `BuildControl` says, and whatever a shape's own `bounds` and `clippedBounds` throw. Then
/// there is no tree, and nothing is left of it. Takes O(N log N) time, where N counts references:
/// `BuildOptions::referencesPerObject` bounds them. Uses `BuildOptions::threadCount` threads; the
/// tree is the same, byte for byte, for any number. Several trees may be built at once.
namespace planetree {

/// Faces come with their mesh, not one by one: a tree of faces finds them through it.
template <class O>
concept ObjectByItself = Object<O> && !detail::kIsFace<O>;

template <ObjectByItself O>
[[nodiscard]] KdTree<O> buildTree(std::vector<O> objects, const BuildOptions& options = {},
                                  const BuildControl& control = {}) {
  std::vector<detail::GeometryEntry<ScalarOf<O>>> entries;
  entries.push_back(detail::ownedEntry(std::move(objects)));
  return KdTree<O>(detail::buildTreeData(std::move(entries), options, control));
}

template <ObjectByItself O>
[[nodiscard]] KdTree<O> buildTree(std::span<const O> objects, const BuildOptions& options = {},
                                  const BuildControl& control = {}) {
  std::vector<detail::GeometryEntry<ScalarOf<O>>> entries;
  entries.push_back(detail::viewedEntry(objects));
  return KdTree<O>(detail::buildTreeData(std::move(entries), options, control));
}
template <ObjectByItself O>
[[nodiscard]] KdTree<O> buildTree(std::span<O> objects, const BuildOptions& options = {},
                                  const BuildControl& control = {}) {
  return buildTree(std::span<const O>(objects), options, control);
}

template <std::floating_point T>
[[nodiscard]] KdTree<Face<T>> buildTree(TriangleMesh<T> mesh, const BuildOptions& options = {},
                                        const BuildControl& control = {}) {
  std::vector<detail::GeometryEntry<T>> entries;
  entries.push_back(detail::ownedEntry(std::move(mesh)));
  return KdTree<Face<T>>(detail::buildTreeData(std::move(entries), options, control));
}

template <std::floating_point T>
[[nodiscard]] KdTree<Face<T>> buildTree(TriangleMeshView<T> mesh, const BuildOptions& options = {},
                                        const BuildControl& control = {}) {
  std::vector<detail::GeometryEntry<T>> entries;
  entries.push_back(detail::viewedEntry(mesh));
  return KdTree<Face<T>>(detail::buildTreeData(std::move(entries), options, control));
}

template <std::floating_point T>
[[nodiscard]] KdTree<AnyObject<T>> buildTree(const Scene<T>& scene,
                                             const BuildOptions& options = {},
                                             const BuildControl& control = {}) {
  const auto entries = scene.entries();
  return KdTree<AnyObject<T>>(
      detail::buildTreeData(std::vector(entries.begin(), entries.end()), options, control));
}

}  // namespace planetree
