#include "tool_run.hpp"

#include "support/read_exr.hpp"
#include "support/read_png.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace planetree::test {
namespace {

namespace fs = std::filesystem;

/// The files that `planetree render` writes: what they show and what they say.
class PictureFile : public ToolTest {
 protected:
  /// A picture on standard output.
  [[nodiscard]] std::string bytes(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"-q", "-o", "-"});
    const ToolResult result = runSmall(std::move(arguments));
    EXPECT_EQ(result.status, 0) << result.err;
    return result.out;
  }
  [[nodiscard]] PngFile png(std::vector<std::string> arguments) const {
    auto file = readPng(bytes(std::move(arguments)));
    EXPECT_TRUE(file);
    return file.value_or(PngFile{.image = render::Image({1, 1}), .texts = {}});
  }
  [[nodiscard]] ExrFile exr(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--format", "exr"});
    auto file = readExr(bytes(std::move(arguments)));
    EXPECT_TRUE(file);
    return file.value_or(ExrFile{});
  }
};

std::set<std::string> channelNames(const ExrFile& file) {
  std::set<std::string> names;
  for (const auto& [name, channel] : file.channels)
    names.insert(name);
  return names;
}

/// The words of a command line without quotes.
std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> all;
  for (std::string word; stream >> word;)
    all.push_back(word);
  return all;
}

// --- heat ---

TEST_F(PictureFile, HeatHasALegendBelowThePictureThatLeavesItAsItIs) {
  const PngFile with = png({"--mode", "heat", "--size", "400x300"});
  const PngFile without = png({"--mode", "heat", "--size", "400x300", "--no-legend"});
  EXPECT_EQ(without.image.size, (render::ImageSize{400, 300}));
  EXPECT_EQ(with.image.size.width, 400u);
  EXPECT_GT(with.image.size.height, 330u);
  EXPECT_LT(with.image.size.height, 400u);
  EXPECT_TRUE(std::equal(without.image.pixels.begin(), without.image.pixels.end(),
                         with.image.pixels.begin()));
}

TEST_F(PictureFile, HeatOfOnePixelHasALegend) {
  const PngFile picture = png({"--mode", "heat", "--size", "1x1"});
  EXPECT_GT(picture.image.size.width, 100u);
  EXPECT_GT(picture.image.size.height, 30u);
}

TEST_F(PictureFile, NoOtherModeHasALegend) {
  for (const char* mode : {"ao", "normals", "depth"})
    EXPECT_EQ(png({"--mode", mode}).image.size, (render::ImageSize{24, 16})) << mode;
}

