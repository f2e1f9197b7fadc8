#include "node/widen_tree.hpp"

#include <planetree/planetree.hpp>

#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace planetree::detail {
namespace {

/// Walks a wide tree and checks what must hold for every node of it.
class WideWalk {
 public:
  explicit WideWalk(const TreeView<float>& tree) : wide_(*tree.wide) {
    if (!tree.bounds.isEmpty())
      visit(wide_.root, tree.bounds);
  }

  /// Every object as often as there are leaves that hold it.
  std::multiset<std::uint32_t> objects;
  std::size_t nodeCount = 0;

 private:
  void visit(WideChild child, const Box3& outer) {
    if (child.isNode()) {
      visitNode(wide_.nodes[child.nodeIndex()], outer);
    } else if (child.isObject()) {
      objects.insert(child.objectNumber());
    } else {
      for (std::uint32_t i = 0; i < child.blockCount(); ++i) {
        const TriangleBlock& block = wide_.blocks[child.firstBlock() + i];
        for (std::size_t lane = 0; lane < TriangleBlock::kLaneCount; ++lane) {
          if ((block.usedLanes >> lane & 1u) != 0)
            objects.insert(block.objects[lane]);
        }
      }
    }
  }

  void visitNode(const WideNode& node, const Box3& outer) {
    ++nodeCount;
    for (const SlotOrder& order : node.orders) {
      std::set<std::size_t> slots;
      for (std::size_t i = 0; i < WideNode::kSlotCount; ++i)
        slots.insert(order[i]);
      EXPECT_EQ(slots.size(), WideNode::kSlotCount);
    }
    for (std::size_t slot = 0; slot < WideNode::kSlotCount; ++slot) {
      const Box3 box = boundsOf(node, slot);
      if (node.planes[0][slot] > node.planes[1][slot])
        continue;
      EXPECT_TRUE(contains(outer, box));
      visit(node.children[slot], box);
    }
  }

  /// Back where it was, grown by what rounding may have taken.
  [[nodiscard]] Box3 boundsOf(const WideNode& node, std::size_t slot) const {
    Box3 box;
    for (const Axis axis : kAxes) {
      const auto i = 2 * static_cast<std::size_t>(axis);
      box.lower[axis] = node.planes[i][slot] + wide_.frame.center[i / 2];
      box.upper[axis] = node.planes[i + 1][slot] + wide_.frame.center[i / 2];
    }
    return box;
  }

  static bool contains(const Box3& outer, const Box3& inner) {
    constexpr float kRounding = 0x1p-20f;
    for (const Axis axis : kAxes) {
      const float margin =
          kRounding * std::max(std::fabs(outer.lower[axis]), std::fabs(outer.upper[axis]));
      if (inner.lower[axis] < outer.lower[axis] - margin ||
          inner.upper[axis] > outer.upper[axis] + margin)
        return false;
    }
    return true;
  }

