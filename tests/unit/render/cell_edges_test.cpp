#include "render/overlay/cell_edges.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/shape/shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace planetree::render {
namespace {

constexpr Box3 kBounds{.lower = {0.0f, 0.0f, 0.0f}, .upper = {4.0f, 2.0f, 1.0f}};

/// Split at x = 1; its right side at y = 0.5.
const std::vector<Node> kSmallTree = {SplitNode(Axis::X, 1.0f, 2), LeafNode(0, 0),
                                      SplitNode(Axis::Y, 0.5f, 2), LeafNode(0, 0), LeafNode(0, 0)};

std::vector<CellEdge> edgesOf(std::span<const Node> nodes, const Box3& bounds,
                              std::uint32_t depth) {
  std::vector<CellEdge> edges;
  forEachCellEdge(nodes, bounds, depth, [&edges](const CellEdge& edge) { edges.push_back(edge); });
  return edges;
}

bool has(const std::vector<CellEdge>& edges, const Vec3f& a, const Vec3f& b) {
  return std::any_of(edges.begin(), edges.end(), [&](const CellEdge& edge) {
    return (edge.a == a && edge.b == b) || (edge.a == b && edge.b == a);
  });
}

/// The one axis along which an edge runs.
Axis direction(const CellEdge& edge) {
  return edge.a.x != edge.b.x ? Axis::X : edge.a.y != edge.b.y ? Axis::Y : Axis::Z;
}

/// Whether the edges together cover the line from a to b, which runs along an axis.
bool cover(const std::vector<CellEdge>& edges, const CellEdge& wanted) {
  const Axis along = direction(wanted);
  float reached = std::min(wanted.a[along], wanted.b[along]);
  const float end = std::max(wanted.a[along], wanted.b[along]);
  for (bool goesOn = true; goesOn && reached < end;) {
    goesOn = false;
    for (const CellEdge& edge : edges) {
      const bool isOnLine = std::all_of(kAxes.begin(), kAxes.end(), [&](Axis axis) {
        return axis == along || (edge.a[axis] == wanted.a[axis] && edge.b[axis] == wanted.a[axis]);
      });
      const float first = std::min(edge.a[along], edge.b[along]);
      const float last = std::max(edge.a[along], edge.b[along]);
      if (isOnLine && first <= reached && last > reached) {
        reached = last;
        goesOn = true;
      }
    }
  }
  return reached >= end;
}

/// All twelve edges of a box that is not flat.
std::vector<CellEdge> boxEdges(const Box3& box) {
  return edgesOf(std::vector<Node>{LeafNode(0, 0)}, box, 1);
}

/// The cells at a depth, and the leaves above it, found in the plain way.
void collectCells(const Node& node, const Box3& cell, std::uint32_t levels,
                  std::vector<Box3>& cells) {
  if (levels == 1 || node.isLeaf()) {
    cells.push_back(cell);
    return;
  }
  const SplitNode& split = node.split();
  collectCells(split.left(), leftPart(cell, split.axis(), split.position()), levels - 1, cells);
  collectCells(split.right(), rightPart(cell, split.axis(), split.position()), levels - 1, cells);
}

TEST(ForEachCellEdge, AtDepthOneAreThoseOfTheBounds) {
  const std::vector<CellEdge> edges = edgesOf(kSmallTree, kBounds, 1);
  ASSERT_EQ(edges.size(), 12u);
  for (const Axis axis : kAxes) {
    EXPECT_EQ(std::count_if(edges.begin(), edges.end(),
                            [axis](const CellEdge& edge) { return direction(edge) == axis; }),
              4);
  }
  EXPECT_TRUE(has(edges, {0.0f, 0.0f, 0.0f}, {4.0f, 0.0f, 0.0f}));
  EXPECT_TRUE(has(edges, {4.0f, 0.0f, 1.0f}, {4.0f, 2.0f, 1.0f}));
  EXPECT_TRUE(has(edges, {0.0f, 2.0f, 0.0f}, {0.0f, 2.0f, 1.0f}));
}

TEST(ForEachCellEdge, EachSplitAddsTheRectangleThatItCuts) {
  const std::vector<CellEdge> two = edgesOf(kSmallTree, kBounds, 2);
  ASSERT_EQ(two.size(), 16u);
  EXPECT_TRUE(has(two, {1.0f, 0.0f, 0.0f}, {1.0f, 2.0f, 0.0f}));
  EXPECT_TRUE(has(two, {1.0f, 2.0f, 0.0f}, {1.0f, 2.0f, 1.0f}));
  const std::vector<CellEdge> three = edgesOf(kSmallTree, kBounds, 3);
  ASSERT_EQ(three.size(), 20u);
  EXPECT_TRUE(has(three, {1.0f, 0.5f, 0.0f}, {4.0f, 0.5f, 0.0f})) << "it ends at the first split";
  EXPECT_TRUE(has(three, {1.0f, 0.5f, 0.0f}, {1.0f, 0.5f, 1.0f}));
}

TEST(ForEachCellEdge, BelowTheDeepestLeafNothingIsAdded) {
  EXPECT_EQ(edgesOf(kSmallTree, kBounds, 64).size(), edgesOf(kSmallTree, kBounds, 3).size());
}

TEST(ForEachCellEdge, ATreeWithoutObjectsHasNone) {
  const KdTree<Sphere<float>> tree;
  EXPECT_TRUE(edgesOf(tree.nodes(), tree.bounds(), 1).empty());
}

TEST(ForEachCellEdge, TogetherCoverTheEdgesOfEveryCell) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-5.0f, 5.0f);
  std::vector<Sphere<float>> spheres;
  for (int i = 0; i < 60; ++i) {
    spheres.push_back({.center = {place(random), place(random), place(random)}, .radius = 0.4f});
  }
  const auto tree = buildTree(std::move(spheres));
  for (const std::uint32_t depth : {2u, 4u, 7u}) {
    const std::vector<CellEdge> edges = edgesOf(tree.nodes(), tree.bounds(), depth);
    std::vector<Box3> cells;
    collectCells(tree.root(), tree.bounds(), depth, cells);
    ASSERT_GE(cells.size(), depth);
    for (const Box3& cell : cells) {
      for (const CellEdge& edge : boxEdges(cell)) {
        const bool isPoint = edge.a == edge.b;
        EXPECT_TRUE(isPoint || cover(edges, edge)) << "depth " << depth;
      }
    }
  }
}

}  // namespace
}  // namespace planetree::render
