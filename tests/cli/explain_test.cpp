#include "trace_test.hpp"

#include <planetree/build_tree.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>
#include <sstream>

namespace planetree::test {
namespace {

using nlohmann::json;

template <class T>
std::string rayText(const Ray<T>& ray) {
  std::string text;
  for (const T number : {ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y,
                         ray.direction.z, ray.tMin})
    text += textOf(number) + ',';
  return text + textOf(ray.tMax);
}

/// In a folder with a roof of two triangles, roof.obj, and a heap of them, soup.obj.
class Explain : public ToolTest {
 protected:
  Explain() {
    writeModel("roof.obj");
    writeFile("soup.obj", objOf(mesh_));
  }

  [[nodiscard]] ToolResult explain(const std::string& model, const std::string& ray,
                                   std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"explain", model, "--ray", ray, "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(std::move(arguments));
  }

  TriangleMesh<float> mesh_ = randomMesh<float>(6, 500);
};

TEST_F(Explain, TellsTheHitOfARay) {
  const ToolResult result = explain("roof.obj", "0.25,0.5,2,0,0,-1");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(
      result.out,
      "ray     from (0.25, 0.5, 2)\n"
      "        along (0, 0, -1)\n"
      "        t from 0 to inf\n"
      "bounds  from (0, 0, 0)\n"
      "        to (1, 1, 0.5)\n"
      "\n"
      "It enters the bounds at t = 1.5 and leaves them at t = 2.\n"
      "Brackets hold the part of the ray in a cell. What is indented happens in the near cell.\n"
      "\n"
      "level      node\n"
      "    1         0  leaf of 2 [1.5, 2]: 0 no, 1 hit at 1.75\n"
      "\n"
      "hit     triangle 1 at t = 1.75\n"
      "        u 0.25, v 0.25\n"
      "point   (0.25, 0.5, 0.25)\n"
      "normal  (0, -0.4472136, 0.8944272)\n"
      "\n"
      "0 splits, 1 leaf (0 empty), 2 triangles tested, 0 nodes left out\n");
}

TEST_F(Explain, TellsOfRaysThatMiss) {
  const ToolResult beside = explain("roof.obj", "5,5,5,0,0,1");
  EXPECT_EQ(beside.status, 0);
  EXPECT_NE(beside.out.find("does not meet the bounds"), std::string::npos) << beside.out;
  EXPECT_NE(beside.out.find("no hit\n"), std::string::npos) << beside.out;

  const ToolResult tooShort = explain("roof.obj", "0.25,0.5,2,0,0,-1,0,1");
  EXPECT_NE(tooShort.out.find("does not meet the bounds"), std::string::npos) << tooShort.out;

  const ToolResult over = explain("roof.obj", "0.25,1.5,0.3,0,-1,0");
  EXPECT_EQ(over.status, 0);
}

TEST_F(Explain, TellsOfRaysThatBeginAndEndInside) {
  const ToolResult result = explain("roof.obj", "0.5,0.5,0.4,0,0,-1,0,0.25");
  EXPECT_NE(result.out.find("It begins inside the bounds at t = 0 and ends inside at t = 0.25."),
            std::string::npos)
      << result.out;
}

TEST_F(Explain, JsonAgreesWithTheQueriesOfTheLibrary) {
  const auto tree = buildTree(mesh_.view());
  std::size_t hitCount = 0;
  for (Ray<float> ray : randomRays<float>(7, 40)) {
    if (!isFinite(ray.origin) || ray.direction == Vec3f{})
      continue;
    StepCounts counts;
    const auto expected = tree.findIntersection(ray, counts);
    const ToolResult result = explain("soup.obj", rayText(ray), {"--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const json walk = json::parse(result.out);
    EXPECT_EQ(walk["query"], "closest");
    EXPECT_EQ(walk["precision"], "float");
    EXPECT_EQ(walk["ray"]["origin"][1].get<float>(), ray.origin.y);
    EXPECT_EQ(walk["ray"]["t_max"].is_null(), ray.tMax == std::numeric_limits<float>::infinity());
    EXPECT_EQ(walk["split_count"], counts.splitNodes);
    EXPECT_EQ(walk["leaf_count"], counts.leafNodes);
    EXPECT_EQ(walk["tested_count"], counts.objects);
    ASSERT_EQ(walk["hit"].is_null(), !expected.has_value());
    if (!expected)
      continue;
    ++hitCount;
    EXPECT_EQ(walk["hit"]["t"].get<float>(), expected->t);
    EXPECT_EQ(walk["hit"]["primitive"], expected->primitive);
    EXPECT_EQ(walk["hit"]["u"].get<float>(), expected->u);
    EXPECT_EQ(walk["hit"]["v"].get<float>(), expected->v);
    EXPECT_EQ(walk["hit"]["normal"][2].get<float>(), expected->normal.z);
  }
  EXPECT_GT(hitCount, 0u);
}

TEST_F(Explain, JsonHasEveryStep) {
  const Ray<float> ray{.origin = {-2, 0.1f, 0.05f}, .direction = {1, 0.02f, 0.01f}};
  const Walk<float> expected = buildTree(mesh_.view()).explainIntersection(ray);
  const json steps = json::parse(explain("soup.obj", rayText(ray), {"--json"}).out)["steps"];
  ASSERT_EQ(steps.size(), expected.steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const json& step = steps[i];
    const NodeVisit<float> visit =
        std::visit([](const auto& each) { return each.visit; }, expected.steps[i]);
    EXPECT_EQ(step["node"], visit.node);
    EXPECT_EQ(step["level"], visit.level);
    EXPECT_EQ(step["interval"][0].get<float>(), visit.part.tMin);
    EXPECT_EQ(step["interval"][1].get<float>(), visit.part.tMax);
    if (const auto* split = std::get_if<SplitStep<float>>(&expected.steps[i])) {
      EXPECT_EQ(step["kind"], "split");
      EXPECT_EQ(step["axis"], axisName(split->axis));
      EXPECT_EQ(step["position"].get<float>(), split->position);
      EXPECT_EQ(step["near_side"], split->leftIsNear ? "left" : "right");
      EXPECT_EQ(step["near"].is_null(), !split->nearPart.has_value());
      EXPECT_EQ(step["far"].is_null(), !split->farPart.has_value());
    } else if (const auto* leaf = std::get_if<LeafStep<float>>(&expected.steps[i])) {
      EXPECT_EQ(step["kind"], "leaf");
      EXPECT_EQ(step["object_count"], leaf->objectCount);
      ASSERT_EQ(step["tests"].size(), leaf->tests.size());
      for (std::size_t k = 0; k < leaf->tests.size(); ++k) {
        EXPECT_EQ(step["tests"][k]["primitive"], leaf->tests[k].primitive);
        EXPECT_EQ(step["tests"][k]["t"].is_null(), !leaf->tests[k].hit.has_value());
        EXPECT_EQ(step["tests"][k]["is_accepted"], leaf->tests[k].isAccepted);
      }
    } else {
      EXPECT_EQ(step["kind"], "left_out");
    }
  }
}

TEST_F(Explain, StopsAtAnyHitWhenAskedTo) {
  const std::string ray = "-2,0.1,0.05,1,0.02,0.01";
  // Small leaves, so that something is left to do behind the first hit.
  const json nearest = json::parse(explain("soup.obj", ray, {"--json", "--face-cost", "1"}).out);
  const json any =
      json::parse(explain("soup.obj", ray, {"--json", "--any", "--face-cost", "1"}).out);
  EXPECT_EQ(any["query"], "any");
  EXPECT_FALSE(any["hit"].is_null());
  EXPECT_LE(any["tested_count"], nearest["tested_count"]);
  const ToolResult page = explain("soup.obj", ray, {"--any", "--face-cost", "1"});
  EXPECT_NE(page.out.find("any hit is enough"), std::string::npos) << page.out;
}

TEST_F(Explain, ToldHitsAreThoseThatTheOptionsAccept) {
  const std::string middle = "0.5,0.5,2,0,0,-1";
  const auto hitOf = [&](const std::string& ray, std::vector<std::string> options) {
    options.emplace_back("--json");
    return json::parse(explain("roof.obj", ray, options).out)["hit"];
  };
  EXPECT_EQ(hitOf(middle, {})["primitive"], 0);
  EXPECT_EQ(hitOf(middle, {"--skip", "0"})["primitive"], 1);
  EXPECT_EQ(hitOf(middle, {"--culls-back-faces"})["primitive"], 0);
  EXPECT_TRUE(hitOf("0.5,0.5,-2,0,0,1", {"--culls-back-faces", "--any"}).is_null());
  EXPECT_FALSE(hitOf(middle, {"--crossings"}).is_null());
}

TEST_F(Explain, WorksInDouble) {
  const json walk =
      json::parse(explain("roof.obj", "0.25,0.5,1e200,0,0,-1e200", {"--double", "--json"}).out);
  EXPECT_EQ(walk["precision"], "double");
  EXPECT_EQ(walk["ray"]["origin"][2].get<double>(), 1e200);
  const json hit = json::parse(explain("roof.obj", "0.1,0.5,2,0,0,-1", {"--double", "--json"}).out);
  EXPECT_EQ(hit["ray"]["origin"][0].get<double>(), 0.1);
  EXPECT_EQ(hit["hit"]["t"].get<double>(), 1.75);
}

TEST_F(Explain, TakesLimitsFromTheRayBeforeThoseOfTheOptions) {
  const std::vector<std::string> options = {"--t-min", "1", "--t-max", "3", "--json"};
  const json without = json::parse(explain("roof.obj", "0.25,0.5,2,0,0,-1", options).out)["ray"];
  EXPECT_EQ(without["t_min"], 1.0);
  EXPECT_EQ(without["t_max"], 3.0);
  const json with =
      json::parse(explain("roof.obj", "0.25,0.5,2,0,0,-1,-5,inf", options).out)["ray"];
  EXPECT_EQ(with["t_min"], -5.0);
  EXPECT_TRUE(with["t_max"].is_null());
}

TEST_F(Explain, NamesTheFaceOfTheFileThatATriangleWasCutFrom) {
  writeFile("quads.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 2 3 4\n");
  const ToolResult page = explain("quads.obj", "0.2,0.8,1,0,0,-1");
  EXPECT_NE(page.out.find("triangle 2 (face 1 of the file) at t = 1\n"), std::string::npos)
      << page.out;
}

TEST_F(Explain, PagesAreAtMostAHundredColumnsWide) {
  for (const Ray<double>& ray : randomRays<double>(8, 40)) {
    if (!isFinite(ray.origin) || ray.direction == Vec3d{})
      continue;
    for (const char* preset : {"fast", "balanced", "high", "textbook"}) {
      const ToolResult result = explain("soup.obj", rayText(ray), {"--preset", preset, "--double"});
      ASSERT_EQ(result.status, 0) << result.err;
      std::istringstream lines(result.out);
      for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 100u) << line;
    }
  }
}

TEST_F(Explain, ARayInASplitPlaneVisitsBothSides) {
  // The walls of soup's first split: a ray in that plane, across the whole model.
  const auto tree = buildTree(mesh_.view(), {.leafSize = 4, .cost = {.faceCost = 1.0}});
  ASSERT_FALSE(tree.root().isLeaf());
  const SplitNode& split = tree.root().split();
  Ray<float> ray{.origin = {0.1f, 0.1f, 0.1f}, .direction = {0, 0, 0}};
  const Axis along = split.axis() == Axis::Z ? Axis::X : Axis::Z;
  ray.origin[split.axis()] = split.position();
  ray.origin[along] = -3.0f;
  ray.direction[along] = 1.0f;
  const std::string walk = explain("soup.obj", rayText(ray), {"--json", "--face-cost", "1"}).out;
  const json step = json::parse(walk)["steps"].at(0);
  EXPECT_EQ(step["near"], step["interval"]);
  EXPECT_EQ(step["far"], step["interval"]);
}

TEST_F(Explain, TalksOnStandardErrorUnlessAskedNotTo) {
  const ToolResult result = run({"explain", "roof.obj", "--ray", "0.25,0.5,2,0,0,-1"});
  EXPECT_NE(result.err.find("roof.obj: 2 triangles"), std::string::npos) << result.err;
  EXPECT_EQ(result.out, explain("roof.obj", "0.25,0.5,2,0,0,-1").out);
}

/// A command line that is refused, and what the message must name.
struct RefusedExplain {
  std::vector<std::string> arguments;
  int status = 2;
  std::string named;
};

void PrintTo(const RefusedExplain& refused, std::ostream* out) {
  for (const std::string& argument : refused.arguments)
    *out << argument << ' ';
}

class ExplainRefusal : public Explain, public testing::WithParamInterface<RefusedExplain> {};

TEST_P(ExplainRefusal, IsOneLineThatNamesTheCulprit) {
  std::vector<std::string> arguments = GetParam().arguments;
  arguments.insert(arguments.begin(), {"explain", "--quiet"});
  const ToolResult result = run(arguments);
  EXPECT_EQ(result.status, GetParam().status);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("planetree: ", 0), 0u) << result.err;
  EXPECT_NE(result.err.find(GetParam().named), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
}

RefusedExplain refusedRay(const std::string& ray, const std::string& named) {
  return {{"roof.obj", "--ray", ray}, 2, named};
}

INSTANTIATE_TEST_SUITE_P(Rays, ExplainRefusal,
                         testing::Values(refusedRay("", "not a number"),
                                         refusedRay("0,0,5", "3 numbers"),
                                         refusedRay("0,0,5,0,0,-1,0", "7 numbers"),
                                         refusedRay("0,0,5,0,0,-1,0,1,2", "9 numbers"),
                                         refusedRay("0,0,5,0,0,-1,", "not a number"),
                                         refusedRay("0,0,5,0,0,x", "\"x\" is not a number"),
                                         refusedRay("0,0,5 0,0,0,1", "\"5 0\" is not a number"),
                                         refusedRay("0,0,0x5,0,0,1", "\"0x5\" is not a number"),
                                         refusedRay("0,nan,5,0,0,-1", "not finite"),
                                         refusedRay("0,0,inf,0,0,-1", "not finite"),
                                         refusedRay("0,0,1e39,0,0,-1", "--double"),
                                         refusedRay("0,0,5,0,0,-inf", "not finite"),
                                         refusedRay("0,0,5,0,-0,0", "direction is zero"),
                                         refusedRay("0,0,5,0,0,-1,nan,1", "not a number"),
                                         refusedRay("0,0,5,0,0,-1,2,1", "begins at t = 2")));

INSTANTIATE_TEST_SUITE_P(
    Arguments, ExplainRefusal,
    testing::Values(
        RefusedExplain{{"roof.obj"}, 2, "--ray"},
        RefusedExplain{{"--ray", "0,0,5,0,0,-1"}, 2, "MODEL"},
        RefusedExplain{
            {"roof.obj", "--ray", "0,0,5,0,0,-1", "--t-min", "3", "--t-max", "2"}, 2, "t"},
        RefusedExplain{{"missing.obj", "--ray", "0,0,5,0,0,-1"}, 1, "missing.obj"}));

}  // namespace
}  // namespace planetree::test
