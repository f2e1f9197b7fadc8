#include "tool_run.hpp"

#include <unistd.h>

namespace planetree::test {
namespace {

namespace fs = std::filesystem;

using Failure = ToolTest;

/// A failure is status 1 and one line that names the culprit; nothing appears on standard output.
void expectFailure(const ToolResult& result, const std::string& named) {
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  const std::size_t lastLine = result.err.rfind('\n', result.err.size() - 2) + 1;
  const std::string line = result.err.substr(lastLine);
  EXPECT_EQ(line.rfind("planetree: ", 0), 0u) << result.err;
  EXPECT_NE(line.find(named), std::string::npos) << result.err;
}

TEST_F(Failure, MissingModelsAreNamed) {
  expectFailure(runSmall({"missing.obj"}), "missing.obj: ");
  EXPECT_TRUE(filesInFolder().empty());
}

TEST_F(Failure, FoldersAreNoModels) {
  expectFailure(runSmall({"."}), ".: ");
}

TEST_F(Failure, FilesOfNoKnownFormatAreNamed) {
  writeFile("notes.txt", "no model at all\n");
  expectFailure(runSmall({"notes.txt"}), "notes.txt: ");
  writeFile("empty.obj", "");
  expectFailure(runSmall({"empty.obj"}), "empty.obj");
}

TEST_F(Failure, BrokenModelsAreNamedWithTheirLine) {
  writeFile("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 one 0\nf 1 2 3\n");
  expectFailure(runSmall({"broken.obj"}), "broken.obj:3: ");
}

TEST_F(Failure, ModelsWithoutTrianglesSaySo) {
  writeFile("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  expectFailure(runSmall({"points.obj"}), "points.obj: has no triangles");
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"points.obj"});
}

TEST_F(Failure, ModelsOfWhichNothingCanBeHitSayWhy) {
  writeFile("flat.obj", "v 0 0 0\nv 1 0 0\nf 1 1 2\nf 2 2 2\n");
  expectFailure(runSmall({"flat.obj"}), "has 2 triangles, none of which can be hit");
}

TEST_F(Failure, TreesThatNeedMoreThanTheMemoryLimitAreNotBuilt) {
  writeModel("model.obj");
  writeFile("rays.csv", "0.2,0.2,1,0,0,-1\n");
  const std::vector<std::string> before = filesInFolder();
  const std::string problem = "planetree: the build needs more than ";
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"render"},
        {"render", "model.obj"},
        {"info", "model.obj"},
        {"trace", "model.obj", "rays.csv"},
        {"trace", "model.obj", "rays.csv", "--double"},
        {"explain", "model.obj", "--ray", "0,0,1,0,0,-1"}}) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {"--memory-limit", "100"});
    expectFailure(run(arguments), problem);
    arguments.back() = "100MB";
    if (command.front() != "render") {
      EXPECT_EQ(run(arguments).status, 0) << command.front();
    }
  }
  EXPECT_EQ(filesInFolder(), before);
}

