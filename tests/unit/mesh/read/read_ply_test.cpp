#include "mesh_bytes.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace planetree::test {
namespace {

const std::string kSquareHeader =
    "element vertex 4\n"
    "property float x\nproperty float y\nproperty float z\n"
    "element face 2\n"
    "property list uchar int vertex_indices\n"
    "end_header\n";

const std::string kAsciiSquare = "ply\nformat ascii 1.0\n" + kSquareHeader +
                                 "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n"
                                 "3 0 1 2\n3 0 2 3\n";

std::string binarySquare(std::endian order) {
  std::string file = std::string("ply\nformat ") +
                     (order == std::endian::little ? "binary_little_endian" : "binary_big_endian") +
                     " 1.0\n" + kSquareHeader;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, .5f}) {
    file += bytesOf(x, order);
  }
  for (const int corner : {0, 1, 2}) {
    if (corner == 0)
      file += '\3';
    file += bytesOf(corner, order);
  }
  file += '\3';
  for (const int corner : {0, 2, 3})
    file += bytesOf(corner, order);
  return file;
}

template <class T>
void expectSquare(const TriangleMesh<T>& mesh) {
  const std::vector<Vec3<T>> positions = {
      {T(0), T(0), T(0)}, {T(1), T(0), T(0)}, {T(1), T(1), T(0)}, {T(0), T(1), T(0.5)}};
  EXPECT_EQ(mesh.positions, positions);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(mesh.sourceFaces.empty());
}

std::string withCarriageReturns(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n')
      result += '\r';
    result += c;
  }
  return result;
}

TEST(ReadPly, ReadsAscii) {
  MeshReadReport report;
  expectSquare(readText<float>(kAsciiSquare, &report));
  EXPECT_EQ(report.format, MeshFormat::Ply);
  EXPECT_EQ(report.polygonCount, 2u);
  EXPECT_EQ(report.skippedPolygonCount, 0u);
  EXPECT_TRUE(report.skipped.empty());
  expectSquare(readText<double>(kAsciiSquare));
}

TEST(ReadPly, ReadsBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    expectSquare(readText<float>(binarySquare(order)));
    expectSquare(readText<double>(binarySquare(order)));
  }
}

TEST(ReadPly, TakesCarriageReturnsBlankLinesAndAMissingLastLineEnd) {
  expectSquare(readText<float>(withCarriageReturns(kAsciiSquare)));
  expectSquare(readText<float>(kAsciiSquare.substr(0, kAsciiSquare.size() - 1)));
  expectSquare(readText<float>(kAsciiSquare + "\n  \n"));
  std::string file = binarySquare(std::endian::little);
  const std::size_t body = file.find("end_header\n") + 11;
  file = withCarriageReturns(file.substr(0, body)) + file.substr(body);
  expectSquare(readText<float>(file));
  expectSquare(readText<float>(file + "\r\n"));
}

TEST(ReadPly, SkipsCommentsAndObjInfo) {
  expectSquare(readText<float>("ply\ncomment a b c\nobj_info num_cols 512\ncomment\n\n" +
                               kAsciiSquare.substr(4)));
}

/// One vertex and one face of three corners, with the type names of the file format's two dialects.
template <class Coordinate, class Count, class Index>
void expectReadsTypes(const std::string& coordinate, const std::string& count,
                      const std::string& index) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const std::string encoding = order == std::endian::little ? "little" : "big";
    std::string file = "ply\nformat binary_" + encoding + "_endian 1.0\nelement vertex 2\n";
    for (const char* const axis : {"x", "y", "z"}) {
      file += "property " + coordinate + " " + axis + "\n";
    }
    file += "element face 1\nproperty list " + count + " " + index + " vertex_index\nend_header\n";
    for (const int x : {1, 2, 3, 100, 101, 102})
      file += bytesOf(static_cast<Coordinate>(x), order);
    file += bytesOf(static_cast<Count>(3), order);
    for (const int corner : {0, 1, 0})
      file += bytesOf(static_cast<Index>(corner), order);
    const TriangleMesh<float> mesh = readText<float>(file);
    EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{1, 2, 3}, {100, 101, 102}})) << file;
    EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 0}})) << file;
  }
}

