#include "command_line.hpp"

#include "command_options.hpp"
#include "option_syntax.hpp"
#include "trace_test.hpp"
#include "usage_error.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/shape/sphere.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// Facts that hold for all subcommands, found by walking the definitions of their options.
namespace planetree::test {
namespace {

using tool::CommandLine;
using tool::CommandSyntax;
using tool::OptionSyntax;
using tool::ValueKind;

CommandSyntax wholeSyntax() {
  return tool::commandSyntax(CommandLine().app());
}

TEST(CommandLine, OptionsOfOneNameAreTheSameInAllSubcommands) {
  std::map<std::string, OptionSyntax> known;
  for (const CommandSyntax& command : wholeSyntax().commands) {
    for (const OptionSyntax& option : command.options) {
      // Files, and what is in them, differ from command to command; and a sheet of pictures is made
      // of smaller ones than a picture alone.
      const bool isFile = option.kind == ValueKind::Model || option.kind == ValueKind::File;
      if (option.names.back() == "--format" || option.group == "Contact sheet")
        continue;
      const auto [place, isNew] = known.emplace(option.names.back(), option);
      const OptionSyntax& first = place->second;
      EXPECT_EQ(option.names, first.names) << command.name;
      EXPECT_EQ(option.value, first.value) << command.name << " " << option.names.back();
      EXPECT_EQ(option.group, first.group) << command.name << " " << option.names.back();
      if (!isFile) {
        EXPECT_EQ(option.description, first.description) << command.name;
        EXPECT_EQ(option.defaultValue, first.defaultValue) << command.name;
      }
    }
  }
}

TEST(CommandLine, EveryOptionIsDescribed) {
  for (const CommandSyntax& command : wholeSyntax().commands) {
    EXPECT_FALSE(command.description.empty()) << command.name;
    for (const OptionSyntax& option : command.options) {
      EXPECT_FALSE(option.description.empty()) << command.name << " " << option.names.back();
      EXPECT_FALSE(option.description.ends_with('.')) << command.name << " " << option.names.back();
    }
  }
}

TEST(CommandLine, HelpNamesEveryOptionAndFitsIntoATerminal) {
  const CommandLine line;
  for (const CLI::App* const command : line.app().get_subcommands({})) {
    const std::string help = command->help("planetree");
    for (const OptionSyntax& option : tool::commandSyntax(*command).options) {
      EXPECT_NE(help.find(option.names.back()), std::string::npos) << option.names.back();
    }
    std::size_t start = 0;
    for (std::size_t end = help.find('\n'); end != std::string::npos;
         end = help.find('\n', start)) {
      EXPECT_LE(end - start, 80u) << help.substr(start, end - start);
      start = end + 1;
    }
  }
}

/// The options as the tool understands them.
BuildOptions parsedTreeOptions(std::vector<std::string> arguments) {
  CLI::App app;
  tool::TreeOptions options;
  tool::addTreeOptions(app, options);
  std::reverse(arguments.begin(), arguments.end());
  app.parse(arguments);
  return tool::buildOptions(options, {});
}

/// Whatever `BuildOptions` has, but for the threads, which change nothing. A member that is added
/// there does not compile here, until it is in the list and has an option.
auto membersOf(const BuildOptions& options) {
  const auto& [leafSize, depthLimit, cost, stopsByCost, allowsEmptyCells, clipsReferences,
               planarRule, exactPlanes, retractsSplits, referencesPerObject, threadCount] = options;
  const auto& [traversalCost, intersectionCost, faceCost, emptyBonus] = cost;
  return std::tuple(leafSize, depthLimit, traversalCost, intersectionCost, faceCost, emptyBonus,
                    stopsByCost, allowsEmptyCells, clipsReferences, planarRule, exactPlanes,
                    retractsSplits, referencesPerObject);
}

/// Triangles in all positions, large enough to cross each other.
TriangleMesh<float> heap() {
  return randomMesh<float>(7, 400);
}

/// Squares in planes across the x axis, every other one turned round, with triangles of the heap in
/// between: which side the squares go to matters.
TriangleMesh<float> walls() {
  TriangleMesh<float> mesh = randomMesh<float>(8, 40);
  for (int wall = 0; wall < 24; ++wall) {
    const float x = static_cast<float>(wall) / 12.0f - 1.0f;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{x, -1, -1}, {x, 1, -1}, {x, 1, 1}, {x, -1, 1}});
    for (const auto& [second, third] : {std::pair{1u, 2u}, std::pair{2u, 3u}}) {
      const bool isTurned = wall % 2 != 0;
      mesh.faces.push_back(
          {first, first + (isTurned ? third : second), first + (isTurned ? second : third)});
    }
  }
  return mesh;
}

