#include "trace_test.hpp"

#include <planetree/build_tree.hpp>
#include <planetree/mesh/read_mesh.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace planetree::test {
namespace {

using nlohmann::json;

/// In a folder with a model, soup.obj, of some hundred triangles.
class Info : public ToolTest {
 protected:
  Info() { writeFile("soup.obj", objOf(mesh_)); }

  [[nodiscard]] ToolResult info(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"info", "soup.obj"});
    return run(std::move(arguments));
  }

  TriangleMesh<float> mesh_ = randomMesh<float>(5, 500);
};

/// Columns of a line of UTF-8 without wide characters.
std::size_t columnCount(const std::string& line) {
  return static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  }));
}

std::size_t widestLine(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);)
    widest = std::max(widest, columnCount(line));
  return widest;
}

TEST_F(Info, PrintsAPageOnStandardOutputAndNothingElse) {
  const ToolResult result = info({});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  for (const char* part : {"soup.obj (OBJ)\n", "\nModel\n", "\nTree\n", "\nTime\n", "\nLevels\n",
                           "\nLeaf sizes\n", "█"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
  EXPECT_LE(widestLine(result.out), 100u);
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"soup.obj"});
}

TEST_F(Info, JsonHasTheNumbersOfTheLibrary) {
  const std::vector<std::pair<const char*, BuildOptions>> presets = {
      {"fast", BuildOptions::fast()},
      {"balanced", BuildOptions::balanced()},
      {"high", BuildOptions::high()},
      {"textbook", BuildOptions::textbook()}};
  for (const auto& [name, preset] : presets) {
    const ToolResult result = info({"--json", "--preset", name});
    ASSERT_EQ(result.status, 0) << result.err;
    const json document = json::parse(result.out);
    const auto tree = buildTree(mesh_.view(), preset);
    const TreeStatistics expected = tree.statistics();
    EXPECT_EQ(document["model"], "soup.obj");
    EXPECT_EQ(document["mesh"]["triangle_count"], 500);
    EXPECT_EQ(document["mesh"]["vertex_count"], 1500);
    EXPECT_EQ(document["bounds"]["lower"][0].get<float>(), tree.bounds().lower.x);
    EXPECT_EQ(document["bounds"]["upper"][2].get<float>(), tree.bounds().upper.z);
    EXPECT_TRUE(document["read_seconds"].is_number());
    EXPECT_TRUE(document["build"]["split_seconds"].is_number());
    EXPECT_EQ(document["build"]["peak_bytes"], tree.report().peakBytes);
    EXPECT_EQ(document["build"]["options"]["exact_planes"], preset.exactPlanes);

    const json& numbers = document["tree"];
    EXPECT_EQ(numbers["leaf_node_count"], expected.leafNodeCount);
    EXPECT_EQ(numbers["sah_cost"].get<double>(), expected.sahCost);
    EXPECT_EQ(numbers["references_per_object"].get<double>(),
              static_cast<double>(expected.referenceCount) / 500.0);
    ASSERT_EQ(numbers["levels"].size(), expected.levels.size());
    for (std::size_t i = 0; i < expected.levels.size(); ++i) {
      const json& level = numbers["levels"][i];
      EXPECT_EQ(level["split_node_count"], expected.levels[i].splitNodeCount);
      EXPECT_EQ(level["leaf_node_count"], expected.levels[i].leafNodeCount);
      EXPECT_EQ(level["empty_leaf_count"], expected.levels[i].emptyLeafCount);
      EXPECT_EQ(level["reference_count"], expected.levels[i].referenceCount);
      EXPECT_EQ(level["traversal_cost"].get<double>(), expected.levels[i].traversalCost);
      EXPECT_EQ(level["intersection_cost"].get<double>(), expected.levels[i].intersectionCost);
    }
    ASSERT_EQ(numbers["leaf_sizes"].size(), expected.leafSizes.size());
    for (std::size_t i = 0; i < expected.leafSizes.size(); ++i) {
      EXPECT_EQ(numbers["leaf_sizes"][i]["object_count"], expected.leafSizes[i].objectCount);
      EXPECT_EQ(numbers["leaf_sizes"][i]["leaf_count"], expected.leafSizes[i].leafCount);
    }
  }
}

