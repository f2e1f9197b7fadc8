#include "scene/build_scene.hpp"
#include "scene/shape_groups.hpp"
#include "scene/transformed_shape.hpp"

#include "support/random.hpp"

#include <planetree/shape/box.hpp>
#include <planetree/shape/cone.hpp>
#include <planetree/shape/sphere.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// Shapes under all kinds of maps, against their definition in their own space, in double.
namespace planetree::test {
namespace {

using scene::Affine;
using scene::BuiltScene;
using scene::ConeShape;
using scene::SceneDescription;
using scene::ShapeDescription;
using scene::UnitBox;
using scene::UnitCylinder;
using scene::UnitSphere;
using scene::UnitSquare;

/// A solid in its own space: how far a point is outside, in some measure that is 0 on the surface
/// and negative inside, and the shape in double.
struct Solid {
  std::string name;
  ShapeDescription shape;
  std::function<double(const Vec3d&)> outside;
  std::function<std::optional<Hitd>(const Ray<double>&)> intersect;
  std::function<Vec3d(double, double, double)> surface;  ///< any point of it, by three numbers
};

void PrintTo(const Solid& solid, std::ostream* out) {
  *out << solid.name;
}

Vec3d sphericalPoint(double a, double b, double /*c*/) {
  const double z = 2 * a - 1;
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(2 * std::numbers::pi * b), r * std::sin(2 * std::numbers::pi * b), z};
}

Solid sphere() {
  return {"sphere", UnitSphere{}, [](const Vec3d& p) { return length(p) - 1; },
          [](const Ray<double>& ray) { return Sphere<double>().intersect(ray, 0, INFINITY); },
          sphericalPoint};
}

Solid box() {
  const auto farthest = [](const Vec3d& p) {
    return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  };
  return {"box", UnitBox{}, [farthest](const Vec3d& p) { return farthest(p) - 0.5; },
          [](const Ray<double>& ray) {
            return Box<double>{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}.intersect(ray, 0, INFINITY);
          },
          [farthest](double a, double b, double c) {
            const Vec3d p{a - 0.5, b - 0.5, c - 0.5};
            return p * (0.5 / farthest(p));
          }};
}

Solid coneLike(const std::string& name, const ShapeDescription& shape, double height, double bottom,
               double top) {
  const auto radiusAt = [=](double part) { return bottom + (top - bottom) * part; };
  return {name, shape,
          [=](const Vec3d& p) {
            const double part = p.z / height;
            return std::max({std::hypot(p.x, p.y) - radiusAt(part), -part * std::fabs(height),
                             (part - 1) * std::fabs(height)});
          },
          [=](const Ray<double>& ray) {
            return Cone<double>{{0, 0, 0}, {0, 0, height}, bottom, top, true}.intersect(ray, 0,
                                                                                        INFINITY);
          },
          [=](double a, double b, double c) {
            const double part = c < 0.2 ? 0 : c > 0.8 ? 1 : a;
            const double reach = part == a ? 1 : std::sqrt(a);
            const double r = reach * radiusAt(part);
            return Vec3d{r * std::cos(2 * std::numbers::pi * b),
                         r * std::sin(2 * std::numbers::pi * b), part * height};
          }};
}

std::vector<Solid> solids() {
  return {sphere(),
          box(),
          coneLike("cylinder", UnitCylinder{}, 1, 1, 1),
          coneLike("cone", ConeShape{}, 1, 1, 0),
          coneLike("frustum", ConeShape{2, 0.5, 1.5}, 2, 0.5, 1.5),
          coneLike("hanging cone", ConeShape{-1.5, 1, 0.25}, -1.5, 1, 0.25)};
}

/// Similar, elliptic, slanted and general maps, every other one of each a mirror.
Affine randomPlacement(Random& random, int kind) {
  const auto size = [&] { return random.between(0.3, 3); };
  const double mirror = kind % 2 == 0 ? 1 : -1;
  const Vec3d shift = random.pointIn<double>({-5, -5, -5}, {5, 5, 5});
  const Affine turn = Affine::rotation(random.direction(), random.between(0, 6));
  const double s = size();
  switch (kind / 2) {
    case 0:
      return Affine::translation(shift) * turn * Affine::scaling({s, s, mirror * s});
    case 1:
      return Affine::translation(shift) * turn * Affine::scaling({s, s, mirror * size()});
    case 2:
      return Affine::translation(shift) * turn * Affine::scaling({mirror * s, size(), size()});
    default: {
      const Affine shear({1, 0, 0}, {random.between(-1, 1), 1, 0},
                         {random.between(-1, 1), random.between(-1, 1), 1}, {});
      return Affine::translation(shift) * turn * shear * Affine::scaling({size(), size(), mirror});
    }
  }
}

constexpr int kKindCount = 8;

SceneDescription sceneOf(const ShapeDescription& shape, const Affine& placement) {
  SceneDescription description;
  description.materials.resize(1);
  description.shapes.push_back({.shape = shape, .placement = placement});
  return description;
}

Rayf rayToward(Random& random, const Vec3d& target, double distance) {
  const Vec3d origin = target + random.direction() * distance;
  return {.origin = Vec3f(origin), .direction = Vec3f(normalized(target - origin))};
}

class PlacedSolid : public testing::TestWithParam<Solid> {};

TEST_P(PlacedSolid, IsHitWhereItsDefinitionSays) {
  const Solid& solid = GetParam();
  Random random(11);
  int hitCount = 0;
  int missCount = 0;
  for (int i = 0; i < 160; ++i) {
    const Affine placement = randomPlacement(random, i % kKindCount);
    const Affine toLocal = *placement.inverse();
    const BuiltScene built(sceneOf(solid.shape, placement));
    for (int k = 0; k < 24; ++k) {
      const Vec3d target = placement.point(random.pointIn<double>({-2, -2, -2}, {2, 2, 2}));
      const Rayf ray = rayToward(random, target, 12);
      const Ray<double> local{.origin = toLocal.point(Vec3d(ray.origin)),
                              .direction = toLocal.vector(Vec3d(ray.direction))};
      const auto expected = solid.intersect(local);
      const auto hit = built.tree().findIntersection(ray);
      if (hit.has_value() != expected.has_value()) {
        // Only a ray that grazes may be seen either way: all along it is outside, or hardly inside.
        double least = INFINITY;
        for (int step = 0; step <= 20'000; ++step)
          least = std::min(least, solid.outside(local.origin + local.direction * (step * 2e-3)));
        EXPECT_GT(least, -2e-5) << describeSeed() << " " << i << " " << k;
        continue;
      }
      hit ? ++hitCount : ++missCount;
      if (!hit)
        continue;
      const Vec3d at = local.origin + local.direction * static_cast<double>(hit->t);
      ASSERT_NEAR(solid.outside(at), 0, 3e-5) << describeSeed() << " " << i << " " << k;
      // How fast it is entered tells how much a rounding moves t.
      const Vec3d carried = normalized(placement.normal(expected->normal));
      const double slope = std::fabs(dot(carried, Vec3d(ray.direction)));
      EXPECT_NEAR(static_cast<double>(hit->t), expected->t, 3e-5 / std::max(slope, 1e-3))
          << describeSeed() << " " << i << " " << k;
      const bool isAtEdge = hit->part != expected->part || solid.name == "box";
      if (!isAtEdge && slope > 0.02) {
        EXPECT_GT(dot(Vec3d(hit->normal), carried), 1 - 1e-4) << describeSeed() << " " << i;
      }
    }
  }
  EXPECT_GT(hitCount, 300);
  EXPECT_GT(missCount, 100);
}

TEST_P(PlacedSolid, NormalsOfTheSurfaceLookOutward) {
  const Solid& solid = GetParam();
  Random random(12);
  for (int i = 0; i < 80; ++i) {
    const Affine placement = randomPlacement(random, i % kKindCount);
    const Affine toLocal = *placement.inverse();
    const BuiltScene built(sceneOf(solid.shape, placement));
    for (int k = 0; k < 20; ++k) {
      const Vec3d target =
          placement.point(solid.surface(random.unit(), random.unit(), random.unit()));
      const Rayf ray = rayToward(random, target, 9);
      const auto hit = built.tree().findIntersection(ray);
      if (!hit)
        continue;
      const scene::SurfacePoint point = built.surface(ray, *hit);
      EXPECT_NEAR(length(point.normal), 1, 1e-5);
      // A solid without dents is left by a step along its normal.
      EXPECT_GT(solid.outside(toLocal.point(point.position + point.normal * 1e-3)), 0)
          << describeSeed() << " " << i << " " << k;
    }
  }
}

TEST_P(PlacedSolid, BoundsHoldAllOfItAndNoMore) {
  const Solid& solid = GetParam();
  Random random(13);
  for (int i = 0; i < 80; ++i) {
    const Affine placement = randomPlacement(random, i % kKindCount);
    const Box3 bounds = BuiltScene(sceneOf(solid.shape, placement)).tree().bounds();
    Vec3d lower{INFINITY, INFINITY, INFINITY};
    Vec3d upper = -lower;
    const auto add = [&](const Vec3d& local) {
      const Vec3d p = placement.point(local);
      for (const Axis axis : kAxes) {
        lower[axis] = std::min(lower[axis], p[axis]);
        upper[axis] = std::max(upper[axis], p[axis]);
      }
    };
    for (int k = 0; k < 4000; ++k)
      add(solid.surface(random.unit(), random.unit(), random.unit()));
    // Where rims and corners are.
    for (int k = 0; k < 720; ++k) {
      for (const double c : {0.0, 1.0})
        add(solid.surface(1, k / 720.0, c));
    }
    for (int corner = 0; corner < 8; ++corner)
      add(solid.surface(corner & 1, corner >> 1 & 1, corner >> 2));
    for (const Axis axis : kAxes) {
      const double slack = 1e-6 * (std::fabs(lower[axis]) + std::fabs(upper[axis]));
      EXPECT_LE(static_cast<double>(bounds.lower[axis]), lower[axis] + slack) << describeSeed();
      EXPECT_GE(static_cast<double>(bounds.upper[axis]), upper[axis] - slack) << describeSeed();
      const double size = upper[axis] - lower[axis];
      EXPECT_GE(static_cast<double>(bounds.lower[axis]), lower[axis] - 0.03 * size) << i;
      EXPECT_LE(static_cast<double>(bounds.upper[axis]), upper[axis] + 0.03 * size) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scene, PlacedSolid, testing::ValuesIn(solids()),
                         [](const testing::TestParamInfo<Solid>& solid) {
                           std::string name = solid.param.name;
                           std::erase(name, ' ');
                           return name;
                         });

TEST(PlacedBox, IsWatertightUnderAnyMap) {
  Random random(14);
  for (int i = 0; i < 60; ++i) {
    const Affine placement = randomPlacement(random, i % kKindCount);
    const BuiltScene built(sceneOf(UnitBox{}, placement));
    EXPECT_EQ(built.tree().report().objectCount, 12u);
    for (int k = 0; k < 100; ++k) {
      // From the middle through an edge, or a corner, or the diagonal of a side.
      Vec3d target{random.between(-0.5, 0.5), 0.5, -0.5};
      if (k % 3 == 1)
        target = {0.5, -0.5, k % 2 == 0 ? 0.5 : -0.5};
      if (k % 3 == 2)
        target.y = target.x, target.z = 0.5;
      const Vec3d middle = placement.origin();
      const Rayf ray{.origin = Vec3f(middle), .direction = Vec3f(placement.point(target) - middle)};
      const auto hit = built.tree().findIntersection(ray);
      ASSERT_TRUE(hit) << describeSeed() << " " << i << " " << k;
      EXPECT_NEAR(static_cast<double>(hit->t), 1.0, 1e-4);
    }
  }
}

/// A texture whose colour says where it is: u in red, v in green. Large enough that the way it
/// repeats at its edges is not seen.
scene::Texture placeTexture() {
  constexpr std::uint32_t kSize = 64;
  std::vector<Vec3f> texels;
  for (std::uint32_t y = 0; y < kSize; ++y) {
    for (std::uint32_t x = 0; x < kSize; ++x) {
      texels.push_back({(static_cast<float>(x) + 0.5f) / kSize,
                        1.0f - (static_cast<float>(y) + 0.5f) / kSize, 0.0f});
    }
  }
  return {kSize, kSize, std::move(texels)};
}

SceneDescription texturedScene(const ShapeDescription& shape, const Affine& placement) {
  SceneDescription description = sceneOf(shape, placement);
  description.textures.push_back(placeTexture());
  description.materials[0].diffuse = {.value = {1, 1, 1}, .texture = 0};
  return description;
}

/// The place on the texture where a ray hits that comes straight onto the surface point `local`
/// along `normal`, both in the shape's own space.
Vec3d texturePlace(const BuiltScene& built, const Affine& placement, const Vec3d& local,
                   const Vec3d& normal) {
  const Vec3d target = placement.point(local);
  const Vec3d origin = target + normalized(placement.vector(normal)) * 3.0;
  const Rayf ray{.origin = Vec3f(origin), .direction = Vec3f(normalized(target - origin))};
  const auto hit = built.tree().findIntersection(ray);
  EXPECT_TRUE(hit);
  return hit ? built.surface(ray, *hit).material.diffuse : Vec3d{-1, -1, -1};
}

void expectPlace(const Vec3d& colour, double u, double v) {
  EXPECT_NEAR(colour.x, u, 2e-3);
  EXPECT_NEAR(colour.y, v, 2e-3);
}

TEST(TexturePlaces, OfSpheresAreLongitudeAndLatitudeInTheirOwnSpace) {
  Random random(15);
  for (int i = 0; i < 40; ++i) {
    const Affine placement = randomPlacement(random, i % kKindCount);
    const BuiltScene built(texturedScene(UnitSphere{}, placement));
    const double u = random.between(0.05, 0.95);
    const double v = random.between(0.05, 0.95);
    const double longitude = 2 * std::numbers::pi * u;
    const double latitude = std::numbers::pi * (v - 0.5);
    const Vec3d p{std::cos(latitude) * std::cos(longitude),
                  std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
    expectPlace(texturePlace(built, placement, p, p), u, v);
  }
}

TEST(TexturePlaces, OfCylindersTurnWithThem) {
  Random random(16);
  for (int i = 0; i < 40; ++i) {
    const Affine placement = randomPlacement(random, i % kKindCount);
    const BuiltScene built(texturedScene(UnitCylinder{}, placement));
    const double u = random.between(0.05, 0.95);
    const double v = random.between(0.05, 0.95);
    const Vec3d side{std::cos(2 * std::numbers::pi * u), std::sin(2 * std::numbers::pi * u), 0};
    expectPlace(texturePlace(built, placement, side + Vec3d{0, 0, v}, side), u, v);
  }
}

TEST(TexturePlaces, OfSquaresAreTheirOwn) {
  Random random(17);
  for (int i = 0; i < 40; ++i) {
    const Affine placement = randomPlacement(random, i % kKindCount);
    const BuiltScene built(texturedScene(UnitSquare{}, placement));
    const double u = random.between(0.05, 0.95);
    const double v = random.between(0.05, 0.95);
    expectPlace(
        texturePlace(built, placement, {u - 0.5, v - 0.5, 0}, {0, 0, i % 3 == 0 ? 1.0 : -1.0}), u,
        v);
  }
}

/// The sides of a box as someone sees them who stands before them, with y up.
struct BoxSide {
  Vec3d normal, right, up;
};

constexpr std::array<BoxSide, 6> kBoxSides = {{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                               {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                               {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
                                               {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                               {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                               {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}}};

TEST(TexturePlaces, OfBoxesAreUprightOnEachSide) {
  Random random(18);
  for (int i = 0; i < 40; ++i) {
    const Affine placement = i == 0 ? Affine() : randomPlacement(random, i % kKindCount);
    const BuiltScene built(texturedScene(UnitBox{}, placement));
    for (const BoxSide& side : kBoxSides) {
      // What is right of the eye is right on the texture, and not mirrored.
      EXPECT_EQ(cross(side.right, side.up), side.normal);
      const double u = random.between(0.05, 0.95);
      const double v = random.between(0.05, 0.95);
      const Vec3d p = side.normal * 0.5 + side.right * (u - 0.5) + side.up * (v - 0.5);
      expectPlace(texturePlace(built, placement, p, side.normal), u, v);
    }
  }
}

TEST(TexturePlaces, OfThinBoxesAreThoseOfTheSideThatWasHit) {
  // The place of a hit is rounded by more than the box is thick.
  Random random(19);
  for (int i = 0; i < 100; ++i) {
    const Affine placement =
        Affine::translation({100, 100, random.between(90, 100)}) * Affine::scaling({50, 50, 1e-5});
    const BuiltScene built(texturedScene(UnitBox{}, placement));
    const double u = random.between(0.02, 0.98);
    const double v = random.between(0.02, 0.98);
    expectPlace(texturePlace(built, placement, {u - 0.5, v - 0.5, 0.5}, {0, 0, 1}), u, v);
  }
}

TEST(TwoSides, SquaresAndOpenConesFaceTheRay) {
  Random random(20);
  for (int i = 0; i < 80; ++i) {
    const Affine placement = randomPlacement(random, i % kKindCount);
    for (const ShapeDescription& shape :
         {ShapeDescription(UnitSquare{}), ShapeDescription(UnitCylinder{.isCapped = false}),
          ShapeDescription(ConeShape{.topRadius = 0.5, .isCapped = false})}) {
      const BuiltScene built(sceneOf(shape, placement));
      const Vec3d target = placement.point({0.4, 0.1, 0.3});
      const Rayf ray = rayToward(random, target, 9);
      // The far side too: it is seen from within.
      std::array<Hitf, 4> hits;
      const auto found = built.tree().findIntersections(ray, std::span(hits));
      for (std::size_t k = 0; k < found.count; ++k)
        EXPECT_LT(dot(built.surface(ray, hits[k]).normal, Vec3d(ray.direction)), 0) << i;
    }
  }
}

}  // namespace
}  // namespace planetree::test
