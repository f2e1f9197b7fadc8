#include "trace_test.hpp"

#include "support/brute_force.hpp"
#include "support/brute_force_hits.hpp"

#include <planetree/build_tree.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace planetree::test {
namespace {

using Json = nlohmann::json;
using Trace = TraceTest;

TEST_F(Trace, WritesATableOfHitsToStandardOutput) {
  const ToolResult result = trace({"rays.csv"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, kTwoHits);
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"rays.csv", "roof.obj"}));
}

TEST_F(Trace, WritesATableOfHitsToAFile) {
  for (const char* option : {"-o", "--output"}) {
    const ToolResult result = trace({"rays.csv", option, "hits.csv"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(readFile("hits.csv"), kTwoHits);
    writeFile("hits.csv", "older hits");
  }
}

TEST_F(Trace, DashesAreTheStandardStreams) {
  const ToolResult result = run(ToolStart{.arguments = {"trace", "roof.obj", "-", "-o", "-", "-q"},
                                          .standardInput = (folder() / "rays.csv").string()});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, kTwoHits);
}

TEST_F(Trace, TakesTheModelFromStandardInputToo) {
  const ToolResult result = run(ToolStart{.arguments = {"trace", "-", "rays.csv", "-q"},
                                          .standardInput = (folder() / "roof.obj").string()});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, kTwoHits);
}

TEST_F(Trace, SaysWhatItDidOnStandardError) {
  writeFile("more.csv", std::string(kTwoRays) + "nan,0,0,0,0,1\n0,0,0,0,0,0\n");
  const ToolResult result = trace({"more.csv", "-o", "hits.csv"});
  for (const char* said :
       {"roof.obj: 2 triangles", "tree of 2 triangles", "traced 4 rays in float, 1 hit,",
        "million rays per second", "2 rays can hit nothing", "wrote hits.csv ("}) {
    EXPECT_NE(result.err.find(said), std::string::npos) << said << "\n" << result.err;
  }
}

TEST_F(Trace, QuietSaysNothing) {
  for (const char* option : {"-q", "--quiet"}) {
    const ToolResult result = trace({"rays.csv", option});
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out, kTwoHits);
  }
}

TEST_F(Trace, AnyTellsOnlyWhetherThereIsAHit) {
  EXPECT_EQ(trace({"rays.csv", "--any"}).out, "hit\n1\n0\n");
  EXPECT_EQ(trace({"rays.csv", "--any", "-o", "hits.npy"}).status, 0);
  const std::string npy = readFile("hits.npy");
  EXPECT_NE(npy.find("[('hit', '|b1')]"), std::string::npos);
  EXPECT_NE(npy.find("'shape': (2,)"), std::string::npos);
  EXPECT_EQ(npy.substr(npy.size() - 2), std::string("\1\0", 2));
}

TEST_F(Trace, AllHasARowForEachHitAndNoneForAMiss) {
  // The middle of the roof is on an edge of both triangles.
  writeFile("three.csv", "5,5,5,0,0,1\n0.5,0.5,2,0,0,-1\n0.25,0.5,2,0,0,-1\n");
  const ToolResult result = trace({"three.csv", "--all"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out,
            "ray,t,geometry,primitive,u,v,nx,ny,nz\n"
            "1,1.75,0,0,-0,0.5,0,-0.4472136,0.8944272\n"
            "1,1.75,0,1,0.5,-0,0,-0.4472136,0.8944272\n"
            "2,1.75,0,1,0.25,0.25,0,-0.4472136,0.8944272\n");
  EXPECT_NE(result.err.find("traced 3 rays in float, 2 hit,"), std::string::npos) << result.err;
}

TEST_F(Trace, AllAgreesWithBruteForceInEveryFormatAndBlock) {
  const TriangleMesh<float> mesh = randomMesh<float>(5, 120);
  writeFile("heap.obj", objOf(mesh));
  const auto rays = randomRays<float>(6, 9'000);
  writeFile("many.csv", csvOf(rays));
  writeFile("many.npy", npyOf(rays));
  const auto tree = buildTree(mesh.view());
  std::string expected = "ray,t,geometry,primitive,u,v,nx,ny,nz\n";
  std::vector<Hitf> hits;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto found = bruteForceHits(tree, rays[i]);
    hits.insert(hits.end(), found.begin(), found.end());
    const std::string rows = csvOf(found);
    for (std::size_t at = rows.find('\n') + 1; at < rows.size();) {
      const std::size_t end = rows.find('\n', at) + 1;
      expected += textOf(i) + ',' + rows.substr(at, end - at);
      at = end;
    }
  }
  for (const char* name : {"many.csv", "many.npy"}) {
    EXPECT_EQ(run({"trace", "heap.obj", name, "--all", "--format", "csv", "-q"}).out, expected);
    ASSERT_EQ(run({"trace", "heap.obj", name, "--all", "-o", "all.npy", "-q"}).status, 0);
    const std::string npy = readFile("all.npy");
    EXPECT_NE(npy.find("[('ray', '<i8'), ('t', '<f4'), "), std::string::npos);
    EXPECT_NE(npy.find("'shape': (" + textOf(hits.size()) + ",)"), std::string::npos);
    EXPECT_EQ(npy.size() % 64, (hits.size() * 40) % 64) << "whole records behind the header";
  }
}

TEST_F(Trace, ChoicesLeaveOutHits) {
  writeFile("one.csv", "0.5,0.5,2,0,0,-1\n");
  const auto rowCount = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"one.csv", "--all"});
    const std::string table = trace(options).out;
    return std::count(table.begin(), table.end(), '\n') - 1;
  };
  EXPECT_EQ(rowCount({}), 2);
  EXPECT_EQ(rowCount({"--skip", "0"}), 1);
  EXPECT_EQ(rowCount({"--skip", "7"}), 2);
  EXPECT_EQ(rowCount({"--crossings"}), 1);
  EXPECT_EQ(rowCount({"--culls-back-faces"}), 2);
  writeFile("one.csv", "0.5,0.5,-2,0,0,1\n");
  EXPECT_EQ(rowCount({"--culls-back-faces"}), 0);
  EXPECT_EQ(rowCount({"--crossings", "--double"}), 1);
}

