#include "tool_run.hpp"

#include "support/read_png.hpp"

#include <cctype>

namespace planetree::test {
namespace {

using Render = ToolTest;

/// The arguments after "view: " that reproduce the picture.
std::string saidCamera(const std::string& err) {
  const std::string before = "--camera ";
  const std::size_t start = err.find(before) + before.size();
  return err.substr(start, err.find_first_of(" \n", start) - start);
}

TEST_F(Render, WithoutAModelMakesAPictureOfTheStillLife) {
  const ToolResult result = runSmall({});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"render.png"});
  EXPECT_TRUE(isPng(readFile("render.png"), 24, 16));
}

TEST_F(Render, NamesThePictureAfterTheModelAndPutsItHere) {
  std::filesystem::create_directory(folder() / "models");
  writeModel("models/roof.v2.obj");
  EXPECT_EQ(runSmall({"models/roof.v2.obj"}).status, 0);
  EXPECT_TRUE(isPng(readFile("roof.v2.png"), 24, 16));
}

TEST_F(Render, SaysWhatItDidOnStandardError) {
  writeModel("roof.obj");
  const ToolResult result = runSmall({"roof.obj"});
  EXPECT_EQ(result.out, "");
  for (const char* said :
       {"roof.obj: 2 triangles", "OBJ", "tree of 2 triangles", "built in", "split nodes", "leaf",
        "empty", "depth", "references per object", "SAH cost", "bytes", "--camera", "rays in",
        "million rays per second", "wrote roof.png (24 x 16"}) {
    EXPECT_NE(result.err.find(said), std::string::npos) << said << "\n" << result.err;
  }
}

TEST_F(Render, QuietSaysNothing) {
  for (const char* option : {"-q", "--quiet"}) {
    const ToolResult result = runSmall({option});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
  }
}

