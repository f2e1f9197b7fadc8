#include "support/read_png.hpp"
#include "trace_test.hpp"

#include <planetree/build_tree.hpp>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace planetree::test {
namespace {

using nlohmann::json;

/// In a folder with a model, soup.obj, of some hundred triangles.
class Compare : public ToolTest {
 protected:
  Compare() { writeFile("soup.obj", objOf(mesh_)); }

  /// Quick: a few rays, once.
  [[nodiscard]] ToolResult compareSubject(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"compare", "--rounds", "1", "--ray-picture", "32"});
    return run(std::move(arguments));
  }
  [[nodiscard]] ToolResult compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "soup.obj");
    return compareSubject(std::move(arguments));
  }
  [[nodiscard]] std::map<std::string, std::string> textsOfSheet() const {
    const auto sheet = readPng(readFile("sheet.png"));
    EXPECT_TRUE(sheet);
    return sheet ? sheet->texts : std::map<std::string, std::string>();
  }

  TriangleMesh<float> mesh_ = randomMesh<float>(5, 500);
};

TEST_F(Compare, PrintsATableWithAColumnForEachPreset) {
  const ToolResult result = compare({});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* part :
       {"soup.obj (500 triangles)\n", " fast     balanced         high\n", "\nTree\n", "  SAH cost",
        "\nSteps of a primary ray\n", "\nMillion rays per second\n", "  primary (1,024)"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"soup.obj"});
}