TEST_F(Trace, AllAndAnyExcludeEachOther) {
  const ToolResult result = trace({"rays.csv", "--all", "--any"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("--any and --all"), std::string::npos) << result.err;
}

TEST_F(Trace, TheFormatIsThatOfTheRaysUnlessTheNameOrTheOptionSaysOtherwise) {
  const std::string magic = "\x93NUMPY";
  const Rayf down{.origin = {0.25f, 0.5f, 2}, .direction = {0, 0, -1}};
  const Rayf away{.origin = {5, 5, 5}, .direction = {0, 0, 1}};
  const std::vector<Rayf> rays = {down, away};
  writeFile("rays.npy", npyOf(rays));
  EXPECT_EQ(trace({"rays.npy", "-q"}).out.substr(0, 6), magic);
  EXPECT_EQ(trace({"rays.npy", "--format", "csv"}).out, kTwoHits);
  EXPECT_EQ(trace({"rays.csv", "-q", "--format", "npy"}).out, trace({"rays.npy"}).out);
  EXPECT_EQ(trace({"rays.csv", "-o", "hits.npy"}).status, 0);
  EXPECT_EQ(readFile("hits.npy"), trace({"rays.npy"}).out);
  EXPECT_EQ(trace({"rays.npy", "-o", "hits.CSV"}).status, 0);
  EXPECT_EQ(readFile("hits.CSV"), kTwoHits);
  EXPECT_EQ(trace({"rays.npy", "-o", "hits.dat"}).status, 0);
  EXPECT_EQ(readFile("hits.dat").substr(0, 6), magic);
  EXPECT_EQ(trace({"rays.csv", "-o", "hits.dat", "--format", "npy"}).status, 0);
  EXPECT_EQ(readFile("hits.dat").substr(0, 6), magic);
}

TEST_F(Trace, NoRaysHaveNoHits) {
  writeFile("none.csv", "ox,oy,oz,dx,dy,dz\n");
  EXPECT_EQ(trace({"none.csv"}).out, "t,geometry,primitive,u,v,nx,ny,nz\n");
  writeFile("none.npy", npyOf(std::vector<Rayf>{}));
  const ToolResult result = trace({"none.npy"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("'shape': (0,)"), std::string::npos);
  EXPECT_TRUE(hitsOfNpy<float>(result.out).empty());
}

TEST_F(Trace, InvalidRaysAreMisses) {
  writeFile("odd.csv",
            "nan,0,2,0,0,-1\n0.25,0.5,2,0,0,0\n0.25,0.5,2,0,nan,-1\ninf,0,2,0,0,-1\n"
            "0.25,0.5,2,0,0,-inf\n1e999,0,0,1,0,0\n");
  const ToolResult result = trace({"odd.csv", "--any", "-q"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "hit\n0\n0\n0\n0\n0\n0\n");
}

/// Traces the same rays in all formats and compares with the library and with brute force.
template <class T>
void expectHitsOfTheLibrary(const std::vector<Ray<T>>& rays, const TriangleMesh<T>& mesh,
                            const std::string& csv, const std::string& npy,
                            const std::string& any) {
  const auto tree = buildTree(mesh.view());
  std::vector<Hit<T>> hits;
  std::string occlusions = "hit\n";
  for (const Ray<T>& ray : rays) {
    const auto hit = tree.findIntersection(ray);
    ASSERT_EQ(hit, bruteForce(tree, ray));
    hits.push_back(hit.value_or(Hit<T>{}));
    occlusions += tree.isOccluded(ray) ? "1\n" : "0\n";
  }
  EXPECT_EQ(csv, csvOf(hits));
  EXPECT_EQ(hitsOfNpy<T>(npy), hits);
  EXPECT_EQ(any, occlusions);
}

TEST_F(Trace, FindsWhatSingleQueriesAndBruteForceFind) {
  const auto mesh = randomMesh<float>(11, 60);
  const auto rays = randomRays<float>(12, 3000);
  writeFile("heap.obj", objOf(mesh));
  writeFile("heap.csv", csvOf(rays));
  writeFile("heap.npy", npyOf(rays));
  const auto traceHeap = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"trace", "heap.obj", "-q"});
    return run(std::move(arguments)).out;
  };
  for (const char* name : {"heap.csv", "heap.npy"}) {
    expectHitsOfTheLibrary<float>(rays, mesh, traceHeap({name, "--format", "csv"}),
                                  traceHeap({name, "--format", "npy"}),
                                  traceHeap({name, "--format", "csv", "--any"}));
  }
}

