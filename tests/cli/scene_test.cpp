#include "tool_run.hpp"

#include "support/read_exr.hpp"
#include "support/read_png.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

/// `planetree render` with files that have materials and lights.
namespace planetree::test {
namespace {

constexpr const char* kScene = R"(SBT-raytracer 1.0
camera { position = (0, 0, 6); viewdir = (0, 0, -1); updir = (0, 1, 0); fov = 40; aspectratio = 2; }
point_light { position = (3, 5, 6); color = (1, 1, 1); constant_attenuation_coeff = 1;
              quadratic_attenuation_coeff = 0; }
ambient_light { color = (0.2, 0.2, 0.2) }
translate(-1, 0, 0, sphere { material = { diffuse = (0.8, 0.2, 0.1); reflective = (0.4, 0.4, 0.4) } })
translate(1.2, 0, 0, sphere { material = { transmissive = (0.8, 0.9, 0.8); index = 1.4; } })
translate(0, 0, -3, scale(20, 20, 1, square { material = { diffuse = (0.7, 0.7, 0.8) } }))
)";

class SceneFile : public ToolTest {
 protected:
  SceneFile() { writeFile("balls.ray", kScene); }

  /// A picture of the scene, on standard output.
  [[nodiscard]] std::string bytes(std::vector<std::string> arguments) const {
    std::vector<std::string> all = {"render", "balls.ray", "-q", "-o", "-"};
    if (std::find(arguments.begin(), arguments.end(), "--size") == arguments.end())
      all.insert(all.end(), {"--size", "40"});
    all.insert(all.end(), arguments.begin(), arguments.end());
    const ToolResult result = run(all);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.out;
  }
  [[nodiscard]] PngFile png(std::vector<std::string> arguments) const {
    auto file = readPng(bytes(std::move(arguments)));
    EXPECT_TRUE(file);
    return file.value_or(PngFile{.image = render::Image({1, 1}), .texts = {}});
  }
  [[nodiscard]] nlohmann::json summary(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", "--json", "-q"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return nlohmann::json::parse(result.out, nullptr, false);
  }
};

TEST_F(SceneFile, IsShadedWithItsLightsByItsCameraInItsShape) {
  const nlohmann::json json = summary({"balls.ray", "--size", "40"});
  EXPECT_EQ(json["mode"], "whitted");
  EXPECT_EQ(json["width"], 40);
  EXPECT_EQ(json["height"], 20) << "the view is twice as wide as high";
  EXPECT_EQ(json["camera"]["eye"], (nlohmann::json{0.0, 0.0, 6.0}));
  EXPECT_EQ(json["scene"]["shape_count"], 3);
  EXPECT_EQ(json["scene"]["point_light_count"], 1);
  EXPECT_EQ(json["mesh"], nullptr);
  EXPECT_EQ(json["samples"], 16);
  EXPECT_EQ(json["is_complete"], true);
  EXPECT_EQ(json["done"], 1.0);
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"balls.png", "balls.ray"}));
}

TEST_F(SceneFile, WithoutLightsHasAmbientOcclusion) {
  writeFile("dark.ray", "SBT-raytracer 1.0 translate(0, 0, -4, sphere {})");
  EXPECT_EQ(summary({"dark.ray", "--size", "8"})["mode"], "ao");
}

TEST_F(SceneFile, ThatShinesByItselfNeedsNoLights) {
  const std::string begin = "SBT-raytracer 1.0 translate(0, 0, -4, sphere { material = { ";
  writeFile("lamp.ray", begin + "emissive = (1, 0, 0) } })");
  EXPECT_EQ(summary({"lamp.ray", "--size", "8"})["mode"], "whitted");
  writeFile("sky.json", R"({"background": [0, 0, 1], "shapes": [{"type": "sphere"}]})");
  EXPECT_EQ(summary({"sky.json", "--size", "8"})["mode"], "whitted");
}

TEST_F(SceneFile, IsKnownByItsFirstWordsToo) {
  writeFile("balls.txt", kScene);
  EXPECT_EQ(summary({"balls.txt", "--size", "8"})["mode"], "whitted");
}