TEST_F(Info, TellsHowMuchMemoryTheBuildTook) {
  const json document = json::parse(info({"--json", "--threads", "1"}).out);
  const auto peak = document["build"]["peak_bytes"].get<std::uint64_t>();
  EXPECT_GT(peak, document["tree"]["bytes"].get<std::uint64_t>());
  const std::string page = info({}).out;
  EXPECT_NE(page.find("\n    to build  "), std::string::npos) << page;
}

TEST_F(Info, IsTheSameForAnyNumberOfThreads) {
  const auto treeWith = [this](const char* threads) {
    return json::parse(info({"--json", "--threads", threads}).out)["tree"];
  };
  EXPECT_EQ(treeWith("1"), treeWith("4"));
}

TEST_F(Info, NamesWhatWasSkippedAndWhy) {
  writeFile("bad.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\n"
            "f 1 2 3\nf 1 1 3\nf 1 2 4\nf 1 2 9\nf 1 2\n");
  const ToolResult page = run({"info", "bad.obj"});
  EXPECT_EQ(page.status, 0) << page.err;
  for (const char* part : {"skipped faces", "face 3 ", "face 4 ",
                           "face 1 has two corners at one point", "face 2 has a coordinate"})
    EXPECT_NE(page.out.find(part), std::string::npos) << part << "\n" << page.out;
  EXPECT_LE(widestLine(page.out), 100u);

  const json document = json::parse(run({"info", "bad.obj", "--json"}).out);
  EXPECT_EQ(document["mesh"]["skipped_polygon_count"], 2);
  EXPECT_EQ(document["skipped_polygons"].size(), 2u);
  EXPECT_EQ(document["build"]["skipped_object_count"], 2);
  EXPECT_EQ(document["skipped_triangles"].size(), 2u);
}

TEST_F(Info, SaysWhereASceneIsOutOfRange) {
  struct Size {
    const char* vertices;
    const char* said;
    const char* named;
  };
  for (const auto& [vertices, said, named] :
       {Size{"v 0 0 0\nv 1 0 0\nv 0 1073741824 0\n", "", "within"},
        Size{"v 0 0 0\nv 1 0 0\nv 0 3e9 0\n", "is more than 2^30 across: hits may be lost",
             "too-large"},
        Size{"v 0 0 0\nv 1e-12 0 0\nv 0 1e-12 0\n", "is less than 2^-30 across: hits may be lost",
             "too-small"},
        Size{"v 2e9 0 0\nv 2000001024 0 0\nv 2e9 1 0\n",
             "has coordinates beyond 2^30: hits may be lost", "too-far"}}) {
    writeFile("model.obj", std::string(vertices) + "f 1 2 3\n");
    const ToolResult page = run({"info", "model.obj"});
    EXPECT_EQ(page.status, 0) << page.err;
    for (const std::string& text : {page.out, runSmall({"model.obj"}).err}) {
      EXPECT_NE(text.find(said), std::string::npos) << said << "\n" << text;
      EXPECT_EQ(text.find("may be lost") != std::string::npos, *said != '\0') << text;
    }
    const json document = json::parse(run({"info", "model.obj", "--json"}).out);
    EXPECT_EQ(document["build"]["scene_range"], named);
  }
}

TEST_F(Info, NamesOnlyTheFirstFewThatWereSkipped) {
  std::string model = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (int i = 0; i < 1200; ++i)
    model += "f 1 1 2\n";
  writeFile("bad.obj", model);
  const ToolResult page = run({"info", "bad.obj"});
  EXPECT_NE(page.out.find("face 5 has two"), std::string::npos) << page.out;
  EXPECT_EQ(page.out.find("face 6 has two"), std::string::npos) << page.out;
  EXPECT_NE(page.out.find("... and 1,195 more\n"), std::string::npos) << page.out;
}