TEST_F(Compare, JsonHasTheFiguresOfTheLibrary) {
  const std::vector<std::pair<const char*, BuildOptions>> presets = {
      {"textbook", BuildOptions::textbook()},
      {"fast", BuildOptions::fast()},
      {"high", BuildOptions::high()}};
  const ToolResult result = compare({"--json", "--presets", "textbook,fast,high"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json document = json::parse(result.out);
  EXPECT_EQ(document["model"], "soup.obj");
  EXPECT_EQ(document["mesh"]["triangle_count"], 500);
  EXPECT_TRUE(document["picture"].is_null());
  EXPECT_EQ(document["round_count"], 1);
  EXPECT_EQ(document["primary_ray_count"], 1024);
  EXPECT_EQ(document["random_ray_count"], 1024);
  const auto aoRayCount = document["ao_ray_count"].get<std::uint64_t>();
  EXPECT_GT(aoRayCount, 100u) << "the camera shows the model";
  EXPECT_LT(aoRayCount, 1024u) << "all of it";
  ASSERT_EQ(document["presets"].size(), presets.size());
  for (std::size_t i = 0; i < presets.size(); ++i) {
    const json& figures = document["presets"][i];
    const auto tree = buildTree(mesh_.view(), presets[i].second);
    const TreeStatistics expected = tree.statistics();
    EXPECT_EQ(figures["name"], presets[i].first);
    EXPECT_EQ(figures["tree"]["leaf_node_count"], expected.leafNodeCount);
    EXPECT_EQ(figures["tree"]["sah_cost"].get<double>(), expected.sahCost);
    const CostModel costs;
    EXPECT_EQ(
        figures["comparable_sah_cost"].get<double>(),
        treeStatistics(tree.nodes(), tree.bounds(), {costs.traversalCost, costs.faceCost}).sahCost);
    EXPECT_GT(figures["build_seconds"].get<double>(), 0.0);
    EXPECT_LE(figures["build_seconds"].get<double>(),
              figures["build"]["total_seconds"].get<double>());
    EXPECT_GE(figures["leaf_node_steps"].get<double>(), 0.1);
    EXPECT_GT(figures["object_steps"].get<double>(), 0.1);
    for (const char* key :
         {"primary_mrays_per_second", "ao_mrays_per_second", "random_mrays_per_second"})
      EXPECT_GT(figures[key].get<double>(), 0.0) << key;
  }
}

TEST_F(Compare, EveryKeyOfTheJsonIsInTheDocs) {
  std::ifstream file(std::string(PLANETREE_REPOSITORY) + "/docs/command_line.md");
  const std::string docs{std::istreambuf_iterator<char>(file), {}};
  const json document = json::parse(compare({"--json"}).out);
  for (const json& keys : {document, document["presets"][0]}) {
    for (const auto& entry : keys.items()) {
      EXPECT_NE(docs.find(std::string("`").append(entry.key()).append("`")), std::string::npos)
          << entry.key();
    }
  }
}

TEST_F(Compare, TheSheetHasTwoPicturesForEachPreset) {
  const auto sheetOf = [&](const char* presets) {
    const ToolResult result = compare({"--presets", presets, "-o", "sheet.png", "--size", "200x100",
                                       "--samples", "1", "--heat-max", "50"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("wrote sheet.png ("), std::string::npos) << result.err;
    EXPECT_NE(result.out.find("SAH cost"), std::string::npos) << "the table is printed as well";
    const auto sheet = readPng(readFile("sheet.png"));
    EXPECT_TRUE(sheet);
    return sheet ? sheet->image.size : render::ImageSize{};
  };
  const auto one = sheetOf("fast");
  const auto three = sheetOf("fast,balanced,textbook");
  EXPECT_GE(one.width, 400u);
  EXPECT_GE(one.height, 100u);
  const std::uint32_t rowHeight = (three.height - one.height) / 2;
  EXPECT_GE(rowHeight, 110u) << "a picture and its label";
  EXPECT_LE(rowHeight, 180u);
}

TEST_F(Compare, TheSheetSaysHowItWasMade) {
  ASSERT_EQ(compare({"-o", "sheet.png", "--size", "40x30", "--samples", "2", "--heat-max", "50",
                     "--presets", "fast,textbook"})
                .status,
            0);
  const auto texts = textsOfSheet();
  EXPECT_EQ(texts.at("Software").rfind("planetree ", 0), 0u);
  EXPECT_EQ(texts.at("Model"), "soup.obj");
  EXPECT_EQ(texts.at("Triangles"), "500");
  EXPECT_EQ(texts.at("Mode"), "ao");
  EXPECT_EQ(texts.at("Samples"), "2");
  EXPECT_NE(texts.at("Tree Options of textbook").find("--face-cost 1"), std::string::npos);
  EXPECT_NE(texts.at("Tree of fast").find(" split nodes, "), std::string::npos);
  EXPECT_NE(texts.at("Range").find("pale yellow 50 "), std::string::npos) << texts.at("Range");

  const std::string& command = texts.at("Command");
  EXPECT_EQ(command.rfind("planetree compare soup.obj --mode ao --size 40x30 --samples 2 ", 0), 0u)
      << command;
  std::istringstream words(command);
  std::vector<std::string> again{std::istream_iterator<std::string>(words), {}};
  again.erase(again.begin());
  ASSERT_EQ(run(again).status, 0) << command;
  EXPECT_EQ(textsOfSheet(), texts) << "the command makes it again";
}

/// A mirroring sphere on a square, lit, with a camera whose pictures are wide.
constexpr const char* kRayScene = R"(SBT-raytracer 1.0
camera { position = (0, 1, 6); viewdir = (0, 0, -1); updir = (0, 1, 0); fov = 40; aspectratio = 2; }
ambient_light { color = (0.3, 0.3, 0.3); }
directional_light { direction = (0, -1, -1); color = (0.7, 0.7, 0.7); }
translate(0, 1, 0, sphere { material = { diffuse = (0.5, 0, 0); reflective = (0.3, 0.3, 0.3); }; })
rotate(1, 0, 0, -1.5708, scale(8, 8, 1, square { material = { diffuse = (0, 0.5, 0); }; }))
)";

constexpr const char* kJsonScene = R"({
  "camera": {"position": [0, 1, 6], "look_at": [0, 1, 0], "fov": 40, "aspect_ratio": 2},
  "ambient_light": [0.5, 0.5, 0.5],
  "materials": {"red": {"diffuse": [0.5, 0, 0]}},
  "shapes": [{"type": "sphere", "material": "red", "position": [0, 1, 0]},
             {"type": "sphere", "material": "red", "position": [1, 0, 0]}]
})";

