#include "mesh_bytes.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <string>

#include <gtest/gtest.h>

namespace planetree::test {
namespace {

const std::string kSquare = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

TEST(ReadOff, CutsPolygonsIntoTriangles) {
  MeshReadReport report;
  const TriangleMesh<float> mesh = readText<float>(kSquare, &report);
  EXPECT_EQ(report.format, MeshFormat::Off);
  EXPECT_EQ(report.polygonCount, 1u);
  ASSERT_EQ(mesh.faces.size(), 2u);
  EXPECT_EQ(mesh.faces[1], (FaceIndices{0, 2, 3}));
  EXPECT_EQ(mesh.positions[2], (Vec3f{1, 1, 0}));
}

TEST(ReadOff, ReadsPolygonsOfAnySize) {
  std::string text = "OFF\n12 1 0\n";
  std::string face = "12";
  for (int i = 0; i < 12; ++i) {
    text += std::to_string(i) + ' ' + std::to_string(i * i) + " 0\n";
    face += ' ';
    face += std::to_string(i);
  }
  EXPECT_EQ(readText<double>(text + face).faces.size(), 10u);
}

TEST(ReadOff, PassesOverCommentsColoursAndNormals) {
  const std::string text =
      "# by hand\n\nSTCNOFF 3 1 3 # counts\n\n0 0 0 0 0 1 255 0 0 255 0 0\r\n"
      "1 0 0 # no colour\n# a comment between\n0 1 0\n3 0 1 2 0.5 0.5 0.5\n\n# the end";
  EXPECT_EQ(readText<float>(text).faces.size(), 1u);
}

TEST(ReadOff, DoesWithoutTheNumberOfEdges) {
  EXPECT_EQ(readText<float>("OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").faces.size(), 1u);
}

TEST(ReadOff, TakesPointsWithoutFaces) {
  const TriangleMesh<float> mesh = readText<float>("OFF\n1 0 0\n1 2 3\n");
  EXPECT_EQ(mesh.positions.size(), 1u);
  EXPECT_TRUE(mesh.faces.empty());
}

TEST(ReadOff, SkipsAndCountsFacesWithoutTheirVertices) {
  MeshReadReport report;
  const TriangleMesh<float> mesh = readText<float>(
      "OFF\n3 5 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n3 0 1 -1\n2 0 1\n0\n3 0 1 2\n", &report);
  EXPECT_EQ(mesh.faces.size(), 1u);
  EXPECT_EQ(mesh.sourceFace(0), 4u);
  EXPECT_EQ(report.polygonCount, 5u);
  ASSERT_EQ(report.skippedPolygonCount, 4u);
  EXPECT_EQ(report.skipped[0].reason, "refers to vertex 3, which does not exist");
  EXPECT_EQ(report.skipped[0].line, 6);
  EXPECT_EQ(report.skipped[2].reason, "has fewer than three corners");
}

TEST(ReadOff, CountsCoordinatesThatAreTooLargeForFloatAlone) {
  const std::string text = "OFF\n3 1 0\n1e300 0 0\ninf 0 0\n0 1 0\n3 0 1 2\n";
  MeshReadReport report;
  static_cast<void>(readText<float>(text, &report));
  EXPECT_EQ(report.tooLargeCount, 1u);
  static_cast<void>(readText<double>(text, &report));
  EXPECT_EQ(report.tooLargeCount, 0u);
}

TEST(ReadOff, RefusesCountsThatAreNone) {
  expectMalformed("OFF\n", 1, "number of vertices is missing");
  expectMalformed("OFF\n3\n", 2, "number of faces is missing");
  expectMalformed("OFF\n-3 1 0\n", 2, "number of vertices is -3");
  expectMalformed("OFF\nthree 1 0\n", 2, "\"three\" is not a whole number");
  expectMalformed("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", 6, "number of corners is -3");
}

TEST(ReadOff, RefusesFilesThatEndEarlyOrLate) {
  expectMalformed("OFF\n3 1 0\n0 0 0\n1 0 0\n", 4,
                  "promises 3 vertices, but the file ends before vertex 2");
  expectMalformed("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n", 5,
                  "promises 1 face, but the file ends before face 0");
  expectMalformed("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", 4, "too few values for vertex 1");
  expectMalformed("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", 6, "too few values for face 0");
  expectMalformed(kSquare + "3 0 1 2\n", 8, "goes on behind the last face");
  expectMalformed("OFF\n4294967295 4294967295 0\n0 0 0\n", 3, "ends before vertex 1");
  expectMalformed("OFF\n1 1 0\n0 0 0\n4294967295 0\n", 4, "too few values for face 0");
}

TEST(ReadOff, RefusesNumbersThatAreNone) {
  expectMalformed("OFF\n1 0 0\n0 x 0\n", 3, "\"x\" is not a number");
  expectMalformed("OFF\n1 1 0\n0 0 0\n3 0 0 0.5\n", 4, "\"0.5\" is not a whole number");
}

TEST(ReadOff, RefusesTheFormsThatItDoesNotRead) {
  expectMalformed("OFF BINARY\n", 1, "a binary OFF file");
  expectMalformed("4OFF\n1 0 0\n0 0 0 1\n", 1, "another number of coordinates than three");
  expectMalformed("nOFF\n5\n", 1, "another number of coordinates than three");
}

}  // namespace
}  // namespace planetree::test