TEST_F(Render, QuietDoesNotHideErrors) {
  const ToolResult result = runSmall({"-q", "missing.obj"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("missing.obj"), std::string::npos);
}

TEST_F(Render, ShowsNoProgressUnlessStandardErrorIsATerminal) {
  EXPECT_EQ(runSmall({}).err.find('\r'), std::string::npos);
}

TEST_F(Render, DashWritesThePictureToStandardOutput) {
  const ToolResult result = runSmall({"-o", "-"});
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(isPng(result.out, 24, 16));
  EXPECT_NE(result.err.find("wrote standard output"), std::string::npos);
  EXPECT_TRUE(filesInFolder().empty());

  EXPECT_EQ(runSmall({"-o", "same.png"}).status, 0);
  EXPECT_EQ(readFile("same.png"), result.out);
}

TEST_F(Render, MakesEveryModeADifferentPicture) {
  std::vector<std::string> pictures;
  for (const char* mode : {"ao", "normals", "depth", "heat"}) {
    const ToolResult result = runSmall({"--mode", mode, "-o", "-"});
    ASSERT_EQ(result.status, 0) << mode << result.err;
    EXPECT_TRUE(readPng(result.out)) << mode;
    for (const std::string& other : pictures)
      EXPECT_NE(result.out, other) << mode;
    pictures.push_back(result.out);
  }
}

TEST_F(Render, AmbientOcclusionIsTheDefaultMode) {
  EXPECT_EQ(runSmall({"-o", "-"}).out, runSmall({"--mode", "ao", "-o", "-"}).out);
}

TEST_F(Render, HeatAndDepthSayWhatTheirColoursMean) {
  EXPECT_NE(runSmall({"--mode", "heat"}).err.find("heat: black is 0, pale yellow "),
            std::string::npos);
  EXPECT_NE(runSmall({"--mode", "depth"}).err.find("depth: white is "), std::string::npos);
}

TEST_F(Render, IsTheSameForAnyNumberOfThreads) {
  for (const char* mode : {"ao", "heat"}) {
    const auto picture = [&](const char* threads) {
      return run({"render", "--size", "64x48", "--samples", "3", "--mode", mode, "--threads",
                  threads, "-o", "-", "-q"})
          .out;
    };
    const std::string one = picture("1");
    EXPECT_TRUE(readPng(one));
    EXPECT_EQ(picture("2"), one) << mode;
    EXPECT_EQ(picture("7"), one) << mode;
  }
}

TEST_F(Render, IsTheSameEveryTimeButForTheSeed) {
  const std::string first = runSmall({"-o", "-"}).out;
  EXPECT_EQ(runSmall({"-o", "-"}).out, first);
  EXPECT_EQ(runSmall({"-o", "-", "--seed", "0"}).out, first);
  EXPECT_NE(runSmall({"-o", "-", "--seed", "1"}).out, first);
  EXPECT_EQ(runSmall({"-o", "-", "--seed", "18446744073709551615"}).status, 0);
}

TEST_F(Render, SamplesChangeThePicture) {
  EXPECT_NE(run({"render", "-q", "--size", "24x16", "--samples", "4", "-o", "-"}).out,
            run({"render", "-q", "--size", "24x16", "--samples", "2", "-o", "-"}).out);
}

TEST_F(Render, TheTreeDoesNotChangeThePicture) {
  const auto pixels = [this](const std::vector<std::string>& arguments) {
    return readPng(runSmall(arguments).out)->image.pixels;
  };
  const auto usual = pixels({"-o", "-"});
  EXPECT_EQ(pixels({"--preset", "balanced", "-o", "-"}), usual);
  EXPECT_EQ(pixels({"--leaf-size", "20", "-o", "-"}), usual);
  EXPECT_EQ(pixels({"--depth-limit", "12", "-o", "-"}), usual);
  // The textbook's rules may give up early; a small model keeps that affordable.
  writeModel("roof.obj");
  EXPECT_EQ(pixels({"roof.obj", "--preset", "textbook", "-o", "-"}),
            pixels({"roof.obj", "-o", "-"}));
}

TEST_F(Render, BuildOptionsReachTheTree) {
  EXPECT_NE(runSmall({"--depth-limit", "1"}).err.find("  0 split nodes, 1 leaf "),
            std::string::npos);
  EXPECT_NE(runSmall({"--leaf-size", "4294967295"}).err.find("  0 split nodes, 1 leaf "),
            std::string::npos);
  EXPECT_NE(runSmall({"--depth-limit", "3"}).err.find("depth 3\n"), std::string::npos);
}

TEST_F(Render, TheSaidCameraReproducesThePicture) {
  writeModel("roof.obj");
  for (const char* up : {"y", "z"}) {
    const ToolResult framed = runSmall({"roof.obj", "--up", up, "-o", "-"});
    ASSERT_EQ(framed.status, 0);
    const std::string camera = saidCamera(framed.err);
    EXPECT_EQ(runSmall({"roof.obj", "--up", up, "--camera", camera, "-o", "-"}).out, framed.out)
        << camera;
  }
}

TEST_F(Render, TakesCamerasThatStartWithAMinusOrAPoint) {
  const std::string picture =
      runSmall({"--camera", "-.5,2,-9,0,1,0", "--fov", "30", "-o", "-"}).out;
  EXPECT_TRUE(isPng(picture, 24, 16));
  EXPECT_EQ(runSmall({"--camera", "-0.5, 2, -9, 0, 1, 0, 30", "-o", "-"}).out, picture);
  EXPECT_EQ(runSmall({"--camera=-.5,2,-9,0,1,0,30", "-o", "-"}).out, picture);
}

TEST_F(Render, TakesCamerasThatLookStraightUpOrDown) {
  for (const char* camera : {"0,9,0,0,0,0", "0,-9,0,0,0,0"}) {
    EXPECT_TRUE(isPng(runSmall({"--camera", camera, "-o", "-"}).out, 24, 16)) << camera;
  }
}

TEST_F(Render, FovAndUpChangeTheView) {
  writeModel("roof.obj");
  const std::string usual = runSmall({"roof.obj", "-o", "-"}).out;
  EXPECT_NE(runSmall({"roof.obj", "--fov", "90", "-o", "-"}).out, usual);
  EXPECT_NE(runSmall({"roof.obj", "--up", "z", "-o", "-"}).out, usual);
  EXPECT_EQ(runSmall({"roof.obj", "--fov", "40", "--up", "y", "-o", "-"}).out, usual);
}

TEST_F(Render, TakesPicturesOfOnePixelAndOfOneRow) {
  for (const auto& [size, width, height] :
       {std::tuple{"1x1", 1u, 1u}, {"50x1", 50u, 1u}, {"1x50", 1u, 50u}, {"017x009", 17u, 9u}}) {
    const ToolResult result = runSmall({"--size", size, "-o", "-"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(isPng(result.out, width, height)) << size;
  }
}

}  // namespace
}  // namespace planetree::test
