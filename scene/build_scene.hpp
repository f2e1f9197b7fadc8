#pragma once

#include "scene/scene_description.hpp"

#include <planetree/any_object.hpp>
#include <planetree/build_tree.hpp>
#include <planetree/kd_tree.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace planetree::scene {

/// A place where a ray meets a scene, as shading wants to know it.
struct SurfacePoint {
  Vec3d position;
  /// Of unit length; that of the corners, interpolated, where a mesh has such. It points outward,
  /// wherever the ray comes from; on surfaces with two sides to where the ray comes from.
  Vec3d normal;
  MaterialSample material;
};

/// A scene in a tree: shapes of all kinds and meshes together. The transforms are applied once,
/// when it is built: what they make of a shape is again a shape of the library wherever it has such
/// a one (similar spheres, parallelograms, boxes as twelve triangles, cylinders and cones that stay
/// round and upright, meshes); only ellipsoids, elliptic or slanted cylinders and cones carry rays
/// into their own space.
///
/// Any thread may ask. Hits are those of `tree()`.
class BuiltScene {
 public:
  /// Throws as `buildTree` does.
  explicit BuiltScene(SceneDescription description, const BuildOptions& options = {},
                      const BuildControl& control = {});
  /// The same for a description that several trees share; it must not be null.
  explicit BuiltScene(std::shared_ptr<const SceneDescription> description,
                      const BuildOptions& options = {}, const BuildControl& control = {});
  BuiltScene(BuiltScene&&) noexcept;
  BuiltScene& operator=(BuiltScene&&) noexcept;
  ~BuiltScene();

  [[nodiscard]] const KdTree<AnyObject<float>>& tree() const noexcept;
  [[nodiscard]] const SceneDescription& description() const noexcept;

  /// The surface where `ray` meets the scene at `hit`. `isSmooth` false leaves out the normals that
  /// the corners of meshes have.
  [[nodiscard]] SurfacePoint surface(const Rayf& ray, const Hitf& hit, bool isSmooth = true) const;

  /// What part of light passes through the surface there: its material's `transmissive`.
  [[nodiscard]] Vec3d transmission(const Rayf& ray, const Hitf& hit) const;

  /// Whether any surface lets light through. If not, one hit is enough for a shadow.
  [[nodiscard]] bool hasTransparency() const noexcept;

  /// The light from a direction in which nothing is: the cube map, or black.
  [[nodiscard]] Vec3d background(const Vec3d& direction) const noexcept;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace planetree::scene