TEST_F(Trace, FindsInDoubleWhatTheLibraryFinds) {
  const auto mesh = randomMesh<double>(21, 60);
  const auto rays = randomRays<double>(22, 3000);
  writeFile("heap.obj", objOf(mesh));
  writeFile("heap.csv", csvOf(rays));
  writeFile("heap.npy", npyOf(rays));
  const auto traceHeap = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"trace", "heap.obj", "-q"});
    return run(std::move(arguments)).out;
  };
  expectHitsOfTheLibrary<double>(rays, mesh, traceHeap({"heap.npy", "--format", "csv"}),
                                 traceHeap({"heap.npy"}),
                                 traceHeap({"heap.npy", "--format", "csv", "--any"}));
  expectHitsOfTheLibrary<double>(rays, mesh, traceHeap({"heap.csv", "--double"}),
                                 traceHeap({"heap.csv", "--double", "--format", "npy"}),
                                 traceHeap({"heap.csv", "--double", "--any"}));
}

TEST_F(Trace, DoubleIsMoreThanFloat) {
  writeFile("third.obj",
            "v -1 -1 0.3333333333333333\nv 3 -1 0.3333333333333333\n"
            "v -1 3 0.3333333333333333\nf 1 2 3\n");
  const Rayd ray{.origin = {0, 0, 1}, .direction = {0, 0, -1}};
  const std::vector<Rayd> rays = {ray};
  writeFile("up.npy", npyOf(rays));
  writeFile("up.csv", csvOf(rays));
  const auto t = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"trace", "third.obj", "-q", "--format", "csv"});
    const std::string out = run(std::move(arguments)).out;
    const std::size_t line = out.find('\n') + 1;
    return out.substr(line, out.find(',', line) - line);
  };
  EXPECT_EQ(t({"up.npy"}), textOf(1.0 - 0.3333333333333333));
  EXPECT_EQ(t({"up.csv", "--double"}), textOf(1.0 - 0.3333333333333333));
  EXPECT_EQ(t({"up.csv"}), textOf(1.0f - 0.3333333333333333f));
  const Rayf rounded{.origin = Vec3f(ray.origin), .direction = Vec3f(ray.direction)};
  const std::vector<Rayf> floats = {rounded};
  writeFile("float.npy", npyOf(floats));
  EXPECT_EQ(t({"float.npy"}), textOf(1.0f - 0.3333333333333333f));
  EXPECT_EQ(t({"float.npy", "--double"}), textOf(1.0 - 0.3333333333333333));
}

