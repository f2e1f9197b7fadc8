#include "mesh/pack_triangles.hpp"

#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace planetree::detail {
namespace {

constexpr std::uint32_t kFirstObject = 100;

/// Each box is that of the faces in its block, no larger.
template <class T>
void expectBounds(const std::vector<TriangleBlock>& blocks, const std::vector<Box3>& bounds,
                  const TriangleMesh<T>& mesh) {
  ASSERT_EQ(bounds.size(), blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    Box3 box;
    for (std::size_t lane = 0; (blocks[i].usedLanes >> lane & 1u) != 0; ++lane) {
      for (const Vec3<T>& corner : mesh.view().corners(blocks[i].objects[lane] - kFirstObject))
        box.extend(corner);
    }
    EXPECT_EQ(bounds[i], box);
  }
}

std::vector<TriangleBlock> packAll(const TriangleMesh<float>& mesh) {
  std::vector<std::uint32_t> objects(mesh.faces.size());
  std::iota(objects.begin(), objects.end(), kFirstObject);
  std::vector<TriangleBlock> blocks;
  std::vector<Box3> bounds;
  packTriangles(mesh.view(), objects, kFirstObject, blocks, bounds);
  expectBounds(blocks, bounds, mesh);
  return blocks;
}

void expectHolds(const std::vector<TriangleBlock>& blocks, const TriangleMesh<float>& mesh) {
  std::uint32_t object = kFirstObject;
  for (const TriangleBlock& block : blocks) {
    for (std::size_t lane = 0; lane < TriangleBlock::kLaneCount; ++lane) {
      if ((block.usedLanes >> lane & 1u) == 0)
        continue;
      ASSERT_EQ(block.objects[lane], object);
      const auto corners = mesh.view().corners(object - kFirstObject);
      for (std::size_t corner = 0; corner < 3; ++corner)
        EXPECT_EQ(block.corner(lane, corner), corners[corner]);
      ++object;
    }
  }
  EXPECT_EQ(object - kFirstObject, mesh.faces.size());
}

TEST(PackTriangles, KeepsEveryFaceInOrder) {
  for (const int count : {0, 1, 5, 6, 16, 17, 100}) {
    const auto mesh = test::detail::soup<float>(31, count, 0.1);
    expectHolds(packAll(mesh), mesh);
  }
}

TEST(PackTriangles, MakesFacesShareTheirCorners) {
  const auto grid = test::detail::grid<float>(4, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto blocks = packAll(grid);
  expectHolds(blocks, grid);
  // Of 32 faces with 96 corners; as single triangles they would take seven.
  EXPECT_LE(blocks.size(), 3u);
}

TEST(PackTriangles, GivesSingleTrianglesFiveToABlock) {
  const auto mesh = test::detail::soup<float>(32, 10, 0.1);
  EXPECT_EQ(packAll(mesh).size(), 2u);
}

TEST(PackRoundedTriangles, KeepsCornersRelativeToTheCenterToHalfAFloat) {
  const Vec3f center{1e6f, -2e6f, 3e6f};
  const auto middle = static_cast<Vec3d>(center);
  const auto mesh = test::detail::scaled(test::detail::soup<double>(33, 50, 0.1), 1.0, middle);
  std::vector<std::uint32_t> objects(mesh.faces.size());
  std::iota(objects.begin(), objects.end(), kFirstObject);
  std::vector<TriangleBlock> blocks;
  std::vector<Box3> bounds;
  packRoundedTriangles(mesh.view(), objects, kFirstObject, center, blocks, bounds);
  expectBounds(blocks, bounds, mesh);
  for (const TriangleBlock& block : blocks) {
    for (std::size_t lane = 0; (block.usedLanes >> lane & 1u) != 0; ++lane) {
      const auto corners = mesh.view().corners(block.objects[lane] - kFirstObject);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec3d exact = corners[corner] - middle;
        const auto packed = static_cast<Vec3d>(block.corner(lane, corner));
        for (const Axis axis : kAxes)
          EXPECT_LE(std::fabs(packed[axis] - exact[axis]), 0x1p-24 * std::fabs(exact[axis]));
      }
    }
  }
}

TEST(PackRoundedTriangles, LetsCornersShareAPositionThatRoundToTheSame) {
  TriangleMesh<double> mesh;
  for (int i = 0; i < 16; ++i) {
    const double x = 1.0 + 1e-12 * i;
    test::detail::addTriangle<double>(mesh, {x, 0, 0}, {x, 1, 0}, {x, 0, 1});
  }
  std::vector<std::uint32_t> objects(mesh.faces.size());
  std::iota(objects.begin(), objects.end(), kFirstObject);
  std::vector<TriangleBlock> blocks;
  std::vector<Box3> bounds;
  packRoundedTriangles(mesh.view(), objects, kFirstObject, {}, blocks, bounds);
  EXPECT_EQ(blocks.size(), 1u);
}

TEST(PackTriangles, TellsZerosOfDifferentSignApart) {
  TriangleMesh<float> mesh;
  test::detail::addTriangle<float>(mesh, {0.0f, 1, 2}, {-0.0f, 1, 2}, {3, 4, 5});
  const auto blocks = packAll(mesh);
  EXPECT_FALSE(std::signbit(blocks[0].corner(0, 0).x));
  EXPECT_TRUE(std::signbit(blocks[0].corner(0, 1).x));
}

}  // namespace
}  // namespace planetree::detail
