#include "ray_file.hpp"

#include <cmath>

namespace planetree::test {
namespace {

const std::vector<float> kTwoRays = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

TEST(NpyRayReader, ReadsBothPrecisionsBothWidthsAndBothByteOrders) {
  const std::vector<double> row = {0.1, -2, 3, 4, 5, 6, -7, 8};
  for (const std::size_t columnCount : {6u, 8u}) {
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      const std::vector<double> doubles(row.begin(),
                                        row.begin() + static_cast<std::ptrdiff_t>(columnCount));
      const std::vector<float> floats(doubles.begin(), doubles.end());
      const std::string sign = order == std::endian::little ? "<" : ">";
      const std::string shape = columnCount == 6 ? "(1, 6)" : "(1, 8)";
      const auto rays =
          readRays<float>(npyFile(npyDictionary(sign + "f4", shape), bytesOf(floats, order)));
      const auto precise =
          readRays<double>(npyFile(npyDictionary(sign + "f8", shape), bytesOf(doubles, order)));
      ASSERT_EQ(rays.size(), 1u);
      ASSERT_EQ(precise.size(), 1u);
      EXPECT_EQ(rays[0].origin, (Vec3f{0.1f, -2, 3}));
      EXPECT_EQ(precise[0].origin, (Vec3d{0.1, -2, 3}));
      EXPECT_EQ(precise[0].direction, (Vec3d{4, 5, 6}));
      EXPECT_EQ(precise[0].tMin, columnCount == 8 ? -7.0 : 0.0);
      EXPECT_EQ(rays[0].tMax, columnCount == 8 ? 8.0f : std::numeric_limits<float>::infinity());
    }
  }
}

TEST(NpyRayReader, KeepsEveryBit) {
  const float nan = std::bit_cast<float>(0x7FC1'2345u);
  const std::vector<float> numbers = {nan, -0.0f, 1e-45f, std::numeric_limits<float>::infinity(),
                                      0,   0,     -1,     3};
  const auto rays = readRays<float>(npyFile(npyDictionary("<f4", "(1, 8)"), bytesOf(numbers)));
  ASSERT_EQ(rays.size(), 1u);
  EXPECT_TRUE(haveSameBits(rays[0].origin.x, nan));
  EXPECT_TRUE(haveSameBits(rays[0].origin.y, -0.0f));
  EXPECT_TRUE(haveSameBits(rays[0].origin.z, 1e-45f));
}

TEST(NpyRayReader, FloatsAreWidenedForDouble) {
  const auto rays = readRays<double>(npyFile(npyDictionary("<f4", "(2, 6)"), bytesOf(kTwoRays)));
  ASSERT_EQ(rays.size(), 2u);
  EXPECT_EQ(rays[1].direction, (Vec3d{10, 11, 12}));
}

TEST(NpyRayReader, TellsPrecisionAndCount) {
  const TemporaryFile file(npyFile(npyDictionary("<f8", "(0, 6)"), ""));
  const auto reader = tool::openRays(file.path());
  EXPECT_EQ(reader->format(), tool::TableFormat::Npy);
  EXPECT_TRUE(reader->isDouble());
  EXPECT_EQ(reader->rayCount(), 0u);
  tool::RayBlock block;
  EXPECT_FALSE(reader->next(block, [] { return true; }));
}

TEST(NpyRayReader, ReadsManyBlocksInOrder) {
  const std::size_t count = 3 * tool::kBlockBytes / 24 + 1;
  std::vector<float> numbers;
  for (std::size_t i = 0; i < count; ++i)
    numbers.insert(numbers.end(), {static_cast<float>(i), 0, 0, 0, 0, 1});
  std::string shape = "(";
  shape.append(std::to_string(count)).append(", 6)");
  const auto rays = readRays<float>(npyFile(npyDictionary("<f4", shape), bytesOf(numbers)));
  ASSERT_EQ(rays.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_EQ(rays[i].origin.x, static_cast<float>(i));
}

TEST(NpyRayReader, ReadsHeadersOfVersionsTwoAndThree) {
  std::string dictionary = npyDictionary("<f4", "(2, 6)");
  for (const char version : {'\2', '\3'}) {
    std::string bytes = "\x93NUMPY";
    bytes += version;
    bytes += '\0';
    bytes += static_cast<char>(dictionary.size());
    bytes += std::string(3, '\0');
    EXPECT_EQ(readRays<float>(bytes + dictionary + bytesOf(kTwoRays)).size(), 2u);
  }
}

TEST(NpyRayReader, ReadsWhateverPythonCallsTheSameDictionary) {
  for (const char* dictionary :
       {"{'shape':(2,6),'fortran_order':False,'descr':'<f4'}",
        "{\"descr\": \"<f4\", \"shape\": (2L, 6L), \"fortran_order\": False, }   \n",
        " { 'descr' : '<f4' , 'fortran_order' : False , 'shape' : ( 2 , 6 , ) } \n"}) {
    EXPECT_EQ(readRays<float>(npyFile(dictionary, bytesOf(kTwoRays))).size(), 2u) << dictionary;
  }
}

TEST(NpyRayReader, RefusesDictionariesThatAreNone) {
  for (const char* dictionary :
       {"", "{", "{}", "}", "{'descr': '<f4'}", "{'descr': '<f4', 'fortran_order': False}",
        "{'descr': '<f4', 'fortran_order': Maybe, 'shape': (2, 6)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 6}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (-2, 6)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (2.0, 6)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (99999999999999999999, 6)}",
        "{'descr': '<f4', 'descr': '<f4', 'fortran_order': False, 'shape': (2, 6)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 6), 'more': 1}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 6)} x",
        "{'descr: <f4, 'fortran_order': False, 'shape': (2, 6)}", "{'descr': [[['",
        "{'descr': '"}) {
    expectRefused(npyFile(dictionary, bytesOf(kTwoRays)), "not that of an array");
  }
}

TEST(NpyRayReader, RefusesOtherTypesWithAWayToConvertThem) {
  for (const char* type : {"<f2", "<f16", "<i4", "<i8", "|b1", "<c8", "|O", "|S4", "f4"}) {
    expectRefused(npyFile(npyDictionary(type, "(2, 6)"), bytesOf(kTwoRays)), "astype");
  }
  expectRefused(npyFile("{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (2,)}", ""),
                "structured_to_unstructured");
}

TEST(NpyRayReader, RefusesOtherShapes) {
  for (const char* shape :
       {"(2, 7)", "(12,)", "(6,)", "()", "(0,)", "(2, 0)", "(2, 6, 1)", "(6, 2)"}) {
    expectRefused(npyFile(npyDictionary("<f4", shape), bytesOf(kTwoRays)), "has the shape (");
  }
}

TEST(NpyRayReader, RefusesFortranOrderWithAWayToConvertIt) {
  expectRefused(npyFile(npyDictionary("<f4", "(2, 6)", "True"), bytesOf(kTwoRays)),
                "ascontiguousarray");
  const std::vector<float> row(kTwoRays.begin(), kTwoRays.begin() + 6);
  EXPECT_EQ(readRays<float>(npyFile(npyDictionary("<f4", "(1, 6)", "True"), bytesOf(row))).size(),
            1u)
      << "one row has no order";
}

TEST(NpyRayReader, RefusesUnknownVersions) {
  for (const char version : {'\0', '\4', '\xFF'}) {
    expectRefused(std::string("\x93NUMPY") + version + std::string("\0\x10\0", 3), "version");
  }
}

TEST(NpyRayReader, RefusesFilesThatEndWithinTheHeader) {
  const std::string whole = npyFile(npyDictionary("<f4", "(0, 6)"), "");
  for (std::size_t size = 6; size < whole.size(); ++size)
    expectRefused(whole.substr(0, size), "ends within its header");
}

TEST(NpyRayReader, RefusesHugeHeadersWithoutReadingThem) {
  expectRefused(std::string("\x93NUMPY\x02\0\xFF\xFF\xFF\xFF", 12), "header of 4294967295 bytes");
}

TEST(NpyRayReader, RefusesTruncatedFilesBeforeAnyWork) {
  const std::string whole = npyFile(npyDictionary("<f4", "(2, 6)"), bytesOf(kTwoRays));
  for (std::size_t missing = 1; missing <= 48; ++missing) {
    const TemporaryFile file(whole.substr(0, whole.size() - missing));
    try {
      static_cast<void>(tool::openRays(file.path()));
      ADD_FAILURE() << missing;
    } catch (const Error& error) {
      const std::string present = missing <= 24 ? "ends after 1 of the 2 rays" : "after 0 of the 2";
      EXPECT_NE(std::string(error.what()).find(present), std::string::npos) << error.what();
    }
  }
}

TEST(NpyRayReader, RefusesLyingCountsWithoutAllocatingThem) {
  for (const char* shape : {"(1000000000000, 6)", "(18446744073709551615, 8)"}) {
    expectRefused(npyFile(npyDictionary("<f4", shape), bytesOf(kTwoRays)), "ends after");
  }
}

TEST(NpyRayReader, RefusesBytesBeyondTheLastRay) {
  expectRefused(npyFile(npyDictionary("<f4", "(1, 6)"), bytesOf(kTwoRays)), "goes on after the 1 ");
  expectRefused(npyFile(npyDictionary("<f4", "(0, 6)"), "x"), "goes on after the 0 ");
}

}  // namespace
}  // namespace planetree::test
