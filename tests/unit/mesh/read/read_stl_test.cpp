#include "mesh_bytes.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace planetree::test {
namespace {

using Corners = std::array<Vec3f, 3>;

std::string facetText(const Corners& corners) {
  std::string text = "facet normal 0 0 1\n outer loop\n";
  for (const Vec3f& corner : corners) {
    text += "  vertex " + std::to_string(corner.x) + " " + std::to_string(corner.y) + " " +
            std::to_string(corner.z) + "\n";
  }
  return text + " endloop\nendfacet\n";
}

std::string facetBytes(const Corners& corners) {
  std::string bytes(12, '\0');
  for (const Vec3f& corner : corners) {
    bytes += bytesOf(corner.x) + bytesOf(corner.y) + bytesOf(corner.z);
  }
  return bytes + std::string(2, '\0');
}

std::string binaryFile(const std::vector<Corners>& facets, const std::string& start = "") {
  std::string file = start + std::string(80 - start.size(), ' ');
  file += bytesOf(static_cast<std::uint32_t>(facets.size()));
  for (const Corners& facet : facets)
    file += facetBytes(facet);
  return file;
}

const std::vector<Corners> kSquare = {{Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{1, 1, 0}},
                                      {Vec3f{0, 0, 0}, Vec3f{1, 1, 0}, Vec3f{0, 1, 0.5f}}};

const std::string kSquareText =
    "solid a square\n" + facetText(kSquare[0]) + facetText(kSquare[1]) + "endsolid a square\n";

template <class T>
void expectSquare(const TriangleMesh<T>& mesh) {
  const std::vector<Vec3<T>> positions = {
      {T(0), T(0), T(0)}, {T(1), T(0), T(0)}, {T(1), T(1), T(0)}, {T(0), T(1), T(0.5)}};
  EXPECT_EQ(mesh.positions, positions);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(mesh.sourceFaces.empty());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

TEST(ReadStl, ReadsTextAndMakesOneVertexOfEqualCorners) {
  MeshReadReport report;
  expectSquare(readText<float>(kSquareText, &report));
  EXPECT_EQ(report.format, MeshFormat::Stl);
  EXPECT_EQ(report.polygonCount, 2u);
  expectSquare(readText<double>(kSquareText));
}

TEST(ReadStl, ReadsBinaryAndMakesOneVertexOfEqualCorners) {
  MeshReadReport report;
  expectSquare(readText<float>(binaryFile(kSquare), &report));
  EXPECT_EQ(report.format, MeshFormat::Stl);
  EXPECT_EQ(report.polygonCount, 2u);
  expectSquare(readText<double>(binaryFile(kSquare)));
}

TEST(ReadStl, BinaryMayBeginLikeAnyFormat) {
  for (const std::string start :
       {"solid", "solid name\nfacet normal", "ply\n", "v 0 0 0\n", "\xEF\xBB\xBF"}) {
    expectSquare(readText<float>(binaryFile(kSquare, start)));
  }
}

TEST(ReadStl, TextMayHaveOtherLineEndsCaseAndLayout) {
  expectSquare(readText<float>(replaced(kSquareText, "\n", "\r\n")));
  expectSquare(readText<float>(replaced(replaced(kSquareText, "\n", "\n\n"), " ", "\t ")));
  expectSquare(readText<float>("\n  " + kSquareText));
  expectSquare(readText<float>("\xEF\xBB\xBF" + kSquareText));
  expectSquare(readText<float>(kSquareText.substr(0, kSquareText.size() - 1)));
  std::string upper = kSquareText;
  for (char& c : upper)
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  expectSquare(readText<float>(upper));
  const std::size_t body = kSquareText.find('\n') + 1;
  expectSquare(
      readText<float>(kSquareText.substr(0, body) + replaced(kSquareText.substr(body), "\n", " ")));
}

TEST(ReadStl, TextMayHaveSeveralSolidsAndNoNames) {
  expectSquare(readText<float>("solid\n" + facetText(kSquare[0]) + "endsolid\n\nsolid 2\n" +
                               facetText(kSquare[1]) + "endsolid 2\n"));
}

TEST(ReadStl, NormalsAreNotLookedAt) {
  expectSquare(readText<float>(replaced(kSquareText, "normal 0 0 1", "normal -nan(ind) 1.#R x")));
  std::string file = binaryFile(kSquare);
  file.replace(84, 4, bytesOf(std::numeric_limits<float>::quiet_NaN()));
  expectSquare(readText<float>(file));
}

TEST(ReadStl, LoopsOfOtherLengthsArePolygons) {
  const std::string text =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n"
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid\n";
  MeshReadReport report;
  const TriangleMesh<float> mesh = readText<float>(text, &report);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.sourceFaces, (std::vector<std::uint32_t>{1, 1}));
  ASSERT_EQ(report.skipped.size(), 1u);
  EXPECT_EQ(report.skipped[0].line, 2);
  EXPECT_EQ(report.skipped[0].reason, "has fewer than three corners");
}

TEST(ReadStl, WeldsTheTwoZerosAndNothingElse) {
  const float tiny = std::numeric_limits<float>::denorm_min();
  const std::vector<Corners> facets = {
      {Vec3f{0, 0, 1}, Vec3f{-0.0f, 0, 1}, Vec3f{0, -0.0f, 1}},
      {Vec3f{tiny, 0, 1}, Vec3f{-tiny, 0, 1}, Vec3f{0, 0, std::nextafter(1.0f, 2.0f)}}};
  const TriangleMesh<float> mesh = readText<float>(binaryFile(facets));
  EXPECT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 0, 0}, {1, 2, 3}}));
}