TEST(ReadPly, KnowsEveryTypeByBothNames) {
  expectReadsTypes<std::int8_t, std::int8_t, std::int8_t>("char", "char", "char");
  expectReadsTypes<std::uint8_t, std::uint8_t, std::uint8_t>("uchar", "uchar", "uchar");
  expectReadsTypes<std::int16_t, std::int16_t, std::int16_t>("short", "short", "short");
  expectReadsTypes<std::uint16_t, std::uint16_t, std::uint16_t>("ushort", "ushort", "ushort");
  expectReadsTypes<std::int32_t, std::int32_t, std::int32_t>("int", "int", "int");
  expectReadsTypes<std::uint32_t, std::uint32_t, std::uint32_t>("uint", "uint", "uint");
  expectReadsTypes<float, std::uint8_t, std::int32_t>("float", "uchar", "int");
  expectReadsTypes<double, std::uint8_t, std::int32_t>("double", "uchar", "int");
  expectReadsTypes<std::int8_t, std::int8_t, std::int8_t>("int8", "int8", "int8");
  expectReadsTypes<std::uint8_t, std::uint8_t, std::uint8_t>("uint8", "uint8", "uint8");
  expectReadsTypes<std::int16_t, std::int16_t, std::int16_t>("int16", "int16", "int16");
  expectReadsTypes<std::uint16_t, std::uint16_t, std::uint16_t>("uint16", "uint16", "uint16");
  expectReadsTypes<std::int32_t, std::int32_t, std::int32_t>("int32", "int32", "int32");
  expectReadsTypes<std::uint32_t, std::uint32_t, std::uint32_t>("uint32", "uint32", "uint32");
  expectReadsTypes<float, std::uint8_t, std::int32_t>("float32", "uint8", "int32");
  expectReadsTypes<double, std::uint8_t, std::int32_t>("float64", "uint8", "int32");
}

const std::string kCrowdedHeader =
    "element material 2\nproperty list ushort float shine\nproperty uchar red\n"
    "element vertex 3\n"
    "property double z\nproperty list uchar short near\nproperty float x\nproperty uchar red\n"
    "property short y\n"
    "element marker 7\n"
    "element face 1\n"
    "property uchar flags\nproperty list uchar float texcoord\n"
    "property list uint uint vertex_indices\nproperty float quality\n"
    "element edge 1\nproperty int a\nproperty int b\n"
    "end_header\n";

const std::vector<Vec3f> kCrowdedPositions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};

TEST(ReadPly, SkipsOtherPropertiesElementsAndListsInAscii) {
  const TriangleMesh<float> mesh = readText<float>("ply\nformat ascii 1.0\n" + kCrowdedHeader +
                                                   "2 0.5 0.25 255\n0 7\n"
                                                   "3 0 1 255 2\n6 2 8 9 4 255 5\n9 0 7 255 8\n"
                                                   "1 2 0.5 0.5 3 2 1 0 0.125\n"
                                                   "0 1\n");
  EXPECT_EQ(mesh.positions, kCrowdedPositions);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{2, 1, 0}}));
}

