#include "bench/support/counted_heap.hpp"
#include "bench/support/result.hpp"
#include "tests/cli/tool_run.hpp"

#include "bench/scene/write_ply.hpp"
#include "bench_meshes.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace planetree::bench {
namespace {

/// planetree-bench from the outside.
class BenchCommand : public test::ToolTest {
 protected:
  BenchCommand() { writeFile("waves.ply", plyBytes(test::waves())); }

  [[nodiscard]] test::ToolResult rivals(std::vector<std::string> arguments) const {
    std::vector<std::string> all = {"rivals",    "--quick",       "--engines",
                                    "planetree", "--repetitions", "1"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run(all);
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(BenchCommand, RivalsPrintsTheTableAndWritesTheJson) {
  const auto result =
      rivals({"--measure", "rays,build", "--kinds", "primary,ao", "--json", "b.json", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "million rays per second"));
  EXPECT_TRUE(contains(result.out, "seconds to build"));
  EXPECT_TRUE(contains(result.out, "geometric mean"));
  const auto results = resultsFromJson(readFile("b.json"), "b.json");
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[0].scene, "waves");
  EXPECT_EQ(results[0].kind, "primary");
  EXPECT_EQ(results[1].kind, "ao");
  EXPECT_EQ(results[2].measure, "build_seconds");
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"b.json", "waves.ply"}));
}