TEST(ReadStl, KeepsCornersThatAreNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const TriangleMesh<float> mesh =
      readText<float>(binaryFile({{Vec3f{nan, 0, 0}, Vec3f{nan, 0, 0}, Vec3f{infinity, 0, 0}}}));
  EXPECT_EQ(mesh.positions.size(), 2u);
  EXPECT_EQ(mesh.faces.size(), 1u);
}

TEST(ReadStl, WeldsAsManyVerticesAsThereArePositions) {
  constexpr std::uint32_t kSeed = 7;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  constexpr int kSide = 12;
  const auto corner = [&random] {
    const auto coordinate = [&random] { return static_cast<float>(random() % kSide) - 7.0f; };
    return Vec3f{coordinate(), coordinate(), coordinate()};
  };
  std::vector<Corners> facets(20000);
  for (Corners& facet : facets)
    facet = {corner(), corner(), corner()};
  const TriangleMesh<float> mesh = readText<float>(binaryFile(facets));
  EXPECT_EQ(mesh.positions.size(), static_cast<std::size_t>(kSide * kSide * kSide));
  ASSERT_EQ(mesh.faces.size(), facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    EXPECT_EQ(mesh.view().corners(i), facets[i]) << "facet " << i;
  }
}

TEST(ReadStl, DoubleKeepsTheDigitsOfText) {
  const std::string text = replaced(kSquareText, "0.500000", "0.1");
  EXPECT_EQ(readText<double>(text).positions[3].z, 0.1);
  EXPECT_EQ(readText<float>(text).positions[3].z, 0.1f);
}

TEST(ReadStl, NoFacetsAreAnEmptyMesh) {
  EXPECT_TRUE(readText<float>("solid\nendsolid\n").faces.empty());
  EXPECT_TRUE(readText<float>(binaryFile({})).faces.empty());
}

TEST(ReadStl, RefusesTextThatEnds) {
  expectMalformed("solid", 1, "the file ends before \"endsolid\"");
  expectMalformed("solid a\n" + facetText(kSquare[0]), 8, "the file ends before \"endsolid\"");
}

TEST(ReadStl, RefusesWordsOutOfPlace) {
  const std::string facet = facetText(kSquare[0]);
  const auto file = [](const std::string& body) { return "solid\n" + body + "endsolid\n"; };
  expectMalformed(file(replaced(facet, "outer", "inner")), 3,
                  "there is \"inner\" where \"outer\" belongs");
  expectMalformed(file(replaced(facet, "normal", "norma")), 2, "where \"normal\" belongs");
  expectMalformed(file(replaced(facet, "endloop", "endlop")), 7, "where \"vertex\" belongs");
  expectMalformed(file(replaced(facet, "endfacet", "facet")), 8, "where \"endfacet\" belongs");
  expectMalformed(file(facet + "color 1 0 0\n"), 9, "where \"facet\" belongs");
  expectMalformed(file("") + "solid\nendsolid\nfacet\n", 5, "where \"solid\" belongs");
  expectMalformed(file(replaced(facet, "vertex 1.000000", "vertex 1,5")), 5,
                  "with points, not commas");
  expectMalformed(file(replaced(facet, "vertex 1.000000", "vertex")), 6,
                  "\"vertex\" is not a number");
}

TEST(ReadStl, RefusesBinaryOfAnotherSize) {
  const std::string file = binaryFile(kSquare, "solid");
  const std::string shorter = file.substr(0, file.size() - 1);
  expectMalformed(shorter, Error::kNone,
                  "the header promises 2 triangles, which take 184 bytes, but the file has 183");
  expectMalformed(file + "x", Error::kNone, "but the file has 185");
  const std::string named = binaryFile(kSquare, "made by a program");
  const auto error = errorOf(named.substr(0, 150), "part.STL");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->code(), ErrorCode::MalformedFile);
  const auto tooShort = errorOf(std::string(50, '\0'), "part.stl");
  ASSERT_TRUE(tooShort);
  EXPECT_EQ(tooShort->code(), ErrorCode::MalformedFile);
  std::string lying = binaryFile(kSquare, "solid");
  lying.replace(80, 4, bytesOf(4000000000u));
  expectMalformed(lying, Error::kNone, "promises 4000000000 triangles");
}

}  // namespace
}  // namespace planetree::test