  const WideTree& wide_;
};

std::vector<Sphere<float>> makeSpheres(int count) {
  test::Random random(23);
  std::vector<Sphere<float>> spheres;
  for (int i = 0; i < count; ++i) {
    spheres.push_back({random.pointIn<float>({-1, -1, -1}, {1, 1, 1}),
                       static_cast<float>(random.between(0.01, 0.1))});
  }
  return spheres;
}

TEST(WidenTree, HoldsEveryReferenceOfTheBinaryFormOnce) {
  for (const test::HardMesh<float>& hard : test::hardMeshes<float>()) {
    for (const std::uint32_t leafSize : {0u, 4u, 40u, 1000u}) {
      SCOPED_TRACE(hard.name);
      const auto tree = buildTree(hard.mesh.view(), {.leafSize = leafSize});
      const TreeView<float> view = tree.view();
      const WideWalk walk(view);
      EXPECT_EQ(walk.objects,
                std::multiset<std::uint32_t>(view.references.begin(), view.references.end()));
      EXPECT_EQ(walk.nodeCount, view.wide->nodes.size());
    }
  }
}

// One stray vertex makes areas that no float holds: the plan must not be made of infinities.
TEST(WidenTree, HoldsEveryReferenceBesideAFaceFarBeyondTheRange) {
  for (const float far : {1e15f, 1e20f, 1e25f, 3e38f}) {
    SCOPED_TRACE(far);
    for (const BuildOptions& options :
         {BuildOptions{}, BuildOptions::fast(), BuildOptions::high()}) {
      TriangleMesh<float> mesh = test::detail::soup<float>(23, 3000, 0.1);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(),
                            {{far, far, far}, {far * 0.5f, far, 0}, {0, far * 0.75f, far}});
      mesh.faces.push_back({first, first + 1, first + 2});
      const auto tree = buildTree(mesh.view(), options);
      const TreeView<float> view = tree.view();
      std::multiset<std::uint32_t> objects;
      std::size_t nodeCount = 0;
      for (const TriangleBlock& block : view.wide->blocks) {
        for (std::size_t lane = 0; (block.usedLanes >> lane & 1u) != 0; ++lane)
          objects.insert(block.objects[lane]);
      }
      EXPECT_EQ(objects,
                std::multiset<std::uint32_t>(view.references.begin(), view.references.end()));
      for (const WideNode& node : view.wide->nodes) {
        for (const SlotOrder& order : node.orders) {
          std::set<std::size_t> slots;
          for (std::size_t i = 0; i < WideNode::kSlotCount; ++i)
            slots.insert(order[i]);
          EXPECT_EQ(slots.size(), WideNode::kSlotCount);
        }
        ++nodeCount;
      }
      EXPECT_GT(nodeCount, 0u);
    }
  }
}

/// Spheres and a mesh in one tree, as leaves of every size.
TEST(WidenTree, HoldsEveryReferenceOnceBesideShapes) {
  for (const std::uint32_t leafSize : {0u, 1u, 4u, 15u, 16u, 17u, 40u, 300u, 1000u}) {
    SCOPED_TRACE(leafSize);
    Scene<float> scene;
    scene.add(test::detail::soup<float>(22, 300, 0.1));
    scene.add(makeSpheres(400));
    const auto tree = buildTree(scene, {.leafSize = leafSize});
    const TreeView<float> view = tree.view();
    const WideWalk walk(view);
    EXPECT_EQ(walk.objects,
              std::multiset<std::uint32_t>(view.references.begin(), view.references.end()));
    EXPECT_EQ(walk.nodeCount, view.wide->nodes.size());
  }
}

TEST(WidenTree, GivesEachShapeTheBoxOfItsOwn) {
  const auto tree = buildTree(makeSpheres(500), {.leafSize = 30, .depthLimit = 4});
  const TreeView<float> view = tree.view();
  std::size_t seenCount = 0;
  for (const WideNode& node : view.wide->nodes) {
    for (std::size_t slot = 0; slot < WideNode::kSlotCount; ++slot) {
      const bool isFilled = node.planes[0][slot] <= node.planes[1][slot];
      if (!isFilled || !node.children[slot].isObject())
        continue;
      ++seenCount;
      const Box3 bounds = tree.object(node.children[slot].objectNumber()).bounds();
      for (const Axis axis : kAxes) {
        const auto i = 2 * static_cast<std::size_t>(axis);
        const float center = view.wide->frame.center[i / 2];
        EXPECT_GE(node.planes[i][slot] + center, bounds.lower[axis] - 1e-6f);
        EXPECT_LE(node.planes[i + 1][slot] + center, bounds.upper[axis] + 1e-6f);
      }
    }
  }
  EXPECT_EQ(seenCount, view.references.size());
}

TEST(WidenTree, FillsItsSlots) {
  const auto tree = buildTree(test::detail::grid<float>(50, {0, 0, 0}, {1, 0, 0.1f}, {0.2f, 1, 0}));
  const WideTree& wide = *tree.view().wide;
  std::size_t filledCount = 0;
  for (const WideNode& node : wide.nodes) {
    for (std::size_t slot = 0; slot < WideNode::kSlotCount; ++slot)
      filledCount += node.planes[0][slot] <= node.planes[1][slot] ? 1 : 0;
  }
  EXPECT_GT(filledCount, wide.nodes.size() * WideNode::kSlotCount / 2);
}