TEST_F(BenchCommand, RivalsPrintsJsonAloneOnStandardOutput) {
  const auto result = rivals({"--kinds", "random", "--json", "-", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(resultsFromJson(result.out, "out").size(), 1u);
  EXPECT_TRUE(contains(result.err, "million rays per second"));
}

TEST_F(BenchCommand, RivalsTakesThreadsAndSingleModes) {
  const auto result =
      run({"rivals", "--quick", "--engines", "planetree:balanced-watertight", "--kinds", "random",
           "--threads", "2", "--repetitions", "1", "--json", "-", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(resultsFromJson(result.out, "out").at(0).threadCount, 2u);
}

TEST_F(BenchCommand, RivalsMeasuresWithEachOfSeveralNumbersOfThreads) {
  const auto result =
      rivals({"--measure", "build", "--threads", "1,2,1", "--json", "b.json", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto results = resultsFromJson(readFile("b.json"), "b.json");
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].threadCount, 1u);
  EXPECT_EQ(results[1].threadCount, 2u);
}

TEST_F(BenchCommand, RenderMeasuresPicturesWithEachNumberOfThreads) {
  writeFile("ball.ray",
            "SBT-raytracer 1.0\nambient_light { color = (1, 1, 1); }\n"
            "translate(0, 0, -4, sphere { material = { ambient = (1, 0, 0); }; })\n");
  const auto result = run({"render", "--width", "16", "--repetitions", "1", "--threads", "1,2,1",
                           "--json", "r.json", "ball.ray", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  for (const char* said : {"rendering: milliseconds", "ball.ray, whitted", "waves.ply, ao",
                           "trimesh-10k", "geometric mean", "encoding"})
    EXPECT_TRUE(contains(result.out, said)) << said << result.out;
  const auto results = resultsFromJson(readFile("r.json"), "r.json");
  ASSERT_EQ(results.size(), 28u);
  EXPECT_EQ(results[0].scene, "trimesh-10k");
  EXPECT_EQ(results[0].objectCount, 10'000u);
  EXPECT_EQ(results[4].scene, "ball.ray");
  EXPECT_EQ(results[4].kind, "whitted");
  EXPECT_EQ(results[10].threadCount, 2u);
  EXPECT_EQ(results[27].scene, "waves.ply");
  EXPECT_EQ(run({"render", "none.ray"}).status, 1);
}

TEST_F(BenchCommand, RivalsMeasuresBatches) {
  const auto result = rivals({"--measure", "batch", "--threads", "1,2", "--kinds", "primary,ao",
                              "--json", "b.json", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "million rays per second in batches"));
  const auto results = resultsFromJson(readFile("b.json"), "b.json");
  ASSERT_EQ(results.size(), 4u);
  EXPECT_EQ(results[0].measure, "batch_mrays_per_second");
  EXPECT_EQ(results[0].threadCount, 1u);
  EXPECT_EQ(results[3].kind, "ao");
  EXPECT_EQ(results[3].threadCount, 2u);
}

TEST_F(BenchCommand, RivalsMeasuresSmallBatches) {
  const auto result = rivals({"--measure", "small-batch", "--threads", "1,2", "--kinds", "ao",
                              "--json", "b.json", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "nanoseconds that small batches take more"));
  EXPECT_FALSE(contains(result.out, "nanoseconds_of_a_batch")) << "they are in one table";
  EXPECT_EQ(resultsFromJson(readFile("b.json"), "b.json").size(), 4u);
}

TEST_F(BenchCommand, SmallBatchesWantAnEngineThatTakesThem) {
  const auto result =
      run({"rivals", "--measure", "small-batch", "--engines", "embree3", "waves.ply"});
  // Without Embree in this build it fails for that.
  EXPECT_TRUE(result.status == 2 || result.status == 1) << result.err;
  EXPECT_TRUE(contains(result.err, "embree3") || contains(result.err, "takes batches"))
      << result.err;
}

TEST_F(BenchCommand, PacketsTakePartInBatchesAndElsewhereWhereTheyAreNamed) {
  const auto result =
      run({"rivals", "--quick", "--repetitions", "1", "--kinds", "random", "--measure",
           "rays,batch", "--engines", "embree3", "--json", "-", "waves.ply"});
  if (result.status == 1)
    GTEST_SKIP() << result.err;
  std::set<std::string> inBatches;
  for (const Result& found : resultsFromJson(result.out, "out")) {
    EXPECT_FALSE(found.measure == "mrays_per_second" && contains(found.mode, "packets"));
    if (found.measure == "batch_mrays_per_second")
      inBatches.insert(found.mode);
  }
  EXPECT_TRUE(inBatches.contains("high"));
  EXPECT_TRUE(inBatches.contains("high-packets"));
  EXPECT_TRUE(inBatches.contains("medium-robust-packets"));
  const auto named = run({"rivals", "--quick", "--repetitions", "1", "--kinds", "random",
                          "--engines", "embree3:high-packets", "--json", "-", "waves.ply"});
  EXPECT_EQ(named.status, 0) << named.err;
  ASSERT_EQ(resultsFromJson(named.out, "out").size(), 1u);
}

TEST_F(BenchCommand, RivalsCountsStepsAndPeaks) {
  const auto result = rivals({"--measure", "steps", "--kinds", "ao", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "nodes visited per ray"));
  EXPECT_TRUE(contains(result.out, "blocks tested per ray"));
  if (!heapIsCounted())
    return;
  const auto peak = rivals({"--measure", "peak", "waves.ply"});
  EXPECT_EQ(peak.status, 0) << peak.err;
  EXPECT_TRUE(contains(peak.out, "most bytes per triangle held while building"));
}

TEST_F(BenchCommand, StepsWantAnEngineThatCountsThem) {
  const auto result = run({"rivals", "--measure", "steps", "--engines", "embree3", "waves.ply"});
  // Without Embree in this build it fails for that.
  EXPECT_TRUE(result.status == 2 || result.status == 1) << result.err;
  EXPECT_TRUE(contains(result.err, "embree3") || contains(result.err, "count")) << result.err;
}

TEST_F(BenchCommand, RivalsTracesInDoubleOnlyWhereThatModeIsNamed) {
  const std::string inDouble = "planetree:balanced-watertight-float64";
  const auto result =
      rivals({"--engines", inDouble, "--kinds", "random", "--json", "-", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto results = resultsFromJson(result.out, "out");
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].mode, "balanced-watertight");
  EXPECT_EQ(results[1].mode, "balanced-watertight-float64");
  EXPECT_TRUE(results[0].isDefault);
  EXPECT_FALSE(results[1].isDefault);
}

TEST_F(BenchCommand, RivalsBuildsWithTheOtherPresetsOnlyWhereTheyAreNamed) {
  const auto result = rivals({"--engines", "planetree:fast-watertight,planetree:high-watertight",
                              "--kinds", "random", "--json", "-", "waves.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  std::vector<std::string> modes;
  for (const Result& found : resultsFromJson(result.out, "out"))
    modes.push_back(found.mode);
  EXPECT_EQ(modes, (std::vector<std::string>{"balanced-watertight", "fast-watertight",
                                             "high-watertight"}));
}

TEST_F(BenchCommand, WrongUsageEndsWithTwoAndAdvice) {
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"rivals"},
      {"rivals", "--measure", "beauty", "waves.ply"},
      {"rivals", "--kinds", "xray", "waves.ply"},
      {"rivals", "--engines", "nobody", "waves.ply"},
      {"rivals", "--engines", "planetree:nothing", "waves.ply"},
      {"rivals", "--repetitions", "0", "waves.ply"},
      {"rivals", "waves.ply", "waves.ply"},
      {"rivals", "shapes", "shapes"},
      {"scene", "moon", "-o", "moon.ply"},
      {"scene", "terrain"},
      {"nonsense"}};
  for (const auto& arguments : wrong) {
    const auto result = run(arguments);
    EXPECT_EQ(result.status, 2) << testing::PrintToString(arguments) << result.err;
    EXPECT_TRUE(contains(result.err, "planetree-bench: ")) << result.err;
    EXPECT_EQ(result.out, "");
  }
}

TEST_F(BenchCommand, FailuresEndWithOneAndLeaveNothing) {
  writeFile("empty.obj", "v 0 0 0\n");
  EXPECT_EQ(rivals({"missing.ply"}).status, 1);
  EXPECT_EQ(rivals({"empty.obj"}).status, 1);
  EXPECT_EQ(rivals({"--json", "no/such/folder.json", "waves.ply"}).status, 1);
  EXPECT_EQ(run({"scene", "interior", "-o", "no/such/folder.ply"}).status, 1);
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"empty.obj", "waves.ply"}));
}

TEST_F(BenchCommand, RivalsRefusesASceneThatNoRayCanHit) {
  writeFile("points.obj", "v 0 0 0\nv 1 0 0\nf 1 1 2\nf 2 2 1\n");
  const auto result = rivals({"points.obj"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(contains(result.err, "points.obj: has 2 triangles, none of which can be hit"));
  EXPECT_FALSE(contains(result.err, "measuring"));
}

TEST_F(BenchCommand, RivalsMeasuresAFlatSceneWithAllEngines) {
  writeFile("flat.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  const auto result = run({"rivals", "--quick", "--repetitions", "1", "flat.obj"});
  EXPECT_EQ(result.status, 0) << result.err;
}

TEST_F(BenchCommand, RivalsMeasuresShapesBesideMeshes) {
  const auto result = rivals({"--kinds", "random", "--json", "b.json", "waves.ply", "shapes"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "shapes: 250000 shapes, measuring rays on 1 thread"));
  const auto results = resultsFromJson(readFile("b.json"), "b.json");
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[1].scene, "shapes");
  EXPECT_EQ(results[1].engine, "planetree");
}

TEST_F(BenchCommand, AFileMayHaveTheNameOfASceneOfShapes) {
  writeFile("spheres.ply", plyBytes(test::waves()));
  const auto result = rivals({"--kinds", "random", "spheres.ply"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "spheres: 3200 triangles"));
}

TEST_F(BenchCommand, RivalsMeasuresScenesOfAnySize) {
  const auto result = rivals({"--measure", "build", "terrain-1k", "scatter-2k"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(contains(result.err, "scatter-2k: 2136 triangles")) << result.err;
  EXPECT_TRUE(contains(result.out, "nanoseconds to build for each triangle of terrain"));
  EXPECT_EQ(rivals({"terrain-1g"}).status, 1) << "there is no file of that name";
}

TEST_F(BenchCommand, ShapesWantAnEngineThatTakesThem) {
  const auto result = run({"rivals", "--engines", "cgal", "shapes"});
  // Without CGAL in this build it fails for that.
  EXPECT_TRUE(result.status == 2 || result.status == 1) << result.err;
  EXPECT_TRUE(contains(result.err, "cgal") || contains(result.err, "takes shapes")) << result.err;
}

TEST_F(BenchCommand, RefusesAnInstructionSetThatTheMachineHasNot) {
  const auto result = run(test::ToolStart{.arguments = {"rivals", "--quick", "waves.ply"},
                                          .environment = {"PLANETREE_ISA=mmx"}});
  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(contains(result.err, "PLANETREE_ISA=mmx")) << result.err;
}

TEST_F(BenchCommand, RivalsMeasuresNothingIfASceneIsMissing) {
  const auto result = rivals({"--json", "b.json", "waves.ply", "missing.ply"});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(contains(result.err, "missing.ply"));
  EXPECT_FALSE(contains(result.err, "measuring"));
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"waves.ply"});
}

TEST_F(BenchCommand, FailsIfStandardOutputIsFull) {
  constexpr const char* kFull = "/dev/full";
  if (!std::filesystem::exists(kFull))
    GTEST_SKIP() << "there is no " << kFull;
  const std::vector<std::vector<std::string>> commands = {
      {"--help"},
      {"rivals", "--quick", "--engines", "planetree", "--kinds", "random", "waves.ply"},
      {"rivals", "--quick", "--engines", "planetree", "--kinds", "random", "--json", "-",
       "waves.ply"},
      {"scene", "interior", "-o", "-"}};
  for (const auto& arguments : commands) {
    const auto result = run(test::ToolStart{.arguments = arguments, .standardOutput = kFull});
    EXPECT_EQ(result.status, 1) << testing::PrintToString(arguments);
    EXPECT_TRUE(contains(result.err, "planetree-bench: ")) << result.err;
  }
}

TEST_F(BenchCommand, SceneWritesTheSameToStandardOutputAsToAFile) {
  const auto result = run({"scene", "interior", "-o", "-"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"waves.ply"});
  ASSERT_EQ(run({"scene", "interior", "-o", "interior.ply"}).status, 0);
  EXPECT_TRUE(result.out == readFile("interior.ply"));
}

TEST_F(BenchCommand, ReportKeepsThePageIfThereAreNoResults) {
  const std::string page = "<!-- figures: begin -->\nold\n<!-- figures: end -->\n";
  writeFile("page.md", page);
  writeFile("b.json", "[]");
  const auto result = run({"report", "b.json", "--page", "page.md", "--plots", "."});
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(contains(result.err, "b.json: holds no results")) << result.err;
  EXPECT_EQ(readFile("page.md"), page);
}

TEST_F(BenchCommand, ReportRenewsThePageAndKeepsWhatIsWrittenByHand) {
  writeFile("page.md", "by hand\n<!-- figures: begin -->\n<!-- figures: end -->\nalso by hand\n");
  ASSERT_EQ(rivals({"--kinds", "random", "--json", "b.json", "waves.ply"}).status, 0);
  const auto result =
      run({"report", "b.json", "--page", "page.md", "--plots", ".", "--machine", "a computer"});
  EXPECT_EQ(result.status, 0) << result.err;
  const std::string page = readFile("page.md");
  EXPECT_TRUE(page.starts_with("by hand\n"));
  EXPECT_TRUE(page.ends_with("also by hand\n"));
  EXPECT_TRUE(contains(page, "Machine: a computer."));
  EXPECT_TRUE(contains(page, "](./mrays_per_second-random-1.svg)"));
  EXPECT_TRUE(contains(readFile("mrays_per_second-random-1.svg"), "</svg>"));
}

TEST_F(BenchCommand, ReportPutsSeveralFilesTogether) {
  writeFile("page.md", "<!-- figures: begin -->\n<!-- figures: end -->\n");
  ASSERT_EQ(rivals({"--kinds", "random", "--json", "rays.json", "waves.ply"}).status, 0);
  ASSERT_EQ(rivals({"--measure", "build", "--threads", "1,2", "--json", "build.json", "waves.ply"})
                .status,
            0);
  const auto result =
      run({"report", "rays.json", "build.json", "--page", "page.md", "--plots", "."});
  EXPECT_EQ(result.status, 0) << result.err;
  const std::string page = readFile("page.md");
  EXPECT_TRUE(contains(page, "Million rays per second"));
  EXPECT_TRUE(contains(page, "How many times faster 2 threads build than 1"));
}

TEST_F(BenchCommand, ReportRefusesWhatIsNoResult) {
  writeFile("page.md", "no marks");
  writeFile("b.json", "[]");
  writeFile("bad.json", "{");
  EXPECT_EQ(run({"report", "b.json", "--page", "page.md", "--plots", "."}).status, 1);
  EXPECT_EQ(run({"report", "bad.json", "--page", "page.md", "--plots", "."}).status, 1);
  EXPECT_EQ(run({"report", "none.json", "--page", "page.md", "--plots", "."}).status, 1);
  EXPECT_EQ(readFile("page.md"), "no marks");
}

}  // namespace
}  // namespace planetree::bench