TEST_F(SceneFile, BeyondTheRangeOfCoordinatesSaysSo) {
  writeFile("huge.ray", "SBT-raytracer 1.0 scale(1e20, sphere {})");
  const ToolResult result = run({"render", "huge.ray", "--size", "8"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("the scene is more than 2^30 across: hits may be lost"),
            std::string::npos)
      << result.err;
}

TEST_F(SceneFile, SeenFromBehindItMayBeLeftOut) {
  writeFile("inside.ray",
            "SBT-raytracer 1.0 ambient_light { color = (1, 1, 1) } scale(9, sphere { material = { "
            "ambient = (1, 0, 0) } })");
  const auto pixel = [this](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "inside.ray", "-q", "--size", "4", "-o", "-"});
    const auto picture = readPng(run(options).out);
    return picture ? picture->image.at(1, 1) : render::Rgb8{1, 2, 3};
  };
  EXPECT_EQ(pixel({}), (render::Rgb8{255, 0, 0}));
  EXPECT_EQ(pixel({"--culls-back-faces"}), (render::Rgb8{0, 0, 0}));
}

TEST_F(SceneFile, SaysWhatItHas) {
  const ToolResult result = run({"render", "balls.ray", "--size", "8"});
  EXPECT_EQ(result.out, "");
  for (const char* said : {"balls.ray: 3 shapes, ", "materials, 0 textures, 1 light (read in ",
                           "view: the camera of the scene\n", "wrote balls.png (8 x 4, "}) {
    EXPECT_NE(result.err.find(said), std::string::npos) << said << '\n' << result.err;
  }
}

TEST_F(SceneFile, GivesADifferentPictureInEveryMode) {
  std::vector<std::string> pictures;
  for (const char* mode : {"whitted", "ao", "normals", "depth", "albedo", "heat"}) {
    pictures.push_back(bytes({"--mode", mode}));
    EXPECT_TRUE(readPng(pictures.back())) << mode;
    EXPECT_EQ(std::count(pictures.begin(), pictures.end(), pictures.back()), 1) << mode;
  }
}

TEST_F(SceneFile, GivesTheSamePictureForAnyNumberOfThreads) {
  const std::string one = bytes({"--threads", "1"});
  EXPECT_EQ(bytes({"--threads", "2"}), one);
  EXPECT_EQ(bytes({"--threads", "5"}), one);
}

TEST_F(SceneFile, OptionsOfShadingChangeThePicture) {
  const auto usual = png({}).image.pixels;
  EXPECT_NE(png({"--no-shadows"}).image.pixels, usual);
  EXPECT_NE(png({"--ray-depth", "0"}).image.pixels, usual);
  EXPECT_NE(png({"--supersampling", "1"}).image.pixels, usual);
  EXPECT_NE(png({"--threshold", "0"}).image.pixels, usual);
  EXPECT_EQ(png({"--ray-depth", "5", "--supersampling", "4", "--threshold", "0.05"}).image.pixels,
            usual);
}

TEST_F(SceneFile, BackgroundIsSeenBehindEverything) {
  writeFile("ball.ray",
            "SBT-raytracer 1.0 ambient_light { color = (1, 1, 1) } "
            "translate(0, 0, -9, sphere { material = { ambient = (1, 0, 0) } })");
  // A picture of one colour for each side: albedo is without light.
  writeFile("side.ray",
            "SBT-raytracer 1.0 ambient_light { color = (1, 1, 1) } translate(0, 0, -1, "
            "scale(9, square { material = { ambient = (0, 0.4, 0.8) } }))");
  ASSERT_EQ(run({"render", "side.ray", "--size", "4", "-q"}).status, 0);
  const std::string side = "side.png";
  const std::string sides = side + "," + side + "," + side + "," + side + "," + side + "," + side;
  const ToolResult result =
      run({"render", "ball.ray", "--size", "16", "-q", "--background", sides});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto picture = readPng(readFile("ball.png"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->image.at(0, 0), (render::Rgb8{0, 102, 204}));
  EXPECT_EQ(picture->image.at(8, 8), (render::Rgb8{255, 0, 0}));
}

TEST_F(SceneFile, CropHasThePixelsOfTheWholePicture) {
  for (const std::vector<std::string>& mode :
       {std::vector<std::string>{}, {"--mode", "ao", "--samples", "3"}, {"--mode", "normals"}}) {
    const render::Image whole = png(mode).image;
    auto arguments = mode;
    arguments.insert(arguments.end(), {"--crop", "7,5,20,9"});
    const render::Image part = png(arguments).image;
    ASSERT_EQ(part.size, (render::ImageSize{20, 9}));
    for (std::uint32_t y = 0; y < 9; ++y) {
      for (std::uint32_t x = 0; x < 20; ++x)
        ASSERT_EQ(part.at(x, y), whole.at(7 + x, 5 + y)) << x << ' ' << y;
    }
  }
}

TEST_F(SceneFile, ExrHasTheLayersOfTheFirstHit) {
  const auto file = readExr(bytes({"--format", "exr", "--crop", "2,1,30,12"}));
  ASSERT_TRUE(file);
  EXPECT_EQ(file->width, 30u);
  EXPECT_EQ(file->height, 12u);
  EXPECT_EQ(file->firstX, 2);
  EXPECT_EQ(file->firstY, 1);
  EXPECT_EQ(file->wholeWidth, 40u);
  EXPECT_EQ(file->wholeHeight, 20u);
  std::string names;
  for (const auto& [name, channel] : file->channels)
    names += name + (channel.isHalf ? "(half) " : " ");
  EXPECT_EQ(names,
            "A(half) B(half) G(half) N.X N.Y N.Z R(half) Z albedo.B(half) albedo.G(half) "
            "albedo.R(half) ");
}

TEST_F(SceneFile, TheCommandInThePictureMakesItAgain) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--crop", "1,2,20,10", "--no-shadows", "--flat", "--ray-depth",
                                 "2", "--supersampling", "3", "--threshold", "0.125",
                                 "--culls-back-faces"},
        {"--mode", "albedo", "--samples", "3"},
        {"--camera", "1,2,5,0,0,0"}}) {
    const PngFile first = png(arguments);
    std::istringstream stream(first.texts.at("Command"));
    std::vector<std::string> again;
    for (std::string word; stream >> word;)
      again.push_back(word);
    again.erase(again.begin());
    again.insert(again.end(), {"-q", "-o", "-"});
    const auto second = readPng(run(again).out);
    ASSERT_TRUE(second) << first.texts.at("Command");
    EXPECT_EQ(second->image.pixels, first.image.pixels) << first.texts.at("Command");
    EXPECT_EQ(second->texts, first.texts);
  }
}