TEST(WidenTree, GivesManyBlocksOfALeafBoxesOfTheirOwn) {
  BuildOptions oneLeaf;
  oneLeaf.depthLimit = 1;
  const auto tree = buildTree(test::detail::soup<float>(22, 400, 0.02), oneLeaf);
  ASSERT_TRUE(tree.root().isLeaf());
  const WideTree& wide = *tree.view().wide;
  ASSERT_TRUE(wide.root.isNode());
  const WideNode& node = wide.nodes[wide.root.nodeIndex()];
  // Divided where it pays the most, they overlap little.
  double volume = 0.0;
  std::size_t filledCount = 0;
  for (std::size_t slot = 0; slot < WideNode::kSlotCount; ++slot) {
    const double x = static_cast<double>(node.planes[1][slot] - node.planes[0][slot]);
    const double y = static_cast<double>(node.planes[3][slot] - node.planes[2][slot]);
    const double z = static_cast<double>(node.planes[5][slot] - node.planes[4][slot]);
    if (x < 0.0)
      continue;
    ++filledCount;
    volume += x * y * z;
  }
  EXPECT_GT(filledCount, WideNode::kSlotCount / 2);
  const auto size = static_cast<Vec3d>(tree.bounds().size());
  EXPECT_LT(volume, 1.2 * size.x * size.y * size.z);
}

TEST(WidenTree, PutsTheLargestBoxesLast) {
  const auto tree = buildTree(test::detail::soup<float>(23, 3000, 0.1));
  for (const WideNode& node : tree.view().wide->nodes) {
    float before = 0.0f;
    for (std::size_t slot = 0; slot < WideNode::kSlotCount; ++slot) {
      const float x = node.planes[1][slot] - node.planes[0][slot];
      if (!(x >= 0.0f))
        continue;
      const float y = node.planes[3][slot] - node.planes[2][slot];
      const float z = node.planes[5][slot] - node.planes[4][slot];
      const float area = x * y + y * z + z * x;
      EXPECT_GE(area, before);
      before = area;
    }
  }
}

TEST(SlotOrder, GivesBackWhatItWasMadeFrom) {
  std::array<std::uint8_t, 16> slots = {3, 1, 0, 2, 15, 14, 13, 12, 4, 6, 5, 7, 11, 9, 10, 8};
  const SlotOrder order(slots);
  for (std::size_t i = 0; i < slots.size(); ++i)
    EXPECT_EQ(order[i], slots[i]);
}

/// A split of space along x, then y: the order of the four leaves is known.
TEST(WidenTree, OrdersSlotsFromFarToNear) {
  TriangleMesh<float> mesh;
  for (const float x : {0.0f, 10.0f}) {
    for (const float y : {0.0f, 10.0f})
      test::detail::addTriangle<float>(mesh, {x, y, 0}, {x + 1, y, 0}, {x, y + 1, 1});
  }
  const auto tree = buildTree(mesh.view(), {.leafSize = 1, .stopsByCost = false});
  const WideTree& wide = *tree.view().wide;
  ASSERT_EQ(wide.nodes.size(), 1u);
  const WideNode& node = wide.nodes.front();
  for (std::size_t octant = 0; octant < 8; ++octant) {
    const auto distanceAlong = [&](std::size_t slot) {
      const float x = node.planes[0][slot] * ((octant & 1u) != 0 ? -1.0f : 1.0f);
      const float y = node.planes[2][slot] * ((octant & 2u) != 0 ? -1.0f : 1.0f);
      return std::pair(x, y);
    };
    // The last four are filled; a slot never comes before one that lies beyond it on both axes.
    for (std::size_t i = 12; i < 16; ++i) {
      for (std::size_t j = i + 1; j < 16; ++j) {
        const auto [farX, farY] = distanceAlong(node.orders[octant][i]);
        const auto [nearX, nearY] = distanceAlong(node.orders[octant][j]);
        EXPECT_FALSE(nearX > farX && nearY > farY) << octant;
      }
    }
  }
}

}  // namespace
}  // namespace planetree::detail
