#include "tool_run.hpp"

#include <ostream>

namespace planetree::test {
namespace {

using Usage = ToolTest;

TEST_F(Usage, HelpGoesToStandardOutputWithExamples) {
  for (const char* option : {"--help", "-h"}) {
    const ToolResult whole = run({option});
    EXPECT_EQ(whole.status, 0);
    EXPECT_NE(whole.out.find("render"), std::string::npos);
    EXPECT_NE(whole.out.find("Examples:"), std::string::npos);
    EXPECT_EQ(whole.err, "");

    const ToolResult render = run({"render", option});
    EXPECT_EQ(render.status, 0);
    EXPECT_NE(render.out.find("Examples:"), std::string::npos);
    EXPECT_EQ(render.err, "");
  }
}

TEST_F(Usage, VersionGoesToStandardOutput) {
  const ToolResult result = run({"--version"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out.rfind("planetree ", 0), 0u) << result.out;
  EXPECT_EQ(result.err, "");
}

TEST_F(Usage, HelpAndVersionThatCannotBeWrittenAreFailures) {
  for (const char* option : {"--version", "--help"}) {
    const ToolResult result = run(ToolStart{.arguments = {option}, .standardOutput = "/dev/full"});
    EXPECT_EQ(result.status, 1) << option;
    EXPECT_NE(result.err.find("standard output"), std::string::npos) << result.err;
  }
}

TEST_F(Usage, OptionsBeforeTheCommandAreToldToStandBehindIt) {
  writeModel("model.obj");
  const ToolResult result = run({"-q", "info", "model.obj"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("Write it behind: planetree info ... -q."), std::string::npos)
      << result.err;
}

TEST_F(Usage, VersionNamesTheCompiler) {
  EXPECT_NE(run({"--version"}).out.find("\ncompiled by "), std::string::npos);
}

TEST_F(Usage, WithoutACommandAllOfThemAreShown) {
  const ToolResult result = run({std::vector<std::string>{}});
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, run({"--help"}).out);
  EXPECT_EQ(run({"help"}).out, result.err);
}

/// A command line that is refused, and what the message must name.
struct Refused {
  std::vector<std::string> arguments;
  std::string named;
};

void PrintTo(const Refused& refused, std::ostream* out) {
  for (const std::string& argument : refused.arguments)
    *out << argument << ' ';
}

class WrongUsage : public ToolTest, public testing::WithParamInterface<Refused> {};

TEST_P(WrongUsage, EndsWithStatusTwoAndOneLineThatNamesTheOption) {
  writeModel("model.obj");
  const ToolResult result = run(GetParam().arguments);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("planetree: ", 0), 0u) << result.err;
  EXPECT_NE(result.err.find(GetParam().named), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << "more than one line: " << result.err;
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"model.obj"});
}

INSTANTIATE_TEST_SUITE_P(
    Commands, WrongUsage,
    testing::Values(Refused{{"rendr"}, "rendr: there is no such command. Did you mean render?"},
                    Refused{{"build", "model.obj"}, "build: there is no such command. See"},
                    Refused{{"help", "rendr"}, "Did you mean render?"},
                    Refused{{"completion"}, "SHELL is missing"},
                    Refused{{"completion", "csh"}, "Give one of bash, zsh, fish"},
                    Refused{{"--bogus"}, "--bogus: planetree has no such option"},
                    Refused{{"render", "--bogus"}, "--bogus: planetree render has no such option"},
                    Refused{{"render", "--thread", "1"}, "Did you mean --threads?"},
                    Refused{{"trace"}, "MODEL is missing"},
                    Refused{{"trace", "model.obj"}, "RAYS is missing"},
                    Refused{{"trace", "model.obj", "-", "--json=x"}, "--json: it takes no value"},
                    Refused{{"render", "model.obj", "other.obj"}, "other.obj: one argument too"},
                    Refused{{"render", ""}, "MODEL"},
                    Refused{{"render", "--size"}, "Give --size WxH"},
                    Refused{{"render", "--size", "9x9", "--size", "8x8"}, "--size: given more"}));

INSTANTIATE_TEST_SUITE_P(
    Sizes, WrongUsage,
    testing::Values(Refused{{"render", "--size", "0x10"}, "--size 0x10"},
                    Refused{{"render", "--size", "10x0"}, "--size 10x0"},
                    Refused{{"render", "--size", "0"}, "--size 0"},
                    Refused{{"render", "--size", "99999999"}, "too large"},
                    Refused{{"render", "--size", "x"}, "--size x"},
                    Refused{{"render", "--size", ""}, "--size"},
                    Refused{{"render", "--size", "10x"}, "--size 10x"},
                    Refused{{"render", "--size", "10x10x10"}, "--size 10x10x10"},
                    Refused{{"render", "--size", "-10x10"}, "--size -10x10"},
                    Refused{{"render", "--size", "1.5x10"}, "--size 1.5x10"},
                    Refused{{"render", "--size", "10x 10"}, "--size 10x 10"},
                    Refused{{"render", "--size", "1000000000x1000000000"}, "too large"},
                    Refused{{"render", "--size", "4294967296x4294967296"}, "too large"},
                    Refused{{"render", "--size", "99999999999999999999x1"}, "--size 9"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, WrongUsage,
    testing::Values(Refused{{"render", "--samples", "0"}, "--samples 0"},
                    Refused{{"render", "--samples", "-4"}, "--samples -4"},
                    Refused{{"render", "--samples", "1.5"}, "--samples 1.5"},
                    Refused{{"render", "--samples", "many"}, "--samples many"},
                    Refused{{"render", "--samples", "99999999"}, "--samples 99999999"},
                    Refused{{"render", "--seed", "-1"}, "--seed -1"},
                    Refused{{"render", "--threads", "-1"}, "--threads -1"},
                    Refused{{"render", "--threads", "1000000"}, "--threads 1000000"},
                    Refused{{"render", "--memory-limit", "-1"}, "--memory-limit -1"},
                    Refused{{"render", "--memory-limit", "much"}, "such as 500M or 2GiB"},
                    Refused{{"render", "--leaf-size", "-1"}, "--leaf-size -1"},
                    Refused{{"render", "--traversal-cost", "-1"}, "--traversal-cost -1"},
                    Refused{{"render", "--traversal-cost", "inf"}, "--traversal-cost inf"},
                    Refused{{"render", "--traversal-cost", "1e10"}, "--traversal-cost 1e10"},
                    Refused{{"trace", "-", "-"}, "- twice"},
                    Refused{{"render", "--intersection-cost", "x"}, "--intersection-cost x"},
                    Refused{{"render", "--empty-bonus", "1"}, "--empty-bonus 1"},
                    Refused{{"render", "--empty-bonus", "nan"}, "--empty-bonus nan"},
                    Refused{{"render", "--stops-by-cost", "yes"}, "Give one of on, off"},
                    Refused{{"render", "--planar-rule", "left"}, "cheaper-side, normal-sign"},
                    Refused{{"render", "--references-per-object", "-1"}, "object -1"},
                    Refused{{"trace", "model.obj", "-", "--mask", "-1"}, "--mask -1"},
                    Refused{{"trace", "model.obj", "-", "--mask", "0x1FFFFFFFF"}, "--mask 0x1FF"},
                    Refused{{"trace", "model.obj", "-", "--mask", "0x"}, "--mask 0x"},
                    Refused{{"trace", "model.obj", "-", "--skip", "-1"}, "--skip -1"},
                    Refused{{"trace", "model.obj", "-", "--t-min", "nan"}, "--t-min nan"},
                    Refused{{"trace", "model.obj", "-", "--t-min", "2", "--t-max", "1"},
                            "--t-min 2: rays end at 1"},
                    Refused{{"render", "--depth-limit", "0"}, "--depth-limit 0"},
                    Refused{{"render", "--depth-limit", "1000"}, "--depth-limit 1000"},
                    Refused{{"render", "--show-cells", "0"}, "--show-cells 0"},
                    Refused{{"render", "--show-cells", "65"}, "--show-cells 65"},
                    Refused{{"render", "--show-cells", "all"}, "--show-cells all"},
                    Refused{{"render", "--mode", "heat", "--heat-max", "0"}, "--heat-max 0"},
                    Refused{{"render", "--mode", "heat", "--heat-max", "-5"}, "--heat-max -5"},
                    Refused{{"render", "--heat-max", "50"}, "--heat-max: only --mode heat"},
                    Refused{{"render", "--no-legend"}, "--no-legend: only --mode heat"}));

INSTANTIATE_TEST_SUITE_P(
    Parts, WrongUsage,
    testing::Values(Refused{{"render", "--crop", "1,2,3"}, "3 numbers instead of 4"},
                    Refused{{"render", "--crop", "1,2,3,x"}, "\"x\" is not a number"},
                    Refused{{"render", "--crop", "-1,2,3,4"}, "--crop -1,2,3,4"},
                    Refused{{"render", "--crop", "1,2,0,4"}, "--crop 1,2,0,4"},
                    Refused{{"render", "model.obj", "--size", "20x10", "--crop", "15,0,6,5"},
                            "--crop 15,0,6,5: the picture has 20 x 10 pixels"},
                    Refused{{"render", "model.obj", "--crop", "4294967295,0,4294967295,1"},
                            "--crop"},
                    Refused{{"render", "--preview", "0"}, "--preview 0"},
                    Refused{{"render", "--preview", "nan"}, "--preview nan"},
                    Refused{{"render", "--preview", "inf"}, "--preview inf"},
                    Refused{{"render", "--preview", "1", "-o", "-"}, "--preview: what was sent"}));

INSTANTIATE_TEST_SUITE_P(
    Materials, WrongUsage,
    testing::Values(
        Refused{{"render", "--mode", "whitted"}, "--mode whitted: the still life has no materials"},
        Refused{{"render", "--mode", "albedo"}, "--mode albedo: the still life"},
        Refused{{"render", "model.obj", "--mode", "whitted", "--samples", "4"}, "--supersampling"},
        Refused{{"render", "model.obj", "--ray-depth", "3"}, "--ray-depth: only --mode whitted"},
        Refused{{"render", "model.obj", "--supersampling", "3"}, "--supersampling: only"},
        Refused{{"render", "model.obj", "--threshold", "0.1"}, "--threshold: only"},
        Refused{{"render", "model.obj", "--no-shadows"}, "--no-shadows: only"},
        Refused{{"render", "model.obj", "--flat"}, "--flat: only"},
        Refused{{"render", "--mode", "whitted", "--ray-depth", "65"}, "--ray-depth 65"},
        Refused{{"render", "--mode", "whitted", "--supersampling", "0"}, "--supersampling 0"},
        Refused{{"render", "--mode", "whitted", "--threshold", "1.5"}, "--threshold 1.5"},
        Refused{{"render", "--mode", "whitted", "--threshold", "nan"}, "--threshold nan"},
        Refused{{"render", "--mode", "whitted", "--background", "a.png"}, "1 instead of 6"},
        Refused{{"render", "--mode", "whitted", "--background", "a,b,c,,e,f"}, "a name is empty"}));

INSTANTIATE_TEST_SUITE_P(Choices, WrongUsage,
                         testing::Values(Refused{{"render", "--mode", "photo"}, "--mode photo"},
                                         Refused{{"render", "--mode", "AO"}, "--mode AO"},
                                         Refused{{"render", "--preset", "best"}, "--preset best"},
                                         Refused{{"render", "--preset", "best"},
                                                 "fast, balanced, high, textbook"},
                                         Refused{{"render", "--exact-planes", "1"}, "on, off"},
                                         Refused{{"render", "model.obj", "--up", "x"}, "--up x"},
                                         Refused{{"render", "--up", "z"}, "--up z"}));

INSTANTIATE_TEST_SUITE_P(
    Cameras, WrongUsage,
    testing::Values(Refused{{"render", "--camera", "nan,0,0,1,1,1"}, "nan"},
                    Refused{{"render", "--camera", "0,0,0,1,inf,1"}, "inf"},
                    Refused{{"render", "--camera", "0,0,0,1,1e99,1"}, "1e99"},
                    Refused{{"render", "--camera", "0,0,0,1,1"}, "5 numbers"},
                    Refused{{"render", "--camera", "0,0,0,1,1,1,40,2"}, "8 numbers"},
                    Refused{{"render", "--camera", "0,0,0,1,,1"}, "--camera"},
                    Refused{{"render", "--camera", "zero"}, "--camera zero"},
                    Refused{{"render", "--camera", "-.5,2,3,-.5,2,3"}, "--camera -.5,2,3"},
                    Refused{{"render", "--camera", "0,0,0,1,1,1,0"}, "seventh"},
                    Refused{{"render", "--camera", "0,0,0,1,1,1,180"}, "seventh"},
                    Refused{{"render", "--camera", "0,0,0,1,1,1,nan"}, "nan"},
                    Refused{{"render", "--camera", "0,0,0,1,1,1,30", "--fov", "40"}, "--fov"},
                    Refused{{"render", "--fov", "0"}, "--fov 0"},
                    Refused{{"render", "--fov", "-40"}, "--fov -40"},
                    Refused{{"render", "--fov", "180"}, "--fov 180"},
                    Refused{{"render", "--fov", "nan"}, "--fov nan"}));

INSTANTIATE_TEST_SUITE_P(Outputs, WrongUsage,
                         testing::Values(Refused{{"render", "-o", "picture.jpg"}, "-o picture.jpg"},
                                         Refused{{"render", "-o", "a.png", "--format", "exr"},
                                                 "-o a.png: --format exr is something else"},
                                         Refused{{"render", "-o", "a.exr", "--format", "png"},
                                                 "-o a.exr: --format png is something else"},
                                         Refused{{"render", "--format", "tiff"}, "--format tiff"},
                                         Refused{{"render", "-o", ""}, "--output"},
                                         Refused{{"render", "model.obj", "-o", "model.obj"},
                                                 "-o model.obj"}));

TEST_F(Usage, TheModelIsNotReplacedByItsPicture) {
  writeModel("model");
  const ToolResult result = run({"render", "model", "-o", "./model"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("that is the model"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace planetree::test