/// Objects that are no faces.
std::vector<Sphere<float>> balls() {
  std::vector<Sphere<float>> balls;
  for (const Vec3f& center : randomMesh<float>(9, 100).positions)
    balls.push_back({center, 0.01f});
  return balls;
}

std::vector<std::uint64_t> shapesOf(const BuildOptions& options) {
  std::vector<std::uint64_t> shapes;
  const auto add = [&](const TreeStatistics& tree) {
    shapes.insert(shapes.end(), {tree.splitNodeCount, tree.leafNodeCount, tree.emptyLeafCount,
                                 tree.referenceCount, tree.largestLeaf, tree.depth});
  };
  // Dearer faces make more splits, in which more can differ.
  BuildOptions fine = options;
  fine.cost.faceCost *= 30.0;
  for (const TriangleMesh<float>& mesh : {heap(), walls()})
    add(buildTree(mesh.view(), fine).statistics());
  add(buildTree(balls(), options).statistics());
  return shapes;
}

TEST(TreeOptions, WithoutAnyAreThoseOfTheLibrary) {
  EXPECT_EQ(membersOf(parsedTreeOptions({})), membersOf(BuildOptions{}));
  const auto ofPreset = [](const char* name) {
    return membersOf(parsedTreeOptions({"--preset", name}));
  };
  EXPECT_EQ(ofPreset("fast"), membersOf(BuildOptions::fast()));
  EXPECT_EQ(ofPreset("balanced"), membersOf(BuildOptions{}));
  EXPECT_EQ(ofPreset("high"), membersOf(BuildOptions::high()));
  EXPECT_EQ(ofPreset("textbook"), membersOf(BuildOptions::textbook()));
}

const std::vector<std::vector<std::string>> kTreeFlags = {
    {"--leaf-size", "20"},
    {"--depth-limit", "3"},
    {"--traversal-cost", "10"},
    {"--intersection-cost", "9"},
    {"--face-cost", "9"},
    {"--empty-bonus", "0.9"},
    {"--stops-by-cost", "off"},
    {"--allows-empty-cells", "off"},
    {"--clips-references", "off"},
    {"--planar-rule", "normal-sign"},
    {"--exact-planes", "off"},
    {"--retracts-splits", "on"},
    {"--references-per-object", "1"},
};

TEST(TreeOptions, EachChangesOneMemberAndTheTree) {
  const BuildOptions defaults;
  const auto usual = shapesOf(defaults);
  for (const std::vector<std::string>& flag : kTreeFlags) {
    const BuildOptions changed = parsedTreeOptions(flag);
    int differences = 0;
    std::apply(
        [&](const auto&... before) {
          std::apply([&](const auto&... after) { ((differences += before != after ? 1 : 0), ...); },
                     membersOf(changed));
        },
        membersOf(defaults));
    EXPECT_EQ(differences, 1) << flag.front();
    EXPECT_NE(shapesOf(changed), usual) << flag.front();
  }
  EXPECT_EQ(kTreeFlags.size(), std::tuple_size_v<decltype(membersOf(defaults))>);
}

TEST(TreeOptions, ChangeAPresetWhereverItStands) {
  const BuildOptions before = parsedTreeOptions({"--leaf-size", "3", "--preset", "textbook"});
  const BuildOptions after = parsedTreeOptions({"--preset", "textbook", "--leaf-size", "3"});
  BuildOptions expected = BuildOptions::textbook();
  expected.leafSize = 3;
  EXPECT_EQ(membersOf(before), membersOf(expected));
  EXPECT_EQ(membersOf(after), membersOf(expected));
}

