#include "mesh/leaf_triangles.hpp"

#include <planetree/planetree.hpp>

#include "mesh/pack_leaf.hpp"

#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <span>
#include <vector>

namespace planetree::detail {
namespace {

constexpr std::uint32_t kFirstObject = 100;

/// Blocks with the triangles, filled one after the other as they come.
std::vector<TriangleBlock> packInARow(LeafTriangles& triangles, std::size_t count) {
  std::vector<std::uint32_t> places(count);
  std::iota(places.begin(), places.end(), 0u);
  std::vector<std::uint32_t> counts(count);
  triangles.countBlocks(places, counts);
  std::vector<TriangleBlock> blocks;
  for (std::size_t begin = 0; begin < count;) {
    const auto end = static_cast<std::size_t>(
        std::upper_bound(counts.begin(), counts.end(), counts[begin]) - counts.begin());
    blocks.push_back(triangles.pack(std::span(places).subspan(begin, end - begin)));
    EXPECT_EQ(blocks.size(), counts[begin]);
    begin = end;
  }
  return blocks;
}

std::vector<TriangleBlock> packAll(const TriangleMesh<float>& mesh) {
  LeafTriangles triangles;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
    triangles.add(mesh.view().corners(face), kFirstObject + face);
  return packInARow(triangles, mesh.faces.size());
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

TEST(LeafTriangles, KeepsEveryFaceInOrder) {
  for (const int count : {0, 1, 5, 6, 16, 17, 100}) {
    const auto mesh = test::detail::soup<float>(31, count, 0.1);
    expectHolds(packAll(mesh), mesh);
  }
}

TEST(LeafTriangles, MakesFacesShareTheirCorners) {
  const auto grid = test::detail::grid<float>(4, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const auto blocks = packAll(grid);
  expectHolds(blocks, grid);
  // Of 32 faces with 96 corners; as single triangles they would take seven.
  EXPECT_LE(blocks.size(), 3u);
}

TEST(LeafTriangles, GivesSingleTrianglesFiveToABlock) {
  const auto mesh = test::detail::soup<float>(32, 10, 0.1);
  EXPECT_EQ(packAll(mesh).size(), 2u);
}

TEST(LeafTriangles, CountsTheBlocksOfAnyOrder) {
  const auto grid = test::detail::grid<float>(6, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  LeafTriangles triangles;
  for (std::uint32_t face = 0; face < grid.faces.size(); ++face)
    triangles.add(grid.view().corners(face), face);
  std::vector<std::uint32_t> places(grid.faces.size());
  std::iota(places.begin(), places.end(), 0u);
  test::Random random(34);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::uint32_t> counts(places.size());
    triangles.countBlocks(places, counts);
    // Each run with the same count fits into a block, and no more than that.
    for (std::size_t begin = 0; begin < places.size();) {
      std::size_t end = begin;
      std::set<std::array<float, 3>> corners;
      const auto insertCornersOf = [&](std::uint32_t face) {
        for (const Vec3f& corner : grid.view().corners(face))
          corners.insert({corner.x, corner.y, corner.z});
      };
      while (end < places.size() && counts[end] == counts[begin])
        insertCornersOf(places[end++]);
      EXPECT_LE(corners.size(), TriangleBlock::kPositionCount);
      EXPECT_LE(end - begin, TriangleBlock::kLaneCount);
      if (end < places.size()) {
        EXPECT_EQ(counts[end], counts[begin] + 1);
        insertCornersOf(places[end]);
        EXPECT_TRUE(corners.size() > TriangleBlock::kPositionCount ||
                    end - begin == TriangleBlock::kLaneCount);
      }
      begin = end;
    }
    for (std::size_t i = places.size(); i-- > 1;)
      std::swap(places[i], places[random.below(i + 1)]);
  }
}

TEST(LeafTriangles, ForgetsTheLeafBefore) {
  LeafTriangles triangles;
  for (int round = 0; round < 3; ++round) {
    triangles.clear();
    for (std::uint32_t i = 0; i < 300; ++i) {
      const auto x = static_cast<float>(i);
      triangles.add({Vec3f{x, 0, 0}, Vec3f{x, 1, 0}, Vec3f{x + 1, 0, 0}}, i);
    }
    const auto blocks = packInARow(triangles, 300);
    // A strip: each triangle adds two corners to those before.
    EXPECT_EQ(blocks.size(), (300 + 6) / 7);
    EXPECT_EQ(blocks.back().corner(0, 1).y, 1.0f);
  }
}

/// Objects as a packer of a mesh in double sees them.
TEST(FacePacker, KeepsCornersRelativeToTheCenterToHalfAFloat) {
  const Vec3f center{1e6f, -2e6f, 3e6f};
  const auto middle = static_cast<Vec3d>(center);
  const auto mesh = test::detail::scaled(test::detail::soup<double>(33, 50, 0.1), 1.0, middle);
  const auto tree = buildTree(mesh.view());
  FacePacker<double> packer(tree.view().geometries, center);
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    ASSERT_TRUE(packer.open(std::span(&face, 1)));
    const std::uint32_t place = 0;
    const TriangleBlock block = packer.pack(std::span(&place, 1));
    EXPECT_EQ(block.objects[0], face);
    EXPECT_EQ(block.usedLanes, 1u);
    const auto corners = mesh.view().corners(face);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3d exact = corners[corner] - middle;
      const auto packed = static_cast<Vec3d>(block.corner(0, corner));
      for (const Axis axis : kAxes)
        EXPECT_LE(std::fabs(packed[axis] - exact[axis]), 0x1p-24 * std::fabs(exact[axis]));
    }
  }
}

TEST(FacePacker, LetsCornersShareAPositionThatRoundToTheSame) {
  TriangleMesh<double> mesh;
  std::vector<std::uint32_t> objects;
  for (std::uint32_t i = 0; i < 16; ++i) {
    const double x = 1.0 + 1e-12 * i;
    test::detail::addTriangle<double>(mesh, {x, 0, 0}, {x, 1, 0}, {x, 0, 1});
    objects.push_back(i);
  }
  const auto tree = buildTree(mesh.view());
  FacePacker<double> packer(tree.view().geometries, {});
  ASSERT_TRUE(packer.open(objects));
  std::vector<std::uint32_t> counts(objects.size());
  packer.countBlocks(objects, counts);
  EXPECT_EQ(counts.back(), 1u);
}

TEST(FacePacker, LeavesLeavesWithShapesAlone) {
  Scene<float> scene;
  scene.add(test::detail::soup<float>(35, 3, 0.1));
  scene.add(std::vector<Sphere<float>>{{{0, 0, 0}, 1}});
  const auto tree = buildTree(scene);
  FacePacker<float> packer(tree.view().geometries, {});
  const std::vector<std::uint32_t> faces = {0, 1, 2};
  const std::vector<std::uint32_t> mixed = {1, 3};
  EXPECT_TRUE(packer.open(faces));
  EXPECT_FALSE(packer.open(mixed));
}

TEST(LeafTriangles, TellsZerosOfDifferentSignApart) {
  TriangleMesh<float> mesh;
  test::detail::addTriangle<float>(mesh, {0.0f, 1, 2}, {-0.0f, 1, 2}, {3, 4, 5});
  const auto blocks = packAll(mesh);
  EXPECT_FALSE(std::signbit(blocks[0].corner(0, 0).x));
  EXPECT_TRUE(std::signbit(blocks[0].corner(0, 1).x));
}

}  // namespace
}  // namespace planetree::detail