TEST_F(Trace, ThreadsAndBuildOptionsDoNotChangeTheHits) {
  writeFile("heap.obj", objOf(randomMesh<float>(31, 200)));
  // Several blocks, so that they can overtake each other.
  writeFile("heap.npy", npyOf(randomRays<float>(32, 40'000)));
  const std::string expected = run({"trace", "heap.obj", "heap.npy", "-q"}).out;
  const std::vector<std::vector<std::string>> options = {{"--threads", "1"},
                                                         {"--threads", "7"},
                                                         {"--preset", "textbook"},
                                                         {"--leaf-size", "1"},
                                                         {"--depth-limit", "2"}};
  for (std::vector<std::string> arguments : options) {
    arguments.insert(arguments.begin(), {"trace", "heap.obj", "heap.npy", "-q"});
    EXPECT_TRUE(run(arguments).out == expected) << arguments.back();
  }
}

TEST_F(Trace, BuildOptionsReachTheTree) {
  EXPECT_NE(trace({"rays.csv", "--depth-limit", "1"}).err.find("  0 split nodes, 1 leaf "),
            std::string::npos);
}

TEST_F(Trace, JsonGoesToStandardOutputBesideAFileOfHits) {
  const ToolResult result = trace({"rays.csv", "-o", "hits.npy", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto json = Json::parse(result.out);
  EXPECT_EQ(json["model"], "roof.obj");
  EXPECT_EQ(json["rays"], "rays.csv");
  EXPECT_EQ(json["hits"], "hits.npy");
  EXPECT_EQ(json["format"], "npy");
  EXPECT_EQ(json["query"], "closest");
  EXPECT_EQ(json["precision"], "float");
  EXPECT_EQ(json["mesh"]["triangle_count"], 2);
  EXPECT_EQ(json["build"]["skipped_object_count"], 0);
  EXPECT_EQ(json["build"]["options"]["leaf_size"], BuildOptions{}.leafSize);
  EXPECT_EQ(json["tree"]["split_node_count"], 0);
  EXPECT_EQ(json["ray_count"], 2);
  EXPECT_EQ(json["hit_count"], 1);
  EXPECT_EQ(json["invalid_ray_count"], 0);
  EXPECT_GE(json["build"]["total_seconds"], 0.0);
  EXPECT_GE(json["trace_seconds"], 0.0);
  EXPECT_NE(result.err.find("traced 2 rays"), std::string::npos) << "talk and summary go apart";
}

TEST_F(Trace, JsonIsAloneOnStandardErrorBesideHitsOnStandardOutput) {
  const ToolResult result = trace({"rays.csv", "--json", "--any", "--double"});
  EXPECT_EQ(result.out, "hit\n1\n0\n");
  const auto json = Json::parse(result.err);
  EXPECT_EQ(json["hits"], "-");
  EXPECT_EQ(json["format"], "csv");
  EXPECT_EQ(json["query"], "any");
  EXPECT_EQ(json["row_count"], 2);
  const auto all = Json::parse(trace({"rays.csv", "--json", "--all"}).err);
  EXPECT_EQ(all["query"], "all");
  EXPECT_EQ(all["hit_count"], 1);
  EXPECT_EQ(all["row_count"], 1);
  EXPECT_EQ(json["precision"], "double");
}

TEST_F(Trace, JsonQuotesNamesAndReplacesWhatIsNoText) {
  for (const std::string name : {"a\"b\\c\n.obj", "latin\xe9.obj"}) {
    writeModel(name);
    const ToolResult result = run({"trace", name, "rays.csv", "-o", "h.csv", "--json"});
    EXPECT_EQ(result.status, 0) << result.err;
    const std::string told = Json::parse(result.out)["model"];
    EXPECT_EQ(told, name == "latin\xe9.obj" ? "latin\xef\xbf\xbd.obj" : name);
  }
}

TEST_F(Trace, LimitsHoldForRaysThatBringNone) {
  // The roof is hit at t = 4.75.
  writeFile("one.csv", "0.75,0.25,5,0,0,-1\n");
  const auto tracing = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"one.csv", "--any"});
    return trace(options).out;
  };
  const std::string hit = "hit\n1\n";
  const std::string miss = "hit\n0\n";
  EXPECT_EQ(tracing({}), hit);
  EXPECT_EQ(tracing({"--t-min", "4"}), hit);
  EXPECT_EQ(tracing({"--t-min", "6"}), miss);
  EXPECT_EQ(tracing({"--t-max", "6"}), hit);
  EXPECT_EQ(tracing({"--t-max", "4", "--double"}), miss);
  EXPECT_EQ(tracing({"--t-min", "-inf", "--t-max", "inf"}), hit);
  writeFile("eight.csv", "0.75,0.25,5,0,0,-1,0,inf\n");
  EXPECT_EQ(trace({"eight.csv", "--any", "--t-max", "4"}).out, hit) << "the ray's own limits hold";
}

TEST_F(Trace, TheMaskHidesGeometriesWithoutItsBits) {
  for (const char* query : {"--any", "--double"}) {
    EXPECT_NE(trace({"rays.csv", query, "--mask", "0x80000000"}).err.find("1 hit"),
              std::string::npos);
    EXPECT_NE(trace({"rays.csv", query, "--mask", "0"}).err.find("0 hit"), std::string::npos);
  }
}

TEST_F(Trace, HelpDescribesTheTables) {
  const ToolResult result = run({"trace", "--help"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  for (const char* part : {"ox,oy,oz,dx,dy,dz", "t,geometry,primitive,u,v,nx,ny,nz", "Examples:"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace planetree::test
