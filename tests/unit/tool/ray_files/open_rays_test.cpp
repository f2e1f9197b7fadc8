#include "ray_file.hpp"

namespace planetree::test {
namespace {

TEST(OpenRays, TellsTheFormatByTheFirstBytes) {
  const TemporaryFile csv("1,2,3,4,5,6\n");
  EXPECT_EQ(tool::openRays(csv.path())->format(), tool::TableFormat::Csv);
  EXPECT_FALSE(tool::openRays(csv.path())->isDouble());
  EXPECT_EQ(tool::openRays(csv.path())->rayCount(), std::nullopt);
  const TemporaryFile npy(npyFile(npyDictionary("<f4", "(0, 6)"), ""));
  EXPECT_EQ(tool::openRays(npy.path())->format(), tool::TableFormat::Npy);
}

TEST(OpenRays, ShortFilesAreText) {
  EXPECT_TRUE(readRays<float>("x").empty());
  EXPECT_TRUE(readRays<float>("\x93NUM").empty());
}

TEST(OpenRays, RefusesWhatIsNeitherTextNorNpy) {
  for (const std::string& bytes : {std::string("PK\3\4\x14\0", 6),
                                   std::string("\xFF\xFE"
                                               "1\0,\0",
                                               6),
                                   std::string(8, '\0')}) {
    const auto error = errorOfRays(bytes);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), ErrorCode::UnknownFormat) << error->what();
  }
}

TEST(OpenRays, RefusesEmptyFiles) {
  expectRefused("", "is empty");
}

TEST(OpenRays, NamesWhatCannotBeRead) {
  for (const char* path : {"/nowhere/rays.csv", "/"}) {
    try {
      static_cast<void>(tool::openRays(path));
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::FileNotReadable);
      EXPECT_EQ(error.file(), path);
      EXPECT_FALSE(error.advice().empty());
    }
  }
}

}  // namespace
}  // namespace planetree::test