TEST_F(PictureFile, HeatMaxGivesEqualWorkEqualColoursInDifferentPictures) {
  // Two trees, and every pixel of which both take the same steps.
  const std::vector<std::string> common = {"--mode", "heat", "--no-legend", "--heat-max", "60"};
  const auto with = [&common](std::vector<std::string> more) {
    more.insert(more.end(), common.begin(), common.end());
    return more;
  };
  const PngFile a = png(with({}));
  const PngFile b = png(with({"--leaf-size", "30"}));
  const std::vector<float> stepsA = exr(with({})).channels.at("steps").values;
  const std::vector<float> stepsB = exr(with({"--leaf-size", "30"})).channels.at("steps").values;
  std::map<float, render::Rgb8> colours;
  for (std::size_t i = 0; i < stepsA.size(); ++i)
    colours[stepsA[i]] = a.image.pixels[i];
  int compared = 0;
  for (std::size_t i = 0; i < stepsB.size(); ++i) {
    if (const auto known = colours.find(stepsB[i]); known != colours.end()) {
      EXPECT_EQ(b.image.pixels[i], known->second) << stepsB[i];
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
}

TEST_F(PictureFile, HeatMaxIsTheEndOfTheScale) {
  const PngFile picture = png({"--mode", "heat", "--heat-max", "77"});
  EXPECT_NE(picture.texts.at("Range").find("pale yellow 77 "), std::string::npos)
      << picture.texts.at("Range");
}

// --- cells ---

TEST_F(PictureFile, CellsAreDrawnOverEveryMode) {
  for (const char* mode : {"ao", "normals", "depth", "heat"}) {
    const std::vector<std::string> view = {"--mode", mode, "--camera", "9,5,9,0,1,0"};
    auto withCells = view;
    withCells.insert(withCells.end(), {"--show-cells", "3"});
    EXPECT_NE(png(withCells).image.pixels, png(view).image.pixels) << mode;
  }
}

TEST_F(PictureFile, CellsDeeperThanTheTreeAreWrongUsageThatSaysHowDeepItIs) {
  const ToolResult result = runSmall({"-q", "--depth-limit", "3", "--show-cells", "4"});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err,
            "planetree: --show-cells 4: this tree has 3 levels. Give a number from 1 to 3.\n");
  EXPECT_TRUE(filesInFolder().empty());
  EXPECT_EQ(runSmall({"-q", "--depth-limit", "3", "--show-cells", "3"}).status, 0);
}

TEST_F(PictureFile, TheViewOfCellsShowsTheWholeBoxOfTheTree) {
  writeModel("roof.obj");
  const ExrFile file = exr({"roof.obj", "--size", "64x48", "--show-cells", "1"});
  const std::vector<float>& alpha = file.channels.at("cells.A").values;
  EXPECT_GT(*std::max_element(alpha.begin(), alpha.end()), 0.5f);
  for (std::uint32_t y = 0; y < file.height; ++y) {
    for (std::uint32_t x = 0; x < file.width; ++x) {
      if (x == 0 || y == 0 || x == file.width - 1 || y == file.height - 1) {
        EXPECT_EQ(alpha[y * file.width + x], 0.0f) << x << ", " << y;
      }
    }
  }
}

// --- EXR ---

TEST_F(PictureFile, TheNameChoosesTheFormatAndSoDoesFormat) {
  EXPECT_EQ(runSmall({"-o", "picture.exr"}).status, 0);
  EXPECT_TRUE(readExr(readFile("picture.exr")));
  EXPECT_EQ(runSmall({"-o", "PICTURE.EXR"}).status, 0);
  EXPECT_TRUE(readExr(readFile("PICTURE.EXR")));
  EXPECT_EQ(runSmall({"-o", "picture", "--format", "exr"}).status, 0);
  EXPECT_EQ(readFile("picture"), readFile("picture.exr"));
  EXPECT_EQ(bytes({"--format", "exr"}), readFile("picture.exr"));
  EXPECT_TRUE(isPng(bytes({"--format", "png"}), 24, 16));
  writeModel("roof.obj");
  EXPECT_EQ(runSmall({"roof.obj", "--format", "exr"}).status, 0);
  EXPECT_TRUE(readExr(readFile("roof.exr")));
}

TEST_F(PictureFile, ExrHasTheChannelsOfItsMode) {
  const std::set<std::string> colours = {"R", "G", "B", "A"};
  const auto and_ = [&colours](const std::set<std::string>& more) {
    std::set<std::string> all = colours;
    all.insert(more.begin(), more.end());
    return all;
  };
  EXPECT_EQ(channelNames(exr({"--mode", "ao"})), colours);
  EXPECT_EQ(channelNames(exr({"--mode", "normals"})), and_({"N.X", "N.Y", "N.Z"}));
  EXPECT_EQ(channelNames(exr({"--mode", "depth"})), and_({"Z"}));
  EXPECT_EQ(channelNames(exr({"--mode", "heat"})),
            and_({"steps", "steps.splitNodes", "steps.leafNodes", "steps.objects"}));
  EXPECT_EQ(channelNames(exr({"--show-cells", "2"})),
            and_({"cells.R", "cells.G", "cells.B", "cells.A"}));
}

TEST_F(PictureFile, ExrStoresColoursAsHalvesAndMeasurementsAsFloats) {
  for (const auto& [name, channel] : exr({"--mode", "depth", "--show-cells", "2"}).channels)
    EXPECT_EQ(channel.isHalf, name != "Z") << name;
}

/// A square of edge 2 at z = 0, seen from z = 5 by a camera that looks straight at it.
const std::vector<std::string> kWallView = {"wall.obj", "--size", "30x20", "--camera",
                                            "0,0,5,0,0,0,90"};
constexpr const char* kWall = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\nf 1 3 4\n";

TEST_F(PictureFile, ExrOfDepthHasTheDistanceOfTheWallAndInfinityAroundIt) {
  writeFile("wall.obj", kWall);
  auto arguments = kWallView;
  arguments.insert(arguments.end(), {"--mode", "depth"});
  const ExrFile file = exr(arguments);
  // Half the picture's height shows 5 units: the wall covers 4 of 20 rows.
  for (std::uint32_t y = 0; y < file.height; ++y) {
    for (std::uint32_t x = 0; x < file.width; ++x) {
      const bool isWall = x >= 13 && x < 17 && y >= 8 && y < 12;
      const float depth = file.channels.at("Z").values[y * file.width + x];
      if (isWall) {
        EXPECT_NEAR(depth, 5.0f, 5e-6f) << x << ", " << y;
      } else {
        EXPECT_EQ(depth, std::numeric_limits<float>::infinity()) << x << ", " << y;
      }
      EXPECT_EQ(file.channels.at("A").values[y * file.width + x], isWall ? 1.0f : 0.0f);
    }
  }
}

TEST_F(PictureFile, ExrOfNormalsHasThemFromMinusOneToOne) {
  writeFile("wall.obj", kWall);
  auto arguments = kWallView;
  arguments.insert(arguments.end(), {"--mode", "normals"});
  ExrFile file = exr(arguments);
  const std::size_t middle = 10 * 30 + 15;
  EXPECT_EQ(file.channels["N.X"].values[middle], 0.0f);
  EXPECT_EQ(file.channels["N.Y"].values[middle], 0.0f);
  EXPECT_EQ(file.channels["N.Z"].values[middle], 1.0f);
  EXPECT_EQ(file.channels["N.Z"].values[0], 0.0f);
}

TEST_F(PictureFile, ExrOfHeatHasWholeStepsOfSingleRaysAndTheirSum) {
  ExrFile file = exr({"--mode", "heat"});
  const auto& steps = file.channels["steps"].values;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const float nodes = file.channels["steps.splitNodes"].values[i];
    const float objects = file.channels["steps.objects"].values[i];
    EXPECT_EQ(nodes, std::round(nodes));
    EXPECT_EQ(objects, std::round(objects));
    EXPECT_EQ(steps[i], nodes + objects);
  }
  EXPECT_GT(*std::max_element(steps.begin(), steps.end()), 10.0f);
}

