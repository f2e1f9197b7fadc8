#include "ray_file.hpp"

#include <cmath>

namespace planetree::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Expects one ray, with these numbers.
void expectOneRay(const std::string& text, const std::vector<float>& numbers) {
  const std::vector<Rayf> rays = readRays<float>(text);
  ASSERT_EQ(rays.size(), 1u) << text;
  const Rayf& ray = rays.front();
  const std::array<float, 8> read = {ray.origin.x,    ray.origin.y,    ray.origin.z,
                                     ray.direction.x, ray.direction.y, ray.direction.z,
                                     ray.tMin,        ray.tMax};
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_TRUE(haveSameBits(read[i], numbers[i])) << text << "column " << i + 1 << ": " << read[i];
  }
}

TEST(CsvRayReader, SixColumnsAreOriginAndDirection) {
  expectOneRay("1,2,3,4,5,6\n", {1, 2, 3, 4, 5, 6, 0, kInfinity});
}

TEST(CsvRayReader, EightColumnsHaveTheIntervalToo) {
  expectOneRay("1,2,3,4,5,6,-7,8\n", {1, 2, 3, 4, 5, 6, -7, 8});
}

TEST(CsvRayReader, TakesAllSpellingsOfNumbers) {
  expectOneRay("+1,-2.5,.5,5.,1e3,-1E-2,-inf,INFINITY\n",
               {1, -2.5f, 0.5f, 5, 1000, -0.01f, -kInfinity, kInfinity});
  expectOneRay("-0,0,0,0,0,1\n", {-0.0f, 0, 0, 0, 0, 1, 0, kInfinity});
  EXPECT_TRUE(std::isnan(readRays<float>("nan,0,0,NaN,0,1\n").at(0).direction.x));
}

TEST(CsvRayReader, NumbersBeyondTheRangeBecomeInfinityOrZero) {
  expectOneRay("1e99,-1e99,1e-99,0,0,1\n", {kInfinity, -kInfinity, 0, 0, 0, 1, 0, kInfinity});
}

TEST(CsvRayReader, BlanksAroundNumbersDoNotCount) {
  expectOneRay("  1 ,\t2,3 , 4,5,   6  \n", {1, 2, 3, 4, 5, 6, 0, kInfinity});
}

TEST(CsvRayReader, NumbersMayStandInQuotationMarks) {
  expectOneRay("\"1\",\"2\", \"3\" ,4,\" 5\",6\n", {1, 2, 3, 4, 5, 6, 0, kInfinity});
}

TEST(CsvRayReader, LinesMayEndInAnyWay) {
  expectOneRay("1,2,3,4,5,6", {1, 2, 3, 4, 5, 6, 0, kInfinity});
  expectOneRay("1,2,3,4,5,6\r\n", {1, 2, 3, 4, 5, 6, 0, kInfinity});
  EXPECT_EQ(readRays<float>("1,2,3,4,5,6\r\n\r\n1,2,3,4,5,6").size(), 2u);
}

TEST(CsvRayReader, AFirstLineWithoutNumbersIsAHeader) {
  for (const char* header : {"ox,oy,oz,dx,dy,dz\n", "\"x\",y\r\n", "x y z\n", ",,,,,\n"}) {
    expectOneRay(header + std::string("1,2,3,4,5,6\n"), {1, 2, 3, 4, 5, 6, 0, kInfinity});
  }
  expectOneRay("\xEF\xBB\xBFox,oy\n1,2,3,4,5,6\n", {1, 2, 3, 4, 5, 6, 0, kInfinity});
}

TEST(CsvRayReader, ThereMayBeNoHeader) {
  expectOneRay(
      "\xEF\xBB\xBF"
      "1,2,3,4,5,6\n",
      {1, 2, 3, 4, 5, 6, 0, kInfinity});
}

TEST(CsvRayReader, CommentsAndBlankLinesAreSkippedAnywhere) {
  EXPECT_EQ(readRays<float>("# 1,2\n\nox,oy\n  # 3\n1,2,3,4,5,6\n\n#\n1,2,3,4,5,6\n# end").size(),
            2u);
}

TEST(CsvRayReader, FilesWithoutRaysHaveNone) {
  for (const char* text : {"ox,oy,oz,dx,dy,dz\n", "ox,oy,oz,dx,dy,dz", "# nothing\n", "\n", " "}) {
    EXPECT_TRUE(readRays<float>(text).empty()) << text;
  }
}

