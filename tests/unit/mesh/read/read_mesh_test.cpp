#include "mesh_bytes.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace planetree::test {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// A folder of its own for each test, removed at its end.
class ReadMesh : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo& info = *testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / ("planetree_" + std::string(info.name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    const std::filesystem::path path = folder_ / name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

void expectError(const std::filesystem::path& path, ErrorCode code, const std::string& words) {
  try {
    static_cast<void>(readMesh<float>(path));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_EQ(error.code(), code) << message;
    EXPECT_EQ(error.file(), path.string());
    EXPECT_EQ(error.line(), Error::kNone);
    EXPECT_FALSE(error.advice().empty());
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }
}

TEST_F(ReadMesh, TellsFormatsByContentAndNotByName) {
  MeshReadReport report;
  EXPECT_EQ(readMesh<float>(write("a.ply", kTriangle), &report).faces.size(), 1u);
  EXPECT_EQ(report.format, MeshFormat::Obj);
  EXPECT_TRUE(readMesh<double>(write("a.obj", "solid\nendsolid\n"), &report).faces.empty());
  EXPECT_EQ(report.format, MeshFormat::Stl);
}

TEST_F(ReadMesh, ReadsFilesLargerThanItsFirstBuffer) {
  std::string text = kTriangle;
  while (text.size() < 300'000)
    text += "# padding\nf 1 2 3\n";
  EXPECT_GT(readMesh<float>(write("large", text)).faces.size(), 10'000u);
}

TEST_F(ReadMesh, RefusesWhatIsNoReadableFile) {
  expectError(folder() / "none.ply", ErrorCode::FileNotReadable, "there is no such file");
  expectError(write("file", "x") / "inside.ply", ErrorCode::FileNotReadable,
              "there is no such file");
  expectError(folder(), ErrorCode::FileNotReadable, "it is a folder");
  expectError("", ErrorCode::FileNotReadable, "there is no such file");
}

TEST_F(ReadMesh, RefusesFilesWithoutPermission) {
  const std::filesystem::path path = write("secret.obj", kTriangle);
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (std::ifstream(path).is_open())
    GTEST_SKIP() << "this user may read every file";
  expectError(path, ErrorCode::FileNotReadable, "no permission");
}

TEST_F(ReadMesh, RefusesUnknownFormats) {
  expectError(write("empty.ply", ""), ErrorCode::UnknownFormat, "the file is empty");
  expectError(write("blank.obj", " \n\n"), ErrorCode::UnknownFormat, "none of the formats");
  expectError(write("text.obj", "Dear all,\n"), ErrorCode::UnknownFormat, "none of the formats");
  expectError(write("plyx", "plyx\n"), ErrorCode::UnknownFormat, "none of the formats");
  expectError(write("image.png", std::string("\x89PNG\r\n\x1A\n\0\0", 10)),
              ErrorCode::UnknownFormat, "none of the formats");
  expectError(write("bunny.ply.gz", "\x1F\x8B\x08"), ErrorCode::UnknownFormat, "Unpack it first");
}

TEST_F(ReadMesh, NamesTheFileInErrorsOfItsContent) {
  const std::filesystem::path path = write("bad.obj", "v 0 0 0\nv x 0 0\n");
  try {
    static_cast<void>(readMesh<double>(path));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.file(), path.string());
    EXPECT_EQ(error.line(), 2);
  }
}

TEST_F(ReadMesh, LeavesTheReportAloneWhenItThrows) {
  MeshReadReport report;
  report.polygonCount = 42;
  EXPECT_THROW(static_cast<void>(readText<float>("v 1\n", &report)), Error);
  EXPECT_EQ(report.polygonCount, 42u);
}

class ReadScene : public testing::Test {
 protected:
  void SetUp() override {
    const char* const folder = std::getenv("PLANETREE_SCENES");
    if (!folder || *folder == 0)
      GTEST_SKIP() << "PLANETREE_SCENES does not name the folder of large meshes";
    folder_ = folder;
  }

  void expectCounts(const std::string& name, std::size_t vertexCount, std::size_t faceCount) {
    MeshReadReport report;
    const TriangleMesh<float> mesh = readMesh<float>(folder_ / name, &report);
    EXPECT_EQ(mesh.positions.size(), vertexCount);
    EXPECT_EQ(mesh.faces.size(), faceCount);
    EXPECT_EQ(report.polygonCount, faceCount);
    EXPECT_EQ(report.skippedPolygonCount, 0u);
    EXPECT_TRUE(mesh.sourceFaces.empty());
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(ReadScene, ReadsTheWholeBunny) {
  expectCounts("bunny.ply", 34'834, 69'451);
}

TEST_F(ReadScene, ReadsTheWholeDragon) {
  expectCounts("dragon.ply", 437'645, 871'414);
}

}  // namespace
}  // namespace planetree::test