TEST(TreeOptions, AreDescribedWithTheDefaultAndThePresetsThatDiffer) {
  CLI::App app;
  tool::TreeOptions options;
  tool::addTreeOptions(app, options);
  for (const std::vector<std::string>& flag : kTreeFlags)
    EXPECT_NE(app.get_option_no_throw(flag.front()), nullptr) << flag.front();
  const auto expectEnd = [&app](const char* name, const std::string& presets) {
    const std::string description = app.get_option(name)->get_description();
    EXPECT_TRUE(description.ends_with(" " + presets)) << description;
  };
  expectEnd("--leaf-size", "(default " + std::to_string(BuildOptions{}.leafSize) + ", textbook " +
                               std::to_string(BuildOptions::textbook().leafSize) + ")");
  expectEnd("--exact-planes", "(default on, fast off)");
  expectEnd("--intersection-cost", "(default 1)");
}

/// What --memory-limit makes of a text.
std::uint64_t parsedMemoryLimit(const std::string& text) {
  CLI::App app;
  tool::RunOptions options;
  tool::addRunOptions(app, options);
  app.parse(std::vector<std::string>{text, "--memory-limit"});
  return tool::buildControl(options).memoryLimit;
}

TEST(MemoryLimit, IsANumberOfBytesOrOfLargerUnits) {
  EXPECT_EQ(tool::buildControl({}).memoryLimit, 0u);
  EXPECT_EQ(parsedMemoryLimit("0"), 0u);
  EXPECT_EQ(parsedMemoryLimit("123456789012"), 123'456'789'012u);
  EXPECT_EQ(parsedMemoryLimit("7B"), 7u);
  for (const char* text : {"3k", "3K", "3kB"})
    EXPECT_EQ(parsedMemoryLimit(text), 3'000u) << text;
  EXPECT_EQ(parsedMemoryLimit("500M"), 500'000'000u);
  EXPECT_EQ(parsedMemoryLimit("500MB"), 500'000'000u);
  EXPECT_EQ(parsedMemoryLimit("2G"), 2'000'000'000u);
  EXPECT_EQ(parsedMemoryLimit("2T"), 2'000'000'000'000u);
  EXPECT_EQ(parsedMemoryLimit("1KiB"), 1024u);
  EXPECT_EQ(parsedMemoryLimit("3MiB"), std::uint64_t{3} << 20u);
  EXPECT_EQ(parsedMemoryLimit("3Gi"), std::uint64_t{3} << 30u);
  EXPECT_EQ(parsedMemoryLimit("1TiB"), std::uint64_t{1} << 40u);
  EXPECT_EQ(parsedMemoryLimit("18446744073709551615"), ~std::uint64_t{0});
}

TEST(MemoryLimit, IsNothingElse) {
  for (const char* text : {"", "M", "-1", "1.5G", "5 M", "5m", "5MM", "5MBB", "5iB", "0x10", "1e9",
                           "18446744073709551616", "18446744073710M", "16777216TiB"})
    EXPECT_THROW(static_cast<void>(parsedMemoryLimit(text)), tool::UsageError) << text;
}

class EveryChoice : public ToolTest {};

TEST_F(EveryChoice, ThatTheHelpOffersIsTaken) {
  for (const CommandSyntax& command : wholeSyntax().commands) {
    for (const OptionSyntax& option : command.options) {
      for (const std::string& choice : option.choices) {
        // Without what the command needs, or with a model that is missing, it ends at once.
        const ToolResult result =
            option.isPositional
                ? run({command.name, choice})
                : run({command.name, "missing.obj", option.names.back(), choice, "-q"});
        EXPECT_EQ(result.err.find("no such choice"), std::string::npos) << result.err;
      }
    }
  }
}

}  // namespace
}  // namespace planetree::test