TEST_F(PictureFile, ExrOfHeatHasNoLegend) {
  const ExrFile file = exr({"--mode", "heat"});
  EXPECT_EQ(file.width, 24u);
  EXPECT_EQ(file.height, 16u);
}

TEST_F(PictureFile, CellsDoNotTouchTheDataOfAnExr) {
  const std::vector<std::string> view = {"--mode", "depth", "--camera", "9,5,9,0,1,0"};
  auto withCells = view;
  withCells.insert(withCells.end(), {"--show-cells", "4"});
  const ExrFile plain = exr(view);
  const ExrFile both = exr(withCells);
  for (const auto& [name, channel] : plain.channels)
    EXPECT_EQ(both.channels.at(name).values, channel.values) << name;
}

// --- what the files say ---

TEST_F(PictureFile, BothFormatsSayHowTheyWereMade) {
  writeModel("roof.obj");
  const std::vector<std::string> arguments = {"roof.obj", "--mode", "heat", "--seed", "7"};
  const auto texts = png(arguments).texts;
  EXPECT_EQ(texts.at("Software").rfind("planetree ", 0), 0u);
  EXPECT_EQ(texts.at("Model"), "roof.obj");
  EXPECT_EQ(texts.at("Triangles"), "2");
  EXPECT_EQ(texts.at("Skipped"), "0");
  EXPECT_EQ(texts.at("Mode"), "heat");
  EXPECT_EQ(texts.at("Samples"), "1");
  EXPECT_EQ(texts.at("Seed"), "7");
  EXPECT_EQ(texts.at("Camera").rfind("eye ", 0), 0u);
  EXPECT_NE(texts.at("Tree Options").find("--leaf-size 4"), std::string::npos);
  EXPECT_NE(texts.at("Tree").find("1 leaves"), std::string::npos) << texts.at("Tree");
  EXPECT_NE(texts.at("Range").find("split nodes visited and objects tested"), std::string::npos);
  EXPECT_EQ(texts.count("Creation Time"), 0u);

  const auto attributes = exr(arguments).texts;
  for (const auto& [key, text] : texts) {
    std::string name = key;
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    name[0] = static_cast<char>(std::tolower(name[0]));
    EXPECT_EQ(attributes.at(name), text) << name;
  }
}

