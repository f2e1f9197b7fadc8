#pragma once

#include "render/render_image.hpp"
#include "scene/build_scene.hpp"

#include "support/random.hpp"

#include <cstdint>
#include <utility>

/// Small scenes with materials and lights, made in code.
namespace planetree::test {

inline std::uint32_t addMaterial(scene::SceneDescription& scene, scene::Material material) {
  scene.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

/// A square across the left half of the view, up to x = `edge` at z = -1, that glows white. Seen by
/// the view of the `.ray` format, whose picture at that distance is from -0.5 to 0.5.
inline scene::SceneDescription halfPlane(double edge) {
  scene::SceneDescription description;
  description.view = scene::View{};
  scene::Material white;
  white.emissive.value = {1, 1, 1};
  const std::uint32_t material = addMaterial(description, white);
  description.shapes.push_back({.shape = scene::UnitSquare{},
                                .placement = scene::Affine::translation({edge - 5, 0, -1}) *
                                             scene::Affine::scaling({10, 10, 1}),
                                .material = material});
  return description;
}

/// Shapes of all kinds at random places, matt, mirrors and glass, in front of the usual view.
inline scene::SceneDescription manyShapes(std::uint32_t count, std::uint32_t seed) {
  Random random(seed);
  scene::SceneDescription description;
  description.view = scene::View{};
  description.ambientLight = {0.2, 0.2, 0.2};
  description.pointLights.push_back(
      {.position = {3, 6, 2}, .colour = {1, 1, 1}, .constant = 1, .quadratic = 0});
  description.directionalLights.push_back({.direction = {-1, -2, -1}, .colour = {0.4, 0.4, 0.5}});
  for (std::uint32_t i = 0; i < count; ++i) {
    scene::Material material;
    const auto colour = [&] {
      return Vec3d{random.between(0.1, 1.0), random.between(0.1, 1.0), random.between(0.1, 1.0)};
    };
    material.diffuse.value = colour();
    material.ambient.value = material.diffuse.value;
    if (i % 4 == 1)
      material.reflective.value = {0.5, 0.5, 0.5};
    if (i % 4 == 2) {
      material.transmissive.value = {0.7, 0.8, 0.7};
      material.index.value = 1.3;
    }
    material.specular.value = {0.4, 0.4, 0.4};
    material.shininess.value = 30;
    const scene::ShapeDescription shapes[] = {scene::UnitSphere{}, scene::UnitBox{},
                                              scene::ConeShape{}, scene::UnitCylinder{}};
    const double size = random.between(0.15, 0.5);
    description.shapes.push_back(
        {.shape = shapes[i % 4],
         .placement =
             scene::Affine::translation({random.between(-4.0, 4.0), random.between(-4.0, 4.0),
                                         random.between(-12.0, -4.0)}) *
             scene::Affine::rotation(colour(), random.between(0.0, 6.0)) *
             scene::Affine::scaling({size, size, size}),
         .material = addMaterial(description, material)});
  }
  return description;
}

/// A scene, the tree's tracer, and how to look at it.
struct ScenePicture {
  explicit ScenePicture(scene::SceneDescription description)
      : scene(std::move(description)), tracer(scene.tree()) {}

  [[nodiscard]] render::RenderSettings settings(
      render::ImageSize size, render::RenderMode mode = render::RenderMode::Whitted) const {
    render::RenderSettings settings;
    settings.size = size;
    settings.view = scene.description().view;
    settings.mode = mode;
    settings.scene = &scene;
    settings.grid = render::SampleGrid{.side = 1};
    return settings;
  }

  scene::BuiltScene scene;
  render::TreeTracer<AnyObject<float>> tracer;
};

}  // namespace planetree::test