TEST_F(Info, FailsWhereStandardOutputIsFull) {
  const ToolResult result = run({.arguments = {"info", "soup.obj"}, .standardOutput = "/dev/full"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("standard output: cannot be written"), std::string::npos) << result.err;
}

TEST_F(Info, ShowsATreeThatIsOneLeaf) {
  writeFile("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const ToolResult result = run({"info", "one.obj", "--plot", "one.svg"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("levels"), std::string::npos);
  EXPECT_EQ(result.out.find("nan"), std::string::npos) << result.out;
  EXPECT_EQ(readFile("one.svg").find("nan"), std::string::npos);
}

TEST_F(Info, ShowsLeavesOfThousandsInRanges) {
  const ToolResult result = info({"--depth-limit", "1"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("256–511"), std::string::npos) << result.out;
  EXPECT_LE(widestLine(result.out), 100u);
}

using Plot = Info;

TEST_F(Plot, IsAPictureThatSaysWhatItShows) {
  const ToolResult result = info({"--plot", "soup.svg"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.err.find("wrote soup.svg"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("Levels"), std::string::npos) << "the page is printed as well";
  const std::string svg = readFile("soup.svg");
  EXPECT_EQ(svg.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\"", 0), 0u);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  for (const char* part :
       {"<title id=\"title\">The kd-tree of soup.obj</title>", "<desc", "role=\"img\"",
        "prefers-color-scheme: dark", "Leaves by level", "SAH cost by level", "Leaves by size"})
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  EXPECT_EQ(svg.find("href"), std::string::npos) << "nothing is fetched";
}

TEST_F(Plot, OfAFileWithAHostileNameIsStillXml) {
  const std::string name = "<b>&\"quotes\" \x01 \xff.obj";
  writeFile(name, objOf(mesh_));
  ASSERT_EQ(run({"info", name, "--plot", "out.svg"}).status, 0);
  const std::string svg = readFile("out.svg");
  EXPECT_NE(svg.find("&lt;b&gt;&amp;&quot;quotes&quot; \xEF\xBF\xBD \xEF\xBF\xBD.obj"),
            std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_EQ(svg.find('\xff'), std::string::npos);
  EXPECT_EQ(svg.find('\x01'), std::string::npos);
  EXPECT_EQ(run({"info", name, "--json"}).status, 0);
}

TEST_F(Plot, OnStandardOutputStandsAlone) {
  const ToolResult picture = info({"--plot", "-"});
  EXPECT_EQ(picture.status, 0);
  EXPECT_EQ(picture.out.rfind("<svg ", 0), 0u);
  EXPECT_EQ(picture.out.find("Levels"), std::string::npos);

  const ToolResult both = info({"--plot", "-", "--json"});
  EXPECT_EQ(both.out, picture.out);
  EXPECT_EQ(json::parse(both.err)["model"], "soup.obj");
}

TEST_F(Plot, IsSilentWhenAskedTo) {
  const ToolResult result = info({"--plot", "soup.svg", "-q"});
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out, "") << "the page is data";
}

/// A command line that is refused, and what the message must name.
struct RefusedInfo {
  std::vector<std::string> arguments;
  int status = 2;
  std::string named;
};

void PrintTo(const RefusedInfo& refused, std::ostream* out) {
  for (const std::string& argument : refused.arguments)
    *out << argument << ' ';
}

class InfoRefusal : public Info, public testing::WithParamInterface<RefusedInfo> {};

TEST_P(InfoRefusal, IsOneLineThatNamesTheCulprit) {
  writeFile("points.obj", "v 0 0 0\nv 1 0 0\n");
  const std::vector<std::string> before = filesInFolder();
  std::vector<std::string> arguments = GetParam().arguments;
  arguments.insert(arguments.begin(), "info");
  const ToolResult result = run(arguments);
  EXPECT_EQ(result.status, GetParam().status);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("planetree: ", 0), 0u) << result.err;
  EXPECT_NE(result.err.find(GetParam().named), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_EQ(filesInFolder(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Arguments, InfoRefusal,
    testing::Values(RefusedInfo{{}, 2, "MODEL"}, RefusedInfo{{"soup.obj", "more"}, 2, "more"},
                    RefusedInfo{{"soup.obj", "--plot", ""}, 2, "--plot"},
                    RefusedInfo{{"soup.obj", "--plot", "./soup.obj"}, 2, "that is the model"},
                    RefusedInfo{{"soup.obj", "--plot", "no/such/folder.svg"}, 1, "no/such"},
                    RefusedInfo{{"soup.obj", "--leaf-size", "-1"}, 2, "--leaf-size -1"},
                    RefusedInfo{{"missing.obj"}, 1, "missing.obj"},
                    RefusedInfo{{"missing.obj", "--plot", "out.svg"}, 1, "missing.obj"},
                    RefusedInfo{{"points.obj"}, 1, "has no triangles"}));

}  // namespace
}  // namespace planetree::test
