#include "mesh_bytes.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <string>

#include <gtest/gtest.h>

namespace planetree::test {
namespace {

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

/// A header whose body begins on line 10.
std::string header(const std::string& format, const std::string& vertexCount,
                   const std::string& faceCount, const std::string& countType = "uchar") {
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertexCount + "\n" + kXyz +
         "element face " + faceCount + "\nproperty list " + countType +
         " int vertex_indices\nend_header\n";
}

const std::string kThreeVertices = "0 0 0\n1 0 0\n0 1 0\n";

std::string binaryVertices(int count) {
  std::string bytes;
  for (int i = 0; i < 3 * count; ++i)
    bytes += bytesOf(static_cast<float>(i));
  return bytes;
}

TEST(ReadPlyErrors, MessageSaysWhatAndWhereAndWhatToDo) {
  const std::string file =
      header("binary_little_endian", "35947", "69451") + binaryVertices(1200) + "abc";
  const auto error = errorOf(file, "bunny.ply");
  ASSERT_TRUE(error);
  EXPECT_STREQ(error->what(),
               "bunny.ply: the header promises 35947 vertices, but the file ends within vertex "
               "1200. The file is truncated: copy it again");
}

TEST(ReadPlyErrors, RefusesCountsLargerThanTheFile) {
  const std::string little = "binary_little_endian";
  expectMalformed(header(little, "4000000000", "1") + binaryVertices(3), Error::kNone,
                  "promises 4000000000 vertices, but the file ends before vertex 3");
  expectMalformed(header(little, "9223372036854775806", "1") + binaryVertices(3), Error::kNone,
                  "ends before vertex 3");
  expectMalformed(header(little, "3", "4000000000") + binaryVertices(3), Error::kNone,
                  "promises 4000000000 faces, but the file ends within face 0");
  expectMalformed(header("ascii", "4000000000", "1") + kThreeVertices, 12,
                  "promises 4000000000 vertices, but the file ends before vertex 3");
  expectMalformed(header("ascii", "3", "9223372036854775806") + kThreeVertices + "3 0 1 2\n", 13,
                  "but the file ends before face 1");
}

TEST(ReadPlyErrors, RefusesCountsOfOtherElementsLargerThanTheFile) {
  for (const std::string format : {"binary_little_endian", "binary_big_endian"}) {
    const std::string start = "ply\nformat " + format + " 1.0\n";
    expectMalformed(start + "element edge 4000000000\nproperty int a\nelement vertex 0\n" + kXyz +
                        "end_header\nabcdefghij",
                    Error::kNone,
                    "4000000000 records of \"edge\", but the file ends within record 2");
    expectMalformed(start +
                        "element edge 4000000000\nproperty list uchar int a\nelement vertex 0\n" +
                        kXyz + "end_header\n" + std::string(10, '\0'),
                    Error::kNone, "but the file ends within record 10");
  }
}

TEST(ReadPlyErrors, RecordsWithoutPropertiesTakeNoTime) {
  const std::string file =
      "ply\nformat ascii 1.0\nelement nothing 9223372036854775806\n"
      "element vertex 0\n" +
      kXyz + "end_header\n";
  EXPECT_TRUE(readText<float>(file).faces.empty());
}

TEST(ReadPlyErrors, RefusesCountsThatAreNone) {
  for (const std::string count :
       {"-1", "abc", "1.5", "", "9223372036854775807", "1e9", "99999999999999999999999"}) {
    expectMalformed(header("ascii", count, "1") + kThreeVertices, 3, "is not a count");
  }
}

TEST(ReadPlyErrors, RefusesListsLongerThanTheFile) {
  const std::string start = header("binary_little_endian", "3", "1", "uint") + binaryVertices(3);
  expectMalformed(
      start + bytesOf(4000000000u) + bytesOf(0) + bytesOf(1), Error::kNone,
      "promises 1 face, but the file ends within face 0, in a list of 4000000000 values");
  expectMalformed(header("ascii", "3", "1", "uint") + kThreeVertices + "4000000000 0 1 2\n", 13,
                  "face 0 has a list of 4000000000 values, more than its line");
  expectMalformed(
      header("ascii", "3", "1", "uint") + kThreeVertices + "99999999999999999999 0 1 2\n", 13,
      "more than its line");
}

TEST(ReadPlyErrors, RefusesNegativeListCounts) {
  expectMalformed(header("binary_little_endian", "3", "1", "int") + binaryVertices(3) +
                      bytesOf(-3) + std::string(12, '\0'),
                  Error::kNone, "face 0 has a list of -3 values");
  expectMalformed(header("ascii", "3", "1", "int") + kThreeVertices + "-3 0 1 2\n", 13,
                  "face 0 has a list of -3 values");
}

TEST(ReadPlyErrors, RefusesValuesMissingOrLeftOverOnALine) {
  expectMalformed(header("ascii", "3", "1") + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n", 11,
                  "the line has too few values for vertex 1");
  expectMalformed(header("ascii", "3", "1") + "0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2\n", 11,
                  "\"7\" is one value too many for vertex 1");
  expectMalformed(header("ascii", "3", "1") + kThreeVertices + "3 0 1\n\n", 13,
                  "face 0 has a list of 3 values, more than its line");
  expectMalformed(header("ascii", "3", "1") + kThreeVertices + "3 0 1 2 0\n", 13,
                  "one value too many for face 0");
  expectMalformed(header("ascii", "3", "1") + "0 0 0\n1 0", 11, "ends within vertex 1");
}

TEST(ReadPlyErrors, RefusesContentBehindTheLastRecord) {
  expectMalformed(header("ascii", "3", "0") + kThreeVertices + "3 0 1 2\n", 13,
                  "the file goes on behind the last record");
  expectMalformed(header("binary_little_endian", "0", "0") + binaryVertices(2), Error::kNone,
                  "there are 24 bytes behind the last record");
}

TEST(ReadPlyErrors, RefusesWordsThatAreNoNumbers) {
  expectMalformed(header("ascii", "1", "0") + "1 abc 0\n", 10, "\"abc\" is not a number");
  expectMalformed(header("ascii", "1", "0") + "1 2 3x\n", 10, "\"3x\" is not a number");
  expectMalformed(header("ascii", "1", "0") + "1 +-2 3\n", 10, "\"+-2\" is not a number");
  expectMalformed(header("ascii", "1", "0") + "1 + 3\n", 10, "\"+\" is not a number");
  expectMalformed(header("ascii", "1", "0") + "1,5 2 3\n", 10, "with points, not commas");
  expectMalformed(header("ascii", "3", "1") + kThreeVertices + "3 0 1 2.5\n", 13,
                  "\"2.5\" is not a whole number");
  expectMalformed(header("ascii", "3", "1") + kThreeVertices + "x 0 1 2\n", 13,
                  "\"x\" is not a whole number");
  expectMalformed(header("ascii", "1", "0") + "1 \1\2" + std::string(100, 'a') + " 0\n", 10,
                  "\"??" + std::string(30, 'a') + "...\" is not a number");
}

TEST(ReadPlyErrors, RefusesHeadersThatEnd) {
  expectMalformed("ply", 1, "the file ends within its header");
  expectMalformed("ply\nformat ascii 1.0\nelement vertex 3\n", 3, "ends within its header");
}

TEST(ReadPlyErrors, RefusesHeadersThatAreWrong) {
  const auto expectHeaderError = [](const std::string& lines, std::int64_t line,
                                    const std::string& words) {
    expectMalformed("ply\n" + lines + "end_header\n", line, words);
  };
  const std::string format = "format ascii 1.0\n";
  expectMalformed("ply 2\nformat ascii 1.0\nend_header\n", 1, "one word too many");
  expectHeaderError("element vertex 0\n" + kXyz, 6, "no format line");
  expectHeaderError(format + format, 3, "two format lines");
  expectHeaderError("format utf8 1.0\n", 2, "the format \"utf8\" is unknown");
  expectHeaderError("format ascii 2.0\n", 2, "the version \"2.0\" is unknown");
  expectHeaderError(format + "elment vertex 3\n", 3, "unknown keyword \"elment\"");
  expectHeaderError(format + "property float x\n", 3, "a property before any element");
  expectHeaderError(format + "element vertex 1\nproperty half x\n", 4, "\"half\" is unknown");
  expectHeaderError(format + "element vertex 1\nproperty float\n", 4, "the property has no name");
  expectHeaderError(format + "element\n", 3, "the element has no name");
  expectHeaderError(format + "element vertex 1 1\n", 3, "one word too many");
  expectHeaderError(format + "element face 1\nproperty list float int vertex_indices\n", 4,
                    "a list has a count of type \"float\"");
}

TEST(ReadPlyErrors, RefusesElementsThatAreNoMesh) {
  const std::string start = "ply\nformat ascii 1.0\n";
  const std::string vertex = "element vertex 1\n";
  const std::string end = "end_header\n0 0 0\n";
  expectMalformed(start + end, 3, "no element vertex");
  expectMalformed(start + vertex + "property float x\nproperty float y\n" + end, 3,
                  "the vertices have no coordinate z");
  expectMalformed(start + vertex +
                      "property list uchar float x\nproperty float y\n"
                      "property float z\n" +
                      end,
                  3, "the vertices have no coordinate x");
  expectMalformed(start + vertex + kXyz + vertex + kXyz + end, 7, "a second element vertex");
  const std::string face = "element face 1\n";
  expectMalformed(start + "element vertex 0\n" + kXyz + face + face + end, 8,
                  "a second element face");
  for (const std::string property :
       {"", "property int vertex_indices\n", "property list uchar float vertex_indices\n"}) {
    expectMalformed(start + "element vertex 0\n" + kXyz + face + property + end, 7,
                    "the element face has no list of integers vertex_indices");
  }
}

}  // namespace
}  // namespace planetree::test