TEST_F(PictureFile, TheCommandInTheFileMakesTheSameFile) {
  writeModel("roof.obj");
  const std::vector<std::vector<std::string>> commands = {
      {},
      {"roof.obj", "--up", "z", "--fov", "30"},
      {"roof.obj", "--preset", "textbook", "--leaf-size", "1"},
      {"--mode", "heat", "--heat-max", "55", "--show-cells", "5", "--depth-limit", "9"},
      {"--mode", "heat", "--no-legend", "--stops-by-cost", "off", "--traversal-cost", "0.7"}};
  for (const std::vector<std::string>& command : commands) {
    const std::string picture = bytes(command);
    const auto read = readPng(picture);
    ASSERT_TRUE(read);
    std::vector<std::string> again = words(read->texts.at("Command"));
    ASSERT_EQ(again.at(0), "planetree");
    again.erase(again.begin());
    again.insert(again.end(), {"-q", "-o", "-"});
    EXPECT_EQ(run(again).out, picture) << read->texts.at("Command");
  }
}

TEST_F(PictureFile, NamesThatAShellOrAFormatWouldNotTakeAreQuoted) {
  const std::string plain = "it's a roof.obj";
  writeModel(plain);
  EXPECT_NE(png({plain}).texts.at("Command").find(R"( 'it'\''s a roof.obj' )"), std::string::npos);
  EXPECT_EQ(png({plain}).texts.at("Model"), plain);

  const std::string hare = "H\xC3\xA4schen.obj";
  writeModel(hare);
  EXPECT_EQ(png({hare}).texts.at("Model"), hare);
  EXPECT_NE(png({hare}).texts.at("Command").find("'" + hare + "'"), std::string::npos);

  // Latin-1, which is no UTF-8, and a line end.
  const std::string wild = "H\xE4s\nchen.obj";
  writeModel(wild);
  EXPECT_EQ(png({wild}).texts.at("Model"), R"($'H\xe4s\x0achen.obj')");
  EXPECT_NE(png({wild}).texts.at("Command").find(R"( $'H\xe4s\x0achen.obj' )"), std::string::npos);
  EXPECT_EQ(exr({wild}).texts.at("model"), R"($'H\xe4s\x0achen.obj')");
}

class SourceDateEpoch : public PictureFile {
 protected:
  ~SourceDateEpoch() override { ::unsetenv("SOURCE_DATE_EPOCH"); }
};

TEST_F(SourceDateEpoch, GivesTheFileATime) {
  ::setenv("SOURCE_DATE_EPOCH", "1000000000", 1);
  EXPECT_EQ(png({}).texts.at("Creation Time"), "2001-09-09T01:46:40Z");
  EXPECT_EQ(exr({}).texts.at("creationTime"), "2001-09-09T01:46:40Z");
}

TEST_F(SourceDateEpoch, IsRefusedIfItIsNoTime) {
  for (const char* time : {"", "yesterday", "-1", "1e9", "99999999999999"}) {
    ::setenv("SOURCE_DATE_EPOCH", time, 1);
    const ToolResult result = runSmall({"-q"});
    EXPECT_EQ(result.status, 2) << time;
    EXPECT_NE(result.err.find("SOURCE_DATE_EPOCH"), std::string::npos) << result.err;
    EXPECT_TRUE(filesInFolder().empty()) << time;
  }
}