TEST_F(Failure, SkippedTrianglesAreCountedAndTheFirstOnesNamed) {
  writeFile("half.obj",
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv nan 0 0\n"
            "f 1 2 3\nf 1 2 2\nf 1 2 4\nf 1 2 9\nf 3 2 1\n");
  const ToolResult result = runSmall({"half.obj"});
  if (result.status == 0) {
    EXPECT_NE(result.err.find("skipped"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("face 1 has two corners at one point"), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("tree of 2 triangles"), std::string::npos) << result.err;
  } else {
    // A reader may refuse text that is no number, but must then say where.
    expectFailure(result, "half.obj:4: ");
  }
}

TEST_F(Failure, FoldersThatDoNotExistAreNamedBeforeAnythingIsRead) {
  const ToolResult result = runSmall({"-o", "missing/picture.png"});
  expectFailure(result, "missing/picture.png: cannot be written");
  EXPECT_EQ(result.err.find("tree of"), std::string::npos) << "it worked in vain";
}

TEST_F(Failure, AFolderIsNoPicture) {
  fs::create_directory(folder() / "pictures");
  expectFailure(runSmall({"-o", "pictures"}), "pictures: cannot be written");
  expectFailure(runSmall({"-o", "pictures/"}), "pictures/: cannot be written");
}

TEST_F(Failure, AFileIsNoFolder) {
  writeFile("file", "text");
  expectFailure(runSmall({"-o", "file/picture.png"}), "file/picture.png: cannot be written");
}

TEST_F(Failure, FoldersWithoutPermissionAreNamed) {
  if (::geteuid() == 0)
    GTEST_SKIP() << "root may write everywhere";
  fs::create_directory(folder() / "locked");
  fs::permissions(folder() / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  expectFailure(runSmall({"-o", "locked/picture.png"}), "locked/picture.png: cannot be written");
}

TEST_F(Failure, AFullDiskLeavesTheOldPictureAndNothingElse) {
  writeFile("picture.png", "the old picture");
  const ToolResult result = run(ToolStart{
      .arguments = {"render", "-q", "--size", "64x64", "--samples", "1", "-o", "picture.png"},
      .largestFile = 1000});
  expectFailure(result, "picture.png: cannot be written");
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"picture.png"});
  EXPECT_EQ(readFile("picture.png"), "the old picture");
}

TEST_F(Failure, AFullDeviceIsReportedAndStaysADevice) {
  if (!fs::exists("/dev/full"))
    GTEST_SKIP() << "there is no /dev/full";
  expectFailure(runSmall({"-q", "-o", "/dev/full"}), "/dev/full: cannot be written");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Failure, AFullStandardOutputIsReported) {
  if (!fs::exists("/dev/full"))
    GTEST_SKIP() << "there is no /dev/full";
  const ToolResult result =
      run(ToolStart{.arguments = {"render", "-q", "--size", "8x8", "--samples", "1", "-o", "-"},
                    .standardOutput = "/dev/full"});
  expectFailure(result, "standard output: cannot be written");
}

TEST_F(Failure, AFullStandardErrorIsNoFailure) {
  if (!fs::exists("/dev/full"))
    GTEST_SKIP() << "there is no /dev/full";
  writeModel("roof.obj");
  const std::vector<std::string> arguments = {"render", "--size", "8x8", "roof.obj"};
  EXPECT_EQ(run(ToolStart{.arguments = arguments, .standardError = "/dev/full"}).status, 0);
  EXPECT_TRUE(isPng(readFile("roof.png"), 8, 8));
  EXPECT_EQ(run(ToolStart{.arguments = {"rendr"}, .standardError = "/dev/full"}).status, 2);
}

using Output = ToolTest;

TEST_F(Output, ReplacesAnOlderPicture) {
  writeFile("picture.png", "the old picture");
  EXPECT_EQ(runSmall({"-o", "picture.png"}).status, 0);
  EXPECT_TRUE(isPng(readFile("picture.png"), 24, 16));
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"picture.png"});
}

TEST_F(Output, FollowsASymbolicLink) {
  fs::create_directory(folder() / "real");
  fs::create_symlink("real/picture.png", folder() / "link.png");
  EXPECT_EQ(runSmall({"-o", "link.png"}).status, 0);
  EXPECT_TRUE(fs::is_symlink(folder() / "link.png"));
  EXPECT_TRUE(isPng(readFile("real/picture.png"), 24, 16));
}

TEST_F(Output, MayHaveNoExtensionOrAnUpperCaseOne) {
  EXPECT_EQ(runSmall({"-o", "picture"}).status, 0);
  EXPECT_EQ(runSmall({"-o", "picture.PNG"}).status, 0);
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"picture", "picture.PNG"}));
}

TEST_F(Output, MayBeANullDevice) {
  EXPECT_EQ(runSmall({"-o", "/dev/null"}).status, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace planetree::test