TEST(CsvRayReader, OnlyOneLineIsAHeader) {
  expectRefused("ox,oy,oz,dx,dy,dz\na,b,c,d,e,f\n", "column 1: \"a\" is not a number", 2);
}

TEST(CsvRayReader, WhatIsNotANumberIsNamedWithItsLineAndColumn) {
  expectRefused("1,2,3,4,5,6\n1,2,x3,4,5,6\n", "column 3: \"x3\" is not a number", 2);
  expectRefused("# c\n\nh\n1,2,3,4,5,6\n\n1,2,3,4,5,6e\n", "column 6: \"6e\"", 6);
  expectRefused("1,2,3,4,5,0x10\n", "column 6: \"0x10\"", 1);
  expectRefused("1,2,3,4,5,6 7\n", "column 6: \"6 7\"", 1);
  expectRefused("1,2,3,4,5,--6\n", "column 6: \"--6\"", 1);
  expectRefused("1,2,3,\"4,5,6\n", "column 4: \"\"4\"", 1);
  expectRefused(std::string("1,2,3,4,5,\0\n", 12), "column 6: \"?\"", 1);
}

TEST(CsvRayReader, EmptyColumnsAreNamed) {
  expectRefused("1,2,,4,5,6\n", "column 3 is empty", 1);
  expectRefused(",2,3,4,5,6\n", "column 1 is empty", 1);
  expectRefused("1,2,3,4,5, \n", "column 6 is empty", 1);
}

TEST(CsvRayReader, WrongNumbersOfColumnsAreNamed) {
  expectRefused("1,2,3,4,5\n", "has 5 columns instead of 6 or 8", 1);
  expectRefused("1,2,3,4,5,6,7\n", "has 7 columns instead of 6 or 8", 1);
  expectRefused("1,2,3,4,5,6,7,8,9\n", "has 9 columns instead of 6 or 8", 1);
  expectRefused("1,2,3,4,5,6,\n", "has 7 columns instead of 6 or 8", 1);
  expectRefused("1,2,3,4,5,6\n1,2,3,4,5,6,0,1\n", "has 8 columns instead of 6", 2);
  expectRefused("1,2,3,4,5,6,0,1\n1,2,3,4,5,6\n", "has 6 columns instead of 8", 2);
  expectRefused("1,2,3,4,5,6\n7\n1,2,3,4,5,6\n", "has 1 column instead of 6", 2);
}

TEST(CsvRayReader, OtherSeparatorsGetAdvice) {
  for (const char* text : {"1 2 3 4 5 6\n", "1;2;3;4;5;6\n", "h\n1\t2\t3\t4\t5\t6\n"}) {
    const auto error = errorOfRays(text);
    ASSERT_TRUE(error);
    EXPECT_NE(error->advice().find("commas"), std::string::npos) << error->what();
  }
}

TEST(CsvRayReader, AFileThatEndsWithinALineSaysSo) {
  expectRefused("1,2,3,4,5,6\n1,2,3", "The file ends there", 2);
  expectRefused("1,2,3,4,5,6\n1,2,3,4,5,", "The file ends there", 2);
  expectRefused("1,2", "The file ends there", 1);
}

TEST(CsvRayReader, LinesWithoutEndAreRefusedBeforeTheyFillTheMemory) {
  expectRefused(std::string(3 * tool::kBlockBytes, '1'), "is longer than", 1);
  expectRefused("h\n" + std::string(3 * tool::kBlockBytes, '#'), "is longer than", 2);
}

TEST(CsvRayReader, LinesAreCountedOverManyBlocks) {
  std::string text = "header\n";
  std::size_t count = 0;
  for (; text.size() < 5 * tool::kBlockBytes; ++count)
    text += std::to_string(count) + ",2,3,4,5,6\n";
  const std::vector<Rayf> rays = readRays<float>(text);
  ASSERT_EQ(rays.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_EQ(rays[i].origin.x, static_cast<float>(i));
  expectRefused(text + "1,2,3,4,5,?\n", "column 6", static_cast<std::int64_t>(count) + 2);
}

TEST(CsvRayReader, ReadsDoubleToTheLastBit) {
  const std::vector<Rayd> rays = readRays<double>("0.1,0.30000000000000004,1e-300,0,0,1\n");
  ASSERT_EQ(rays.size(), 1u);
  EXPECT_EQ(rays[0].origin.x, 0.1);
  EXPECT_EQ(rays[0].origin.y, 0.30000000000000004);
  EXPECT_EQ(rays[0].origin.z, 1e-300);
}

}  // namespace
}  // namespace planetree::test