TEST(ReadPly, SkipsOtherPropertiesElementsAndListsInBinary) {
  std::string file = "ply\nformat binary_little_endian 1.0\n" + kCrowdedHeader;
  file += bytesOf(std::uint16_t{2}) + bytesOf(.5f) + bytesOf(.25f) + '\xFF';
  file += bytesOf(std::uint16_t{0}) + '\7';
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3f& position = kCrowdedPositions[i];
    file += bytesOf(static_cast<double>(position.z)) + static_cast<char>(i);
    for (std::size_t j = 0; j < i; ++j)
      file += bytesOf(std::int16_t{9});
    file += bytesOf(position.x) + '\xFF' + bytesOf(static_cast<std::int16_t>(position.y));
  }
  file += '\1' + bytesOf(std::uint8_t{2}) + bytesOf(.5f) + bytesOf(.5f);
  for (const std::uint32_t x : {3u, 2u, 1u, 0u})
    file += bytesOf(x);
  file += bytesOf(.125f) + bytesOf(0) + bytesOf(1);
  const TriangleMesh<float> mesh = readText<float>(file);
  EXPECT_EQ(mesh.positions, kCrowdedPositions);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{2, 1, 0}}));
}

std::string asciiFile(std::size_t vertexCount, std::size_t faceCount, const std::string& body) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertexCount) +
         "\nproperty float x\nproperty double y\nproperty int z\nelement face " +
         std::to_string(faceCount) + "\nproperty list char int vertex_indices\nend_header\n" + body;
}

TEST(ReadPly, CutsPolygonsIntoFansThatKnowTheirSource) {
  const TriangleMesh<float> mesh = readText<float>(
      asciiFile(5, 3, "0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 0\n3 0 1 2\n5 0 1 2 3 4\n4 4 3 2 1\n"));
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{
                            {0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {4, 3, 2}, {4, 2, 1}}));
  EXPECT_EQ(mesh.sourceFaces, (std::vector<std::uint32_t>{0, 1, 1, 1, 2, 2}));
}

TEST(ReadPly, SkipsAndCountsPolygonsThatCannotBe) {
  MeshReadReport report;
  const TriangleMesh<float> mesh = readText<float>(
      asciiFile(3, 5, "0 0 0\n1 0 0\n2 0 0\n3 0 1 3\n2 0 1\n3 0 1 2\n0\n3 -1 0 1\n"), &report);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}}));
  EXPECT_EQ(mesh.sourceFaces, (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(report.polygonCount, 5u);
  ASSERT_EQ(report.skippedPolygonCount, 4u);
  ASSERT_EQ(report.skipped.size(), 4u);
  EXPECT_EQ(report.skipped[0].polygon, 0u);
  EXPECT_EQ(report.skipped[0].line, 13);
  EXPECT_EQ(report.skipped[0].reason, "refers to vertex 3, which does not exist");
  EXPECT_EQ(report.skipped[1].polygon, 1u);
  EXPECT_EQ(report.skipped[1].reason, "has fewer than three corners");
  EXPECT_EQ(report.skipped[2].polygon, 3u);
  EXPECT_EQ(report.skipped[3].polygon, 4u);
  EXPECT_EQ(report.skipped[3].reason, "refers to vertex -1, which does not exist");
}

TEST(ReadPly, NamesTheFirstSkippedPolygonsAndCountsAll) {
  std::string body = "0 0 0\n";
  for (int i = 0; i < 1000; ++i)
    body += "3 0 0 1\n";
  MeshReadReport report;
  EXPECT_TRUE(readText<float>(asciiFile(1, 1000, body), &report).faces.empty());
  EXPECT_EQ(report.skippedPolygonCount, 1000u);
  EXPECT_GE(report.skipped.size(), 1u);
  EXPECT_LE(report.skipped.size(), 100u);
}

TEST(ReadPly, FacesMayComeBeforeTheirVertices) {
  MeshReadReport report;
  const TriangleMesh<float> mesh = readText<float>(
      "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar uint vertex_indices\n"
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
      "3 0 1 2\n3 1 2 3\n0 0 0\n1 0 0\n0 1 0\n",
      &report);
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}}));
  EXPECT_EQ(report.skippedPolygonCount, 1u);
}

