#include "mesh_bytes.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace planetree::test {
namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\n";

std::vector<FaceIndices> facesOf(const std::string& text) {
  return readText<float>(text).faces;
}

TEST(ReadObj, ReadsVerticesAndTriangles) {
  MeshReadReport report;
  const TriangleMesh<float> mesh = readText<float>(kSquare + "f 1 2 3\nf 1 3 4\n", &report);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5f}}));
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(mesh.sourceFaces.empty());
  EXPECT_EQ(report.format, MeshFormat::Obj);
  EXPECT_EQ(report.polygonCount, 2u);
  EXPECT_EQ(report.skippedPolygonCount, 0u);
  EXPECT_EQ(report.unreadPrimitiveCount, 0u);
}

TEST(ReadObj, TakesTheVertexOfCornersWithTextureAndNormal) {
  const std::vector<FaceIndices> expected = {{0, 1, 2}};
  EXPECT_EQ(facesOf(kSquare + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\n"), expected);
  EXPECT_EQ(facesOf(kSquare + "vt 0 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"), expected);
  EXPECT_EQ(facesOf(kSquare + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/-1/-1 3/1/1\n"), expected);
  EXPECT_EQ(facesOf(kSquare + "fo 1/ 2 3\n"), expected);
}

TEST(ReadObj, CountsNegativeIndicesFromTheLastVertexSoFar) {
  EXPECT_EQ(facesOf(kSquare + "f -4 -3 -2\nv 9 9 9\nf -1 -2 -5\n"),
            (std::vector<FaceIndices>{{0, 1, 2}, {4, 3, 0}}));
}

TEST(ReadObj, PolygonsMayReferToLaterVertices) {
  EXPECT_EQ(facesOf("f 1 2 3\n" + kSquare), (std::vector<FaceIndices>{{0, 1, 2}}));
}

TEST(ReadObj, CutsPolygonsIntoFansThatKnowTheirSource) {
  const TriangleMesh<float> mesh = readText<float>(kSquare + "f 1 2 3 4\nf 4 3 2\n");
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {0, 2, 3}, {3, 2, 1}}));
  EXPECT_EQ(mesh.sourceFaces, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(ReadObj, SkipsAndCountsPolygonsThatCannotBe) {
  MeshReadReport report;
  const TriangleMesh<float> mesh =
      readText<float>(kSquare +
                          "f 1 2 5\nf 0 1 2\nf 1 2\nf -5 1 2\nf\nf 4294967297 1 2\n"
                          "f 99999999999999999999 1 2\nf -99999999999999999999 1 2\nf 1 2 3\n",
                      &report);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}}));
  EXPECT_EQ(mesh.sourceFaces, (std::vector<std::uint32_t>{8}));
  EXPECT_EQ(report.polygonCount, 9u);
  EXPECT_EQ(report.skippedPolygonCount, 8u);
  ASSERT_EQ(report.skipped.size(), 8u);
  EXPECT_EQ(report.skipped[0].line, 5);
  EXPECT_EQ(report.skipped[0].reason, "refers to vertex 5, which does not exist");
  EXPECT_EQ(report.skipped[1].reason, "refers to vertex 0, which does not exist");
  EXPECT_EQ(report.skipped[2].reason, "has fewer than three corners");
  EXPECT_EQ(report.skipped[3].reason, "refers to vertex -5, which does not exist");
  EXPECT_EQ(report.skipped[4].line, 9);
  EXPECT_EQ(report.skipped[5].reason, "refers to vertex 4294967297, which does not exist");
}

TEST(ReadObj, ReadsAllObjectsAndGroupsTogether) {
  EXPECT_EQ(facesOf("mtllib a b.mtl\no one\n" + kSquare +
                    "g a b\nusemtl red \\\ns off\nf 1 2 3\no two\ng\ns 1\nf 2 3 4\n"),
            (std::vector<FaceIndices>{{0, 1, 2}, {1, 2, 3}}));
}

TEST(ReadObj, TakesCommentsCarriageReturnsAndAMissingLastLineEnd) {
  const std::vector<FaceIndices> expected = {{0, 1, 2}};
  EXPECT_EQ(facesOf("# made by hand\n\n" + kSquare + "f 1 2 3 # not 4\n#f 1 2 4"), expected);
  EXPECT_EQ(facesOf("v 0 0 0\r\nv 1 0 0 # end\r\n\r\n\tv\t1  1 0\r\nf 1 2 3\r\n"), expected);
  EXPECT_EQ(facesOf(kSquare + "f 1 2 3"), expected);
  EXPECT_EQ(facesOf("\xEF\xBB\xBF" + kSquare + "f 1 2 3"), expected);
}