TEST_F(PictureFile, HasTheSameBytesForAnyNumberOfThreads) {
  for (const char* format : {"png", "exr"}) {
    const std::vector<std::string> common = {"--size",       "64x48", "--mode",   "heat",
                                             "--show-cells", "6",     "--format", format};
    const auto withThreads = [&](const char* threads) {
      auto arguments = common;
      arguments.insert(arguments.end(), {"--threads", threads});
      return bytes(arguments);
    };
    const std::string one = withThreads("1");
    EXPECT_EQ(withThreads("3"), one) << format;
    EXPECT_EQ(withThreads("0"), one) << format;
  }
}

// --- --json ---

TEST_F(PictureFile, JsonSaysWhatWasDone) {
  writeModel("roof.obj");
  const ToolResult result =
      runSmall({"roof.obj", "--mode", "heat", "--show-cells", "1", "--json", "-o", "roof.png"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("wrote roof.png"), std::string::npos);
  const auto json = nlohmann::json::parse(result.out);
  const std::string file = readFile("roof.png");
  const auto picture = readPng(file);
  ASSERT_TRUE(picture);
  EXPECT_EQ(json.at("model"), "roof.obj");
  EXPECT_EQ(json.at("picture"), "roof.png");
  EXPECT_EQ(json.at("format"), "png");
  EXPECT_EQ(json.at("width"), picture->image.size.width);
  EXPECT_EQ(json.at("height"), picture->image.size.height);
  EXPECT_EQ(json.at("byte_count"), file.size());
  EXPECT_EQ(json.at("command"), picture->texts.at("Command"));
  EXPECT_EQ(json.at("mode"), "heat");
  EXPECT_EQ(json.at("samples"), 1);
  EXPECT_EQ(json.at("seed"), 0);
  EXPECT_EQ(json.at("cell_depth"), 1);
  EXPECT_EQ(json.at("camera").at("eye").size(), 3u);
  EXPECT_EQ(json.at("camera").at("fov"), 40);
  EXPECT_EQ(json.at("mesh").at("triangle_count"), 2);
  EXPECT_EQ(json.at("build").at("object_count"), 2);
  EXPECT_EQ(json.at("tree").at("depth"), 1);
  EXPECT_GE(json.at("range").at("max"), json.at("range").at("min"));
  EXPECT_EQ(json.at("ray_count"), 24 * 16 * (1 + 4));
  EXPECT_GT(json.at("render_seconds"), 0.0);
}

TEST_F(PictureFile, JsonOfTheStillLifeHasNoModel) {
  const auto json = nlohmann::json::parse(runSmall({"--json", "-q"}).out);
  EXPECT_TRUE(json.at("model").is_null());
  EXPECT_TRUE(json.at("mesh").is_null());
  EXPECT_TRUE(json.at("range").is_null());
  EXPECT_TRUE(json.at("cell_depth").is_null());
  EXPECT_EQ(json.at("picture"), "render.png");
}

TEST_F(PictureFile, JsonGoesToStandardErrorBesideAPictureOnStandardOutput) {
  const ToolResult result = runSmall({"--json", "-o", "-"});
  EXPECT_TRUE(isPng(result.out, 24, 16));
  EXPECT_EQ(nlohmann::json::parse(result.err).at("picture"), "-");
}

// --- failures ---

TEST_F(PictureFile, AFullDiskLeavesNoPartOfAnExr) {
  writeFile("picture.exr", "the old picture");
  const ToolResult result = run(ToolStart{
      .arguments = {"render", "-q", "--size", "64x64", "--samples", "1", "-o", "picture.exr"},
      .largestFile = 1000});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("picture.exr: cannot be written"), std::string::npos) << result.err;
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"picture.exr"});
  EXPECT_EQ(readFile("picture.exr"), "the old picture");
}

TEST_F(PictureFile, AFullStandardOutputIsReportedForJsonToo) {
  if (!fs::exists("/dev/full"))
    GTEST_SKIP() << "there is no /dev/full";
  const ToolResult result =
      run(ToolStart{.arguments = {"render", "-q", "--size", "8x8", "--samples", "1", "--json"},
                    .standardOutput = "/dev/full"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("standard output: cannot be written"), std::string::npos);
}

}  // namespace
}  // namespace planetree::test