TEST_F(Compare, ScenesAreDrawnWithTheirMaterialsAndTheirCamera) {
  writeFile("scene.ray", kRayScene);
  writeFile("scene.json", kJsonScene);
  for (const char* scene : {"scene.ray", "scene.json"}) {
    const ToolResult result = compareSubject({scene, "-o", "sheet.png", "--size", "40", "--samples",
                                              "1", "--ray-depth", "2", "--presets", "fast,high"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("scene"), std::string::npos);
    EXPECT_NE(result.out.find(" (2 objects)\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\n  objects "), std::string::npos) << result.out;
    const auto texts = textsOfSheet();
    EXPECT_EQ(texts.at("Objects"), "2");
    EXPECT_EQ(texts.at("Mode"), "whitted");
    EXPECT_NE(texts.at("Camera").find("look "), std::string::npos) << texts.at("Camera");
    const std::string& command = texts.at("Command");
    for (const char* part : {" --size 40x20 ", " --ray-depth 2 ", " --samples 1 "})
      EXPECT_NE(command.find(part), std::string::npos) << command;
  }
}

TEST_F(Compare, CostsOfScenesAreThoseOfTheirObjects) {
  writeFile("scene.ray", kRayScene);
  const ToolResult result =
      compareSubject({"scene.ray", "--json", "--presets", "balanced,textbook"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json document = json::parse(result.out);
  EXPECT_TRUE(document["mesh"].is_null());
  EXPECT_EQ(document["scene"]["shape_count"], 2);
  const json& balanced = document["presets"][0];
  EXPECT_EQ(balanced["comparable_sah_cost"], balanced["tree"]["sah_cost"])
      << "spheres and squares do not cost what faces do";
}

TEST_F(Compare, WithoutAModelItIsTheStillLife) {
  const ToolResult result = compareSubject({"--presets", "fast", "-o", "sheet.png", "--size",
                                            "40x30", "--samples", "1", "--show-cells", "3"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.rfind("still life (", 0), 0u) << result.out;
  EXPECT_NE(textsOfSheet().at("Command").find(" --show-cells 3 "), std::string::npos);
}

TEST_F(Compare, TheSheetMayGoToStandardOutput) {
  const ToolResult result =
      compare({"-o", "-", "--json", "--size", "40x30", "--samples", "1", "--presets", "fast"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.rfind("\x89PNG", 0), 0u);
  EXPECT_EQ(json::parse(result.err)["picture"], "-");
}

TEST_F(Compare, IsSilentWhenAskedTo) {
  const ToolResult result = compare({"-q", "-o", "sheet.png", "--size", "40x30", "--samples", "1"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
}

/// A command line that is refused, and what the message must name.
struct RefusedComparison {
  std::vector<std::string> arguments;
  int status = 2;
  std::string named;
};

void PrintTo(const RefusedComparison& refused, std::ostream* out) {
  for (const std::string& argument : refused.arguments)
    *out << argument << ' ';
}

class CompareRefusal : public Compare, public testing::WithParamInterface<RefusedComparison> {};

TEST_P(CompareRefusal, IsOneLineThatNamesTheCulprit) {
  writeFile("points.obj", "v 0 0 0\nv 1 0 0\n");
  writeFile("flat.obj", "v 0 0 0\nv 1 0 0\nf 1 1 2\n");
  const std::vector<std::string> before = filesInFolder();
  std::vector<std::string> arguments = GetParam().arguments;
  arguments.insert(arguments.begin(), "compare");
  const ToolResult result = run(std::move(arguments));
  EXPECT_EQ(result.status, GetParam().status);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find(GetParam().named), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_EQ(filesInFolder(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Usage, CompareRefusal,
    testing::Values(
        RefusedComparison{{"soup.obj", "--presets", "quick"}, 2, "--presets quick"},
        RefusedComparison{{"soup.obj", "--presets", "fast,,high"}, 2, "--presets"},
        RefusedComparison{{"soup.obj", "--presets", "fast,"}, 2, "--presets"},
        RefusedComparison{{"soup.obj", "--presets", "fast,high,fast"}, 2, "fast is there twice"},
        RefusedComparison{{"soup.obj", "--rounds", "0"}, 2, "--rounds 0"},
        RefusedComparison{{"soup.obj", "-o", "sheet.exr"}, 2, "sheet.exr"},
        RefusedComparison{{"soup.obj", "-o", "soup.obj"}, 2, "soup.obj"},
        RefusedComparison{{"soup.obj", "--heat-max", "9"}, 2, "--heat-max"},
        RefusedComparison{{"soup.obj", "-o", "a.png", "--size", "8192x8192"}, 2, "--size"},
        RefusedComparison{{"soup.obj", "-o", "a.png", "--ray-depth", "2"}, 2, "--ray-depth"},
        RefusedComparison{{"soup.obj", "-o", "a.png", "--show-cells", "60"}, 2, "--show-cells 60"},
        RefusedComparison{{"--mode", "whitted"}, 2, "still life has no materials"},
        RefusedComparison{{"soup.obj", "-o", "no/folder.png"}, 1, "no/folder.png"},
        RefusedComparison{{"missing.obj"}, 1, "missing.obj"},
        RefusedComparison{{"points.obj"}, 1, "no triangles"},
        RefusedComparison{{"flat.obj"}, 1, "none of which can be hit"},
        RefusedComparison{{"soup.obj", "--memory-limit", "1k"}, 1, "memory"}));

}  // namespace
}  // namespace planetree::test
