#include "import/weld_corners.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace planetree::test {
namespace {

using importing::weldCorners;
using scene::MeshShape;

/// Two triangles of a square, with corners of their own.
MeshShape square() {
  MeshShape mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  return mesh;
}

TEST(WeldCorners, MakesOneVertexOfEquals) {
  MeshShape mesh = square();
  weldCorners(mesh);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(WeldCorners, KeepsApartWhatDiffersInNormalOrCoordinate) {
  MeshShape creased = square();
  creased.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}};
  weldCorners(creased);
  EXPECT_EQ(creased.positions.size(), 5u);
  EXPECT_EQ(creased.normals.size(), 5u);
  EXPECT_EQ(creased.normals[creased.faces[1][0]], (Vec3d{0, 1, 0}));

  MeshShape mapped = square();
  mapped.coordinates = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {0.5, 1}, {0, 1}};
  weldCorners(mapped);
  EXPECT_EQ(mapped.positions.size(), 5u);
  EXPECT_EQ(mapped.coordinates[mapped.faces[1][1]], (std::array<double, 2>{0.5, 1}));
}

TEST(WeldCorners, TakesManyAndStrangeNumbers) {
  MeshShape mesh;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::uint32_t i = 0; i < 3000; i += 3) {
    mesh.positions.push_back({static_cast<double>(i / 30), 0, 0});
    mesh.positions.push_back({nan, 0, 0});
    mesh.positions.push_back({0, -0.0, 0});
    mesh.faces.push_back({i, i + 1, i + 2});
  }
  weldCorners(mesh);
  // A hundred places, one NaN, and a zero with a sign.
  EXPECT_EQ(mesh.positions.size(), 102u);
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
    EXPECT_EQ(mesh.positions[mesh.faces[i][0]].x, static_cast<double>(i / 10));
  MeshShape none;
  weldCorners(none);
  EXPECT_TRUE(none.positions.empty());
}

}  // namespace
}  // namespace planetree::test