TEST(ReadPly, CutsTriangleStripsAndTurnsEveryOtherTriangle) {
  const TriangleMesh<float> mesh = readText<float>(
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 0\n"
      "11 0 1 2 3 -1 2 1 -1 4 3 2\n");
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {2, 1, 3}, {4, 3, 2}}));
  EXPECT_TRUE(mesh.sourceFaces.empty());
}

TEST(ReadPly, DoubleKeepsAllDigits) {
  const std::string text = asciiFile(1, 0, "0.1 1e-300 16777217\n");
  const TriangleMesh<double> exact = readText<double>(text);
  EXPECT_EQ(exact.positions[0], (Vec3d{0.1, 1e-300, 16777217}));

  std::string binary =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty double x\n"
      "property double y\nproperty float z\nend_header\n";
  binary += bytesOf(1.0 / 3.0, std::endian::big) + bytesOf(1e300, std::endian::big) +
            bytesOf(0.1f, std::endian::big);
  EXPECT_EQ(readText<double>(binary).positions[0],
            (Vec3d{1.0 / 3.0, 1e300, static_cast<double>(0.1f)}));
}

TEST(ReadPly, FloatRoundsOnceToNearest) {
  // Just above the middle of two floats, but rounded to double it is the middle, which then goes to
  // the even side: below.
  const TriangleMesh<float> mesh =
      readText<float>(asciiFile(1, 0, "1.0000000596046447753906251 0.1 0\n"));
  EXPECT_EQ(mesh.positions[0].x, std::nextafter(1.0f, 2.0f));
  EXPECT_EQ(mesh.positions[0].y, 0.1f);
}

TEST(ReadPly, NumbersOutOfRangeBecomeInfinityOrZero) {
  const float infinity = std::numeric_limits<float>::infinity();
  const auto first = [](const std::string& xyz) {
    return readText<float>(
               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
               "property float y\nproperty float z\nend_header\n" +
               xyz)
        .positions[0];
  };
  EXPECT_EQ(first("1e39 -1e39 1e-60"), (Vec3f{infinity, -infinity, 0}));
  EXPECT_EQ(first("1e999 -1e99999999999999999999 1e-99999999999999999999"),
            (Vec3f{infinity, -infinity, 0}));
  EXPECT_EQ(first("0.001e42 1000e-60 0e999"), (Vec3f{infinity, 0, 0}));
  EXPECT_EQ(first("100000000000000000000000000000000000000000 +2.5 -.5"),
            (Vec3f{infinity, 2.5f, -0.5f}));
  EXPECT_TRUE(std::signbit(first("-1e-60 0 0").x));
  EXPECT_EQ(first("inf -Infinity 0").y, -infinity);
  EXPECT_TRUE(std::isnan(first("nan 0 0").x));
  EXPECT_TRUE(std::isnan(first("-nan 0 0").x));
}

TEST(ReadPly, LargeDoublesBecomeInfinityInFloat) {
  std::string file =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\n"
      "property double y\nproperty double z\nend_header\n";
  file += bytesOf(1e300) + bytesOf(-1e300) + bytesOf(1e-300);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(readText<float>(file).positions[0], (Vec3f{infinity, -infinity, 0}));
}

TEST(ReadPly, NoVerticesAndNoFacesAreAnEmptyMesh) {
  const TriangleMesh<float> empty = readText<float>(asciiFile(0, 0, ""));
  EXPECT_TRUE(empty.positions.empty());
  EXPECT_TRUE(empty.faces.empty());
  const TriangleMesh<float> points = readText<float>(asciiFile(1, 0, "1 2 3\n"));
  EXPECT_EQ(points.positions.size(), 1u);
  EXPECT_TRUE(points.faces.empty());
}

TEST(ReadPly, FacesWithoutVerticesAreSkipped) {
  MeshReadReport report;
  EXPECT_TRUE(readText<float>(asciiFile(0, 1, "3 0 1 2\n"), &report).faces.empty());
  EXPECT_EQ(report.skippedPolygonCount, 1u);
}

}  // namespace
}  // namespace planetree::test
