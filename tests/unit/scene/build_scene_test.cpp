#include "scene/build_scene.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace planetree::test {
namespace {

using namespace scene;

Material coloured(const Vec3d& diffuse) {
  Material material;
  material.diffuse.value = diffuse;
  return material;
}

/// Two triangles in the plane z = 0 that make a square from 0 to 2, all lists in use, and a
/// material for each of its four corners and two faces.
MeshShape quad() {
  MeshShape mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

SceneDescription meshScene(MeshShape mesh, const Affine& placement = {}) {
  SceneDescription description;
  description.materials = {coloured({1, 0, 0}), coloured({0, 1, 0}), coloured({0, 0, 1}),
                           coloured({1, 1, 1})};
  description.shapes.push_back(
      {.shape = std::make_shared<const MeshShape>(std::move(mesh)), .placement = placement});
  return description;
}

/// What a ray straight down onto a point of the plane z = 0 sees there.
SurfacePoint seenAt(const SceneDescription& description, double x, double y) {
  const BuiltScene built(description);
  const Rayf ray{.origin = Vec3f(Vec3d{x, y, 5}), .direction = {0, 0, -1}};
  const auto hit = built.tree().findIntersection(ray);
  EXPECT_TRUE(hit);
  return hit ? built.surface(ray, *hit) : SurfacePoint{};
}

void expectNear(const Vec3d& a, const Vec3d& b, double tolerance = 1e-5) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

const Affine kMirror = Affine::scaling({-1, 1, 1});

TEST(MeshMaterials, OfFacesAreThoseOfTheFaceThatIsHit) {
  MeshShape mesh = quad();
  mesh.faceMaterials = {1, 2};
  expectNear(seenAt(meshScene(mesh), 1.5, 0.5).material.diffuse, {0, 1, 0});
  expectNear(seenAt(meshScene(mesh), 0.5, 1.5).material.diffuse, {0, 0, 1});
  expectNear(seenAt(meshScene(mesh, kMirror), -0.5, 1.5).material.diffuse, {0, 0, 1});
}

TEST(MeshMaterials, OfCornersAreMixedAlsoWhereTheMeshIsMirrored) {
  MeshShape mesh = quad();
  mesh.vertexMaterials = {0, 1, 2, 3};
  // On the first face the weights are (1 - x/2, (x - y)/2, y/2).
  const Vec3d expected{0.3, 0.5, 0.2};
  expectNear(seenAt(meshScene(mesh), 1.4, 0.4).material.diffuse, expected);
  expectNear(seenAt(meshScene(mesh, kMirror), -1.4, 0.4).material.diffuse, expected);
}

TEST(MeshMaterials, MixTheirNumbersAndWhatLightPasses) {
  MeshShape mesh = quad();
  mesh.vertexMaterials = {0, 1, 2, 3};
  SceneDescription description = meshScene(mesh);
  description.materials[0].index.value = 2.0;
  description.materials[1].shininess.value = 10.0;
  description.materials[2].transmissive.value = {0.5, 1, 0};
  const SurfacePoint point = seenAt(description, 1.4, 0.4);
  EXPECT_NEAR(point.material.index, 0.3 * 2 + 0.7, 1e-5);
  EXPECT_NEAR(point.material.shininess, 5, 1e-5);
  const BuiltScene built(description);
  EXPECT_TRUE(built.hasTransparency());
  const Rayf ray{.origin = {1.4f, 0.4f, 5}, .direction = {0, 0, -1}};
  expectNear(built.transmission(ray, *built.tree().findIntersection(ray)), {0.1, 0.2, 0});
}

TEST(MeshCoordinates, AreInterpolatedAlsoWhereTheMeshIsMirrored) {
  MeshShape mesh = quad();
  mesh.coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<Vec3f> texels;
  for (int i = 0; i < 16; ++i)
    texels.push_back({(static_cast<float>(i) + 0.5f) / 16.0f, 0, 0});
  for (const double side : {1.0, -1.0}) {
    SceneDescription description = meshScene(mesh, Affine::scaling({side, 1, 1}));
    description.textures.emplace_back(16, 1, texels);
    description.materials[0].diffuse = {.value = {1, 1, 1}, .texture = 0};
    EXPECT_NEAR(seenAt(description, side * 0.5, 1.0).material.diffuse.x, 0.25, 1e-5);
    EXPECT_NEAR(seenAt(description, side * 1.5, 0.5).material.diffuse.x, 0.75, 1e-5);
  }
}

TEST(MeshNormals, StayOutwardWhereTheMeshIsMirrored) {
  MeshShape mesh = quad();
  expectNear(seenAt(meshScene(mesh), 0.5, 0.7).normal, {0, 0, 1});
  expectNear(seenAt(meshScene(mesh, kMirror), -0.5, 0.7).normal, {0, 0, 1});
  expectNear(seenAt(meshScene(mesh, Affine::scaling({1, 1, -1})), 0.5, 0.7).normal, {0, 0, -1});
  const double half = std::sqrt(0.5);
  mesh.normals.assign(4, {3, 0, 3});
  expectNear(seenAt(meshScene(mesh), 0.5, 0.7).normal, {half, 0, half});
  expectNear(seenAt(meshScene(mesh, kMirror), -0.5, 0.7).normal, {-half, 0, half});
  // The inverse transpose: twice as wide, the normal leans half as much.
  const SurfacePoint wide = seenAt(meshScene(mesh, Affine::scaling({2, 1, 1})), 0.5, 0.7);
  expectNear(wide.normal, normalized(Vec3d{0.5, 0, 1}));
  mesh.normals.assign(4, {0, 0, 0});
  expectNear(seenAt(meshScene(mesh), 0.5, 0.7).normal, {0, 0, 1});
}

TEST(MeshNormals, OfTwoSidedMeshesAreOnTheSideOfTheRay) {
  MeshShape mesh = quad();
  mesh.normals.assign(4, {0.3, 0, 1});
  const Affine under = Affine::rotation({1, 0, 0}, 3.141592653589793);
  EXPECT_LT(seenAt(meshScene(mesh, under), 0.5, -0.7).normal.z, 0.0);
  mesh.isTwoSided = true;
  EXPECT_GT(seenAt(meshScene(mesh, under), 0.5, -0.7).normal.z, 0.0);
  EXPECT_GT(seenAt(meshScene(mesh), 0.5, 0.7).normal.z, 0.0);
}

/// A texture of 2 x 2 texels: the colour alone, but darker on the left half, and darker still in
/// the lower one.
Texture sideTexture(const Vec3f& colour) {
  return {2, 2, {colour * 0.8f, colour, colour * 0.4f, colour * 0.6f}};
}

TEST(CubeMap, HasEachSideWhereItBelongs) {
  SceneDescription description;
  const std::array<Vec3d, 6> colours = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}}};
  CubeMap cube{};
  for (std::uint32_t i = 0; i < 6; ++i) {
    cube.textures[i] = i;
    description.textures.emplace_back(1, 1, std::vector<Vec3f>{Vec3f(colours[i])});
  }
  description.background = cube;
  const BuiltScene built(description);
  // Left-handed: the map's z is the scene's -z.
  const std::array<Vec3d, 6> directions = {
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}}};
  for (std::size_t i = 0; i < 6; ++i) {
    expectNear(built.background(directions[i]), colours[i]);
    for (const double a : {-0.9, 0.9}) {
      const Vec3d aside =
          directions[i] + Vec3d{directions[i].y, directions[i].z, directions[i].x} * a;
      expectNear(built.background(aside * 1e-3), colours[i]);
    }
  }
  expectNear(built.background({0, 0, 0}), {0, 0, 0});
}