TEST_F(SceneFile, StatsSayWhereTheTimeGoes) {
  const ToolResult result = run({"render", "balls.ray", "--size", "60", "--stats"});
  for (const char* said :
       {"time: reading ", ", building ", ", tracing ", ", shading ", ", writing "})
    EXPECT_NE(result.err.find(said), std::string::npos) << said << result.err;
  EXPECT_EQ(run({"render", "balls.ray", "--size", "8"}).err.find("time: "), std::string::npos);

  const nlohmann::json json = summary({"balls.ray", "--size", "60"});
  const nlohmann::json& times = json["times"];
  for (const char* step : {"reading", "building", "tracing", "shading", "writing"})
    EXPECT_GT(times[std::string(step) + "_seconds"], 0.0) << step;
  EXPECT_NEAR(times["tracing_seconds"].get<double>() + times["shading_seconds"].get<double>(),
              json["render_seconds"].get<double>(), 1e-9);
}

TEST_F(SceneFile, FaultsNameLineAndColumnAndNothingIsWritten) {
  writeFile("bad.ray", "SBT-raytracer 1.0\n\n  spheer { }\n");
  const ToolResult result = run({"render", "bad.ray"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("bad.ray"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("bad.ray:3:3"), std::string::npos) << result.err;
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"bad.ray", "balls.ray"}));
}

TEST_F(SceneFile, OptionsThatDoNotFitTheSceneAreWrongUsage) {
  const auto expectRefused = [this](std::vector<std::string> arguments, const char* named) {
    arguments.insert(arguments.begin(), {"render", "balls.ray", "-q"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.status, 2) << named;
    EXPECT_NE(result.err.find(named), std::string::npos) << result.err;
  };
  expectRefused({"--samples", "4"}, "--samples: --mode whitted has a grid");
  expectRefused({"--fov", "30"}, "--fov: the scene has a camera");
  expectRefused({"--size", "40", "--crop", "0,0,40,21"}, "the picture has 40 x 20 pixels");
}

TEST_F(SceneFile, AModelHasItsMaterialsInTheModesThatShowThem) {
  writeModel("roof.obj");
  for (const char* mode : {"whitted", "albedo"}) {
    const nlohmann::json json = summary({"roof.obj", "--mode", mode, "--size", "16"});
    EXPECT_EQ(json["mode"], mode);
    EXPECT_EQ(json["scene"]["shape_count"], 1);
    EXPECT_EQ(json["height"], 12);
  }
  EXPECT_EQ(summary({"roof.obj", "--size", "16"})["mode"], "ao");
}

}  // namespace
}  // namespace planetree::test
