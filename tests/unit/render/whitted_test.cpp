#include "render/whitted/whitted.hpp"

#include "render/whitted/refraction.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

// Single rays, and the light that they must bring back, worked out by hand.
namespace planetree::test {
namespace {

using render::RayCounter;
using render::Whitted;
using render::WhittedSettings;
using scene::Affine;
using scene::BuiltScene;
using scene::Material;
using scene::SceneDescription;
using scene::ShapeDescription;

std::uint32_t add(SceneDescription& scene, const ShapeDescription& shape, const Affine& placement,
                  Material material) {
  const auto index = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back(std::move(material));
  scene.shapes.push_back({.shape = shape, .placement = placement, .material = index});
  return index;
}

Material glowing(const Vec3d& colour) {
  Material material;
  material.emissive.value = colour;
  return material;
}

Material matt(const Vec3d& colour) {
  Material material;
  material.diffuse.value = colour;
  return material;
}

Material mirror(const Vec3d& colour) {
  Material material;
  material.reflective.value = colour;
  return material;
}

Material glass(const Vec3d& colour, double index) {
  Material material;
  material.transmissive.value = colour;
  material.index.value = index;
  return material;
}

Vec3d lightAlong(SceneDescription description, const Vec3d& origin, const Vec3d& direction,
                 const WhittedSettings& settings = {}) {
  const BuiltScene built(std::move(description));
  const render::TreeTracer<AnyObject<float>> tracer(built.tree());
  RayCounter counter(tracer);
  const Rayf ray{.origin = Vec3f(origin), .direction = Vec3f(normalized(direction))};
  return Whitted(built, settings).radiance(counter, std::span(&ray, 1)).front();
}

void expectLight(const Vec3d& light, const Vec3d& expected, double tolerance = 2e-5) {
  EXPECT_NEAR(light.x, expected.x, tolerance);
  EXPECT_NEAR(light.y, expected.y, tolerance);
  EXPECT_NEAR(light.z, expected.z, tolerance);
}

/// A square facing +z in the plane z = `height`.
Affine floorAt(double height, double size = 100.0) {
  return Affine::translation({0, 0, height}) * Affine::scaling({size, size, 1});
}

constexpr Vec3d kDown{0, 0, -1};

TEST(Whitted, NothingIsBlack) {
  expectLight(lightAlong({}, {0, 0, 1}, kDown), {0, 0, 0});
}

TEST(Whitted, SurfacesGlowAndHaveTheirPartOfAmbientLight) {
  SceneDescription scene;
  scene.ambientLight = {0.5, 0.25, 1.0};
  Material material = glowing({0.1, 0.2, 0.3});
  material.ambient.value = {0.2, 0.4, 0.6};
  add(scene, scene::UnitSquare{}, floorAt(0), material);
  expectLight(lightAlong(scene, {0, 0, 1}, kDown), {0.2, 0.3, 0.9});
}

TEST(Whitted, DirectionalLightFallsAsTheCosine) {
  SceneDescription scene;
  scene.directionalLights.push_back({.direction = {3, 0, -4}, .colour = {1, 0.5, 0.25}});
  add(scene, scene::UnitSquare{}, floorAt(0), matt({0.5, 1, 1}));
  expectLight(lightAlong(scene, {0, 0, 1}, kDown), {0.4, 0.4, 0.2});
}

TEST(Whitted, PointLightFadesWithDistanceAndNeverGrows) {
  for (const double height : {0.5, 2.0, 5.0}) {
    SceneDescription scene;
    scene.pointLights.push_back({.position = {0, 0, height},
                                 .colour = {1, 1, 1},
                                 .constant = 0.25,
                                 .linear = 0.5,
                                 .quadratic = 0.125});
    add(scene, scene::UnitSquare{}, floorAt(0), matt({1, 1, 1}));
    const double fading = 0.25 + 0.5 * height + 0.125 * height * height;
    const double light = std::min(1.0, 1.0 / fading);
    expectLight(lightAlong(scene, {0.0, 0, 1}, kDown), {light, light, light});
  }
}

TEST(Whitted, HighlightIsThePowerOfTheCosineToTheMirrorDirection) {
  SceneDescription scene;
  scene.directionalLights.push_back({.direction = {0, 0, -1}, .colour = {1, 1, 1}});
  Material material;
  material.specular.value = {0.5, 0.5, 0.5};
  material.shininess.value = 3.0;
  add(scene, scene::UnitSquare{}, floorAt(0), material);
  // The mirror image of the light goes up, and the eye is 3-4-5 aside.
  const double light = 0.5 * std::pow(0.8, 3.0);
  expectLight(lightAlong(scene, {3, 0, 4}, {-3, 0, -4}), {light, light, light});
}

TEST(Whitted, ShadowsHaveTheColourOfAllThatTheLightHasPassed) {
  SceneDescription scene;
  scene.directionalLights.push_back({.direction = {0, 0, -1}, .colour = {1, 1, 1}});
  add(scene, scene::UnitSquare{}, floorAt(0), matt({1, 1, 1}));
  // More surfaces than are looked for at a time, none of which bends a shadow ray.
  Vec3d expected{1, 1, 1};
  for (int i = 0; i < 11; ++i) {
    const Vec3d colour{0.9, i % 2 == 0 ? 0.8 : 1.0, 1.0 - 0.05 * i};
    add(scene, scene::UnitSquare{}, floorAt(2.0 + i), glass(colour, 1.5));
    expected = {expected.x * colour.x, expected.y * colour.y, expected.z * colour.z};
  }
  expectLight(lightAlong(scene, {0, 0, 1}, kDown), expected);
}

TEST(Whitted, AnOpaqueSurfaceAmongGlassMakesTheShadowBlack) {
  SceneDescription scene;
  scene.directionalLights.push_back({.direction = {0, 0, -1}, .colour = {1, 1, 1}});
  add(scene, scene::UnitSquare{}, floorAt(0), matt({1, 1, 1}));
  add(scene, scene::UnitSquare{}, floorAt(2), glass({0.5, 0.5, 0.5}, 1.0));
  add(scene, scene::UnitSphere{}, Affine::translation({0, 0, 5}), matt({1, 1, 1}));
  expectLight(lightAlong(scene, {0, 0, 1}, kDown), {0, 0, 0});
  expectLight(lightAlong(scene, {0, 0, 1}, kDown, {.hasShadows = false}), {1, 1, 1});
}

TEST(Whitted, WhatStandsBehindAPointLightCastsNoShadow) {
  SceneDescription scene;
  scene.pointLights.push_back(
      {.position = {0, 0, 2}, .colour = {1, 1, 1}, .constant = 1, .quadratic = 0});
  add(scene, scene::UnitSquare{}, floorAt(0), matt({1, 1, 1}));
  add(scene, scene::UnitSquare{}, floorAt(3), matt({1, 1, 1}));
  expectLight(lightAlong(scene, {0, 0, 1}, kDown), {1, 1, 1});
}

TEST(Whitted, MirrorsShowWhatLiesInTheMirrorDirection) {
  SceneDescription scene;
  add(scene, scene::UnitSquare{}, floorAt(0), mirror({0.5, 0.25, 1}));
  add(scene, scene::UnitSphere{}, Affine::translation({-6, 0, 8}), glowing({0.8, 0.8, 0.4}));
  expectLight(lightAlong(scene, {6, 0, 8}, {-6, 0, -8}), {0.4, 0.2, 0.4});
}

TEST(Whitted, TwoMirrorsGoOnAsFarAsTheDepthLets) {
  SceneDescription scene;
  Material material = mirror({0.5, 0.5, 0.5});
  material.emissive.value = {1, 1, 1};
  add(scene, scene::UnitSquare{}, floorAt(0), material);
  add(scene, scene::UnitSquare{}, floorAt(2), material);
  for (const std::uint32_t depth : {0u, 1u, 4u, 20u}) {
    const double light = 2.0 - std::pow(0.5, depth);
    expectLight(lightAlong(scene, {0, 0, 1}, kDown, {.depthLimit = depth}), {light, light, light});
  }
}

TEST(Whitted, AGlassPlateShiftsWhatIsSeenThroughIt) {
  constexpr double kIndex = 1.5;
  // At 45 degrees, through a plate one thick, onto a wall one below it.
  const double inside = std::asin(std::sqrt(0.5) / kIndex);
  const double x = std::tan(inside) + 1.0;
  for (const double besides : {-0.02, 0.02}) {
    SceneDescription scene;
    add(scene, scene::UnitBox{}, Affine::translation({0, 0, -0.5}) * Affine::scaling({50, 50, 1}),
        glass({0.5, 1, 1}, kIndex));
    // The wall glows left of where the ray arrives, or also there.
    const double width = 10.0;
    add(scene, scene::UnitSquare{},
        Affine::translation({x - width / 2 + besides, 0, -2}) * Affine::scaling({width, 1, 1}),
        glowing({1, 1, 1}));
    const Vec3d expected = besides > 0 ? Vec3d{0.25, 1, 1} : Vec3d{0, 0, 0};
    expectLight(lightAlong(scene, {-1, 0, 1}, {1, 0, -1}), expected);
  }
}

TEST(Whitted, BeyondTheCriticalAngleNothingPasses) {
  constexpr double kIndex = 1.5;
  const double critical = std::asin(1.0 / kIndex);
  for (const double angle : {critical - 0.01, critical + 0.01}) {
    SceneDescription scene;
    add(scene, scene::UnitBox{}, Affine::scaling({100, 100, 2}), glass({1, 1, 1}, kIndex));
    add(scene, scene::UnitBox{}, Affine::translation({0, 0, 10}) * Affine::scaling({1e4, 1e4, 1}),
        glowing({1, 1, 1}));
    const double seen = angle < critical ? 1.0 : 0.0;
    // From within the glass.
    expectLight(lightAlong(scene, {0, 0, 0}, {std::sin(angle), 0, std::cos(angle)}),
                {seen, seen, seen});
  }
}

TEST(Whitted, AGlassBallTurnsThePictureUpsideDown) {
  SceneDescription scene;
  add(scene, scene::UnitSphere{}, {}, glass({1, 1, 1}, 1.5));
  add(scene, scene::UnitBox{}, Affine::translation({0, 5, -12}) * Affine::scaling({10, 10, 1}),
      glowing({1, 0, 0}));
  add(scene, scene::UnitBox{}, Affine::translation({0, -5, -12}) * Affine::scaling({10, 10, 1}),
      glowing({0, 1, 0}));
  expectLight(lightAlong(scene, {0, 0.4, 5}, kDown), {0, 1, 0});
  expectLight(lightAlong(scene, {0, -0.4, 5}, kDown), {1, 0, 0});
}

TEST(Whitted, NormalsOfCornersAreInterpolatedUnlessTheyAreNotWanted) {
  auto mesh = std::make_shared<scene::MeshShape>();
  mesh->positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
  mesh->faces = {{0, 1, 2}};
  const Vec3d tilted = normalized(Vec3d{3, 0, 4});
  mesh->normals = {tilted, tilted, tilted};
  SceneDescription scene;
  scene.directionalLights.push_back({.direction = {0, 0, -1}, .colour = {1, 1, 1}});
  add(scene, mesh, {}, matt({1, 1, 1}));
  expectLight(lightAlong(scene, {0, 0, 1}, kDown), {0.8, 0.8, 0.8});
  expectLight(lightAlong(scene, {0, 0, 1}, kDown, {.isSmooth = false}), {1, 1, 1});
  // Mirrored the normals are mirrored, too, and the face still faces up.
  scene.shapes.front().placement = Affine::scaling({-1, 1, 1});
  scene.directionalLights.front().direction = {-3, 0, 4};
  expectLight(lightAlong(scene, {0, 0, 1}, kDown), {0, 0, 0});
  scene.directionalLights.front().direction = {3, 0, -4};
  expectLight(lightAlong(scene, {0, 0, 1}, kDown), {1, 1, 1});
}

TEST(Whitted, MaterialsOfCornersAreInterpolated) {
  auto mesh = std::make_shared<scene::MeshShape>();
  mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}};
  mesh->faces = {{0, 1, 2}};
  mesh->vertexMaterials = {0, 1, 2};
  SceneDescription scene;
  scene.materials = {glowing({1, 0, 0}), glowing({0, 1, 0}), glowing({0, 0, 1})};
  scene.shapes.push_back({.shape = mesh, .placement = {}, .material = 0});
  expectLight(lightAlong(scene, {-0.5, -0.5, 1}, kDown), {0.5, 0.25, 0.25});
}

TEST(Refraction, FollowsSnellBothWays) {
  Random random(5);
  const Vec3d normal{0, 0, 1};
  for (int i = 0; i < 1000; ++i) {
    const double index = random.between(1.0, 3.0);
    const double angle = random.between(0.0, std::numbers::pi / 2 - 1e-6);
    const Vec3d incoming{std::sin(angle), 0, -std::cos(angle)};
    const auto inside = render::refracted(incoming, normal, index);
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->x, std::sin(angle) / index, 1e-12);
    EXPECT_LT(inside->z, 0.0);
    // And the way back.
    const auto outside = render::refracted(-*inside, normal, index);
    ASSERT_TRUE(outside);
    EXPECT_NEAR(length(*outside + incoming), 0.0, 1e-7);
  }
}

}  // namespace
}  // namespace planetree::test
