#include <planetree/mesh/triangle_mesh.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

namespace planetree::test {
namespace {

using Corners = std::vector<std::uint32_t>;

TEST(TriangleMesh, TrianglesAreTheirOwnSource) {
  TriangleMesh<float> mesh;
  mesh.addPolygon(Corners{0, 1, 2}, 0);
  mesh.addPolygon(Corners{2, 1, 3}, 1);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_TRUE(mesh.sourceFaces.empty());
  EXPECT_EQ(mesh.sourceFace(0), 0u);
  EXPECT_EQ(mesh.sourceFace(1), 1u);
}

TEST(TriangleMesh, PolygonsBecomeFansAroundTheirFirstCorner) {
  TriangleMesh<double> mesh;
  mesh.addPolygon(Corners{5, 6, 7, 8, 9}, 0);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{5, 6, 7}, {5, 7, 8}, {5, 8, 9}}));
  EXPECT_EQ(mesh.sourceFaces, (Corners{0, 0, 0}));
}

TEST(TriangleMesh, SourcesAreKeptFromTheFirstPolygonThatNeedsThem) {
  TriangleMesh<float> mesh;
  mesh.addPolygon(Corners{0, 1, 2}, 0);
  mesh.addPolygon(Corners{0, 1, 2}, 1);
  mesh.addPolygon(Corners{0, 1, 2, 3}, 2);
  mesh.addPolygon(Corners{0, 1, 2}, 3);
  EXPECT_EQ(mesh.sourceFaces, (Corners{0, 1, 2, 2, 3}));
  for (std::uint32_t i = 0; i < 5; ++i)
    EXPECT_EQ(mesh.sourceFace(i), mesh.sourceFaces[i]);
}

TEST(TriangleMesh, SourcesAreKeptWhenAPolygonIsLeftOut) {
  TriangleMesh<float> first;
  first.addPolygon(Corners{0, 1, 2}, 1);
  EXPECT_EQ(first.sourceFaces, (Corners{1}));
  TriangleMesh<float> later;
  later.addPolygon(Corners{0, 1, 2}, 0);
  later.addPolygon(Corners{0, 1, 2}, 2);
  EXPECT_EQ(later.sourceFaces, (Corners{0, 2}));
}

TEST(TriangleMesh, FewerThanThreeCornersAddNothing) {
  TriangleMesh<float> mesh;
  mesh.addPolygon(Corners{}, 0);
  mesh.addPolygon(Corners{0}, 0);
  mesh.addPolygon(Corners{0, 1}, 0);
  EXPECT_TRUE(mesh.faces.empty());
  EXPECT_TRUE(mesh.sourceFaces.empty());
}

TEST(TriangleMesh, PolygonsTakeIndicesAsTheyAre) {
  TriangleMesh<float> mesh;
  mesh.addPolygon(Corners{7, 7, 0xFFFF'FFFFu}, 0);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{7, 7, 0xFFFF'FFFFu}}));
}

TEST(TriangleMeshView, SeesTheArraysOfItsMesh) {
  TriangleMesh<double> mesh;
  mesh.positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  mesh.addPolygon(Corners{2, 0, 1}, 0);
  const TriangleMeshView<double> view = mesh.view();
  EXPECT_EQ(view.vertexCount(), 3u);
  ASSERT_EQ(view.size(), 1u);
  EXPECT_FALSE(view.empty());
  EXPECT_EQ(view.position(1), (Vec3d{4, 5, 6}));
  EXPECT_EQ(view.indices(0), (FaceIndices{2, 0, 1}));
  EXPECT_EQ(view.corners(0),
            (std::array<Vec3d, 3>{Vec3d{7, 8, 9}, Vec3d{1, 2, 3}, Vec3d{4, 5, 6}}));
  EXPECT_EQ(view[0].index(), 0u);
}

TEST(TriangleMeshView, OfNothingIsEmpty) {
  EXPECT_TRUE(TriangleMeshView<float>().empty());
  EXPECT_EQ(TriangleMeshView<float>().vertexCount(), 0u);
  EXPECT_TRUE(TriangleMesh<float>().view().empty());
}

TEST(TriangleMeshView, ReadsPositionsAndFacesAmongOtherData) {
  struct Vertex {
    float u, v;
    float x, y, z;
  };
  struct Triangle {
    std::uint32_t material;
    std::uint32_t a, b, c;
  };
  const std::vector<Vertex> vertices = {{9, 9, 1, 2, 3}, {9, 9, 4, 5, 6}, {9, 9, 7, 8, 9}};
  const std::vector<Triangle> triangles = {{9, 0, 1, 2}, {9, 2, 1, 0}};
  const TriangleMeshView<float> view(&vertices[0].x, sizeof(Vertex), vertices.size(),
                                     &triangles[0].a, sizeof(Triangle), triangles.size());
  EXPECT_EQ(view.position(2), (Vec3f{7, 8, 9}));
  EXPECT_EQ(view.indices(1), (FaceIndices{2, 1, 0}));
  EXPECT_EQ(view.corners(1)[2], (Vec3f{1, 2, 3}));
}

/// Positions and faces at odd addresses, packed behind a byte each.
TEST(TriangleMeshView, NeedsNoAlignment) {
  constexpr std::size_t kPositionStride = 3 * sizeof(double) + 1;
  constexpr std::size_t kFaceStride = sizeof(FaceIndices) + 1;
  std::vector<std::byte> positions(1 + 3 * kPositionStride);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto x = static_cast<double>(i);
    const Vec3d position{x, x + 0.25, x + 0.5};
    std::memcpy(&positions[1 + i * kPositionStride], &position, sizeof(position));
  }
  std::vector<std::byte> faces(1 + 2 * kFaceStride);
  for (std::size_t i = 0; i < 2; ++i) {
    const FaceIndices face = i == 0 ? FaceIndices{0, 1, 2} : FaceIndices{2, 1, 0};
    std::memcpy(&faces[1 + i * kFaceStride], face.data(), sizeof(face));
  }
  const TriangleMeshView<double> view(&positions[1], kPositionStride, 3, &faces[1], kFaceStride, 2);
  EXPECT_EQ(view.position(2), (Vec3d{2, 2.25, 2.5}));
  EXPECT_EQ(view.corners(1),
            (std::array<Vec3d, 3>{Vec3d{2, 2.25, 2.5}, Vec3d{1, 1.25, 1.5}, Vec3d{0, 0.25, 0.5}}));
}

TEST(TriangleMeshView, AStrideOfZeroRepeatsOneElement) {
  const Vec3f position{1, 2, 3};
  const FaceIndices face = {0, 1, 2};
  const TriangleMeshView<float> view(&position, 0, 3, face.data(), 0, 5);
  EXPECT_EQ(view.corners(4), (std::array<Vec3f, 3>{position, position, position}));
}

}  // namespace
}  // namespace planetree::test