TEST(CubeMap, ShowsSidesUprightAndUnmirrored) {
  SceneDescription description;
  CubeMap cube{};
  for (std::uint32_t i = 0; i < 6; ++i) {
    cube.textures[i] = i;
    description.textures.push_back(sideTexture({1, 1, 1}));
  }
  description.background = cube;
  const BuiltScene built(description);
  struct Look {
    Vec3d forward, right, up;
  };
  // Of one who looks around upright, and up and down with posz before.
  const std::array<Look, 6> looks = {{{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                      {{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                      {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                      {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                      {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}},
                                      {{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}}}};
  for (const Look& look : looks) {
    EXPECT_EQ(cross(look.right, look.up), -look.forward);
    const auto light = [&](double x, double y) {
      return built.background(look.forward + look.right * x + look.up * y).x;
    };
    EXPECT_NEAR(light(-0.8, 0.8), 0.8, 1e-6);
    EXPECT_NEAR(light(0.8, 0.8), 1.0, 1e-6);
    EXPECT_NEAR(light(-0.8, -0.8), 0.4, 1e-6);
    EXPECT_NEAR(light(0.8, -0.8), 0.6, 1e-6);
  }
}

TEST(BuiltScene, RefusesDescriptionsThatContradictThemselves) {
  using Break = std::function<void(SceneDescription&, MeshShape&)>;
  const std::vector<Break> breaks = {
      [](auto& s, auto&) { s.shapes[0].material = 4; },
      [](auto& s, auto&) { s.materials.clear(); },
      [](auto& s, auto&) { s.materials[3].specular.texture = 0; },
      [](auto& s, auto&) { s.materials[3].shininess.texture = 7; },
      [](auto& s, auto&) { s.background = CubeMap{}; },
      [](auto& s, auto&) {
        s.shapes[0].placement = Affine::scaling({1, 0, 1});
      },
      [](auto& s, auto&) {
        s.shapes[0].placement = Affine::translation({std::nan(""), 0, 0});
      },
      [](auto& s, auto&) {
        s.shapes[0].placement = Affine::scaling({std::numeric_limits<double>::infinity(), 1, 1});
      },
      [](auto&, auto& m) { m.normals.resize(3); },
      [](auto&, auto& m) { m.coordinates.resize(5); },
      [](auto&, auto& m) { m.faceMaterials.resize(4); },
      [](auto&, auto& m) { m.vertexMaterials.resize(2); },
      [](auto&, auto& m) { m.vertexMaterials.assign(4, 4); },
      [](auto&, auto& m) { m.faceMaterials.assign(2, 4); }};
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    SceneDescription description = meshScene({});
    MeshShape mesh = quad();
    breaks[i](description, mesh);
    description.shapes[0].shape = std::make_shared<const MeshShape>(mesh);
    try {
      const BuiltScene built(description);
      ADD_FAILURE() << "break " << i << " was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::InvalidGeometry) << i;
      EXPECT_FALSE(error.advice().empty()) << i;
    }
  }
  SceneDescription missing = meshScene({});
  missing.shapes[0].shape = std::shared_ptr<const MeshShape>();
  EXPECT_THROW(BuiltScene{missing}, Error);
}

TEST(BuiltScene, LeavesOutFacesThatCannotBeHit) {
  MeshShape mesh = quad();
  mesh.faces.push_back({0, 1, 9});
  const BuiltScene built(meshScene(mesh));
  EXPECT_EQ(built.tree().report().skippedCount, 1u);
}

TEST(BuiltScene, MayBeEmpty) {
  const BuiltScene built{SceneDescription()};
  EXPECT_FALSE(built.tree().findIntersection({.origin = {0, 0, 0}, .direction = {1, 0, 0}}));
  EXPECT_FALSE(built.hasTransparency());
}

TEST(BuiltScene, KnowsWhichShapeWasHitAmongManyKinds) {
  SceneDescription description;
  MeshShape mesh = quad();
  const std::vector<ShapeDescription> kinds = {
      UnitSphere{},   UnitBox{},   UnitSquare{},
      UnitCylinder{}, ConeShape{}, std::make_shared<const MeshShape>(mesh)};
  for (std::uint32_t i = 0; i < 60; ++i) {
    description.materials.push_back(coloured({static_cast<double>(i), 0, 0}));
    const Vec3d place{4.0 * (i % 8), 4.0 * (i / 8), 0};
    const bool isOdd = i % 4 == 1;
    description.shapes.push_back(
        {.shape = kinds[i % kinds.size()],
         .placement = Affine::translation(place) * Affine::scaling({1, isOdd ? 0.7 : 1.0, 1}),
         .material = i});
  }
  const BuiltScene built(description);
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Rayf ray{.origin = Vec3f(Vec3d{4.0 * (i % 8) + 0.2, 4.0 * (i / 8) + 0.1, 9}),
                   .direction = {0, 0, -1}};
    const auto hit = built.tree().findIntersection(ray);
    ASSERT_TRUE(hit) << i;
    EXPECT_EQ(built.surface(ray, *hit).material.diffuse.x, static_cast<double>(i));
  }
}

}  // namespace
}  // namespace planetree::test