TEST(ReadObj, JoinsLinesThatEndWithABackslash) {
  const TriangleMesh<float> mesh =
      readText<float>("v 0 \\\n0 0\nv 1 0 0\nv 1 1 0\nf 1 2\\\r\n  3\nf 3 \\\n 2 \\\n 1\\");
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {2, 1, 0}}));
}

TEST(ReadObj, ABackslashAtTheEndOfACommentOrNameHidesNothing) {
  EXPECT_EQ(facesOf("# C:\\models\\\nv 0 0 0\ng a\\\nv 1 0 0\no b\\\nv 1 1 0\nusemtl c\\\nf 1 2 3"),
            (std::vector<FaceIndices>{{0, 1, 2}}));
}

TEST(ReadObj, LinesAreCountedAcrossJoinedOnes) {
  expectMalformed("v 0 \\\n0 \\\n0\nv 1 0 x\n", 4, "\"x\" is not a number");
  expectMalformed("v 0 0 0\nv 1 \\\n0 x\n", 2, "\"x\" is not a number");
}

TEST(ReadObj, TakesWeightsAndColoursOfVertices) {
  const TriangleMesh<float> mesh =
      readText<float>("v 1 2 3 1.0\nv 4 5 6 0.1 0.2 0.3\nv 7 8 9 1 0.1 0.2 0.3\n");
  EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
}

TEST(ReadObj, CountsWhatIsNoPolygon) {
  MeshReadReport report;
  const TriangleMesh<float> mesh = readText<float>(
      kSquare + "p 1\nl 1 2 3\nf 1 2 3\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n",
      &report);
  EXPECT_EQ(mesh.faces.size(), 1u);
  EXPECT_EQ(report.polygonCount, 1u);
  EXPECT_EQ(report.unreadPrimitiveCount, 3u);
}

TEST(ReadObj, NumbersAreRoundedOnceToNearest) {
  const std::string text = "v 0.3 1e400 -nan\nv 1.0000000596046447753906251 0 0\n";
  const TriangleMesh<double> exact = readText<double>(text);
  EXPECT_EQ(exact.positions[0].x, 0.3);
  EXPECT_EQ(exact.positions[0].y, std::numeric_limits<double>::infinity());
  EXPECT_NE(exact.positions[0].z, exact.positions[0].z);
  EXPECT_EQ(readText<float>(text).positions[0].x, 0.3f);
  EXPECT_EQ(readText<float>(text).positions[1].x, std::nextafter(1.0f, 2.0f));
}

TEST(ReadObj, NoPolygonsAreAnEmptyMesh) {
  EXPECT_TRUE(readText<float>("# nothing was selected\n").faces.empty());
  EXPECT_TRUE(readText<float>("mtllib a.mtl\n").faces.empty());
  EXPECT_TRUE(readText<float>(kSquare).faces.empty());
}

TEST(ReadObj, RefusesVerticesThatAreNone) {
  expectMalformed("v 0 0 0\nv 1 2\n", 2, "the vertex has fewer than three coordinates");
  expectMalformed("v 0 0 0\nv\n", 2, "the vertex has fewer than three coordinates");
  expectMalformed("v 0 0 # 0\n", 1, "the vertex has fewer than three coordinates");
  expectMalformed("v 0 0 0\n\nv 1 abc 2\n", 3, "\"abc\" is not a number");
  expectMalformed("v 1,5 2 3\n", 1, "with points, not commas");
  expectMalformed("v 1 2 3 red\n", 1, "\"red\" is not a number");
}

TEST(ReadObj, RefusesCornersThatAreNone) {
  for (const std::string corner : {"x", "1.5", "/1", "1/a", "1e0", "--1", "1/1/1x"}) {
    expectMalformed(kSquare + "f 1 2 " + corner + "\n", 5,
                    "\"" + corner + "\" is not a corner of a face");
  }
}

TEST(ReadObj, RefusesKeywordsItDoesNotKnow) {
  expectMalformed(kSquare + "face 1 2 3\n", 5, "the keyword \"face\" is unknown");
  expectMalformed(kSquare + "F 1 2 3\n", 5, "the keyword \"F\" is unknown");
}

TEST(ReadObj, RefusesToIncludeOtherFiles) {
  expectMalformed(kSquare + "call other.obj\n", 5, "includes another file");
  expectMalformed(kSquare + "csh cat other.obj\n", 5, "includes another file");
}

}  // namespace
}  // namespace planetree::test
