#include "scene/scene_bounds.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace planetree::test {
namespace {

using namespace scene;

Box3 boundsOfOne(const ShapeDescription& shape, const Affine& placement = {}) {
  SceneDescription scene;
  scene.shapes.push_back({.shape = shape, .placement = placement, .material = 0, .name = {}});
  return boundsOf(scene);
}

void expectBox(const Box3& box, const Vec3f& lower, const Vec3f& upper) {
  EXPECT_EQ(box.lower, lower);
  EXPECT_EQ(box.upper, upper);
}

TEST(BoundsOf, HoldsEachKindOfShape) {
  expectBox(boundsOfOne(UnitSphere{}), {-1, -1, -1}, {1, 1, 1});
  expectBox(boundsOfOne(UnitBox{}), {-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f});
  expectBox(boundsOfOne(UnitSquare{}), {-0.5f, -0.5f, 0}, {0.5f, 0.5f, 0});
  expectBox(boundsOfOne(UnitCylinder{}), {-1, -1, 0}, {1, 1, 1});
  expectBox(boundsOfOne(ConeShape{.height = -2, .bottomRadius = 1, .topRadius = -3}), {-3, -3, -2},
            {3, 3, 0});
}

TEST(BoundsOf, PlacesShapes) {
  const Affine placement = Affine::translation({10, 0, 0}) * Affine::scaling({2, -4, 1});
  expectBox(boundsOfOne(UnitBox{}, placement), {9, -2, -0.5f}, {11, 2, 0.5f});
}

TEST(BoundsOf, GoesAroundTheVerticesOfMeshes) {
  auto mesh = std::make_shared<MeshShape>();
  mesh->positions = {
      {0, 0, 0}, {1, 2, 3}, {std::numeric_limits<double>::quiet_NaN(), 9, 9}, {1e300, 9, 9}};
  mesh->positions.back().x = std::numeric_limits<double>::infinity();
  expectBox(boundsOfOne(std::shared_ptr<const MeshShape>(mesh)), {0, 0, 0}, {1, 2, 3});
}

TEST(BoundsOf, IsEmptyWithoutShapes) {
  EXPECT_TRUE(boundsOf({}).isEmpty());
  EXPECT_TRUE(boundsOfOne(std::shared_ptr<const MeshShape>()).isEmpty());
}

}  // namespace
}  // namespace planetree::test
