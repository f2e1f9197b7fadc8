#include "trace_test.hpp"

#include <ostream>

namespace planetree::test {
namespace {

namespace fs = std::filesystem;

/// A command line that is refused, and what the message must name.
struct RefusedTrace {
  std::vector<std::string> arguments;
  std::string named;
};

void PrintTo(const RefusedTrace& refused, std::ostream* out) {
  for (const std::string& argument : refused.arguments)
    *out << argument << ' ';
}

class TraceUsage : public TraceTest, public testing::WithParamInterface<RefusedTrace> {};

TEST_P(TraceUsage, EndsWithStatusTwoAndOneLineThatNamesTheOption) {
  std::vector<std::string> arguments = GetParam().arguments;
  arguments.insert(arguments.begin(), "trace");
  const ToolResult result = run(arguments);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.rfind("planetree: ", 0), 0u) << result.err;
  EXPECT_NE(result.err.find(GetParam().named), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"rays.csv", "roof.obj"}));
}

INSTANTIATE_TEST_SUITE_P(
    Arguments, TraceUsage,
    testing::Values(RefusedTrace{{}, "MODEL"}, RefusedTrace{{"roof.obj"}, "RAYS"},
                    RefusedTrace{{"", "rays.csv"}, "MODEL"}, RefusedTrace{{"roof.obj", ""}, "RAYS"},
                    RefusedTrace{{"roof.obj", "rays.csv", "more.csv"}, "more.csv"},
                    RefusedTrace{{"roof.obj", "rays.csv", "--bogus"}, "planetree trace --help"},
                    RefusedTrace{{"roof.obj", "rays.csv", "-o", ""}, "--output"},
                    RefusedTrace{{"roof.obj", "rays.csv", "--format", "xml"}, "--format xml"},
                    RefusedTrace{{"roof.obj", "rays.csv", "--format", "NPY"}, "--format NPY"},
                    RefusedTrace{{"roof.obj", "rays.csv", "--threads", "-1"}, "--threads -1"},
                    RefusedTrace{{"roof.obj", "rays.csv", "--preset", "best"}, "--preset best"},
                    RefusedTrace{{"roof.obj", "rays.csv", "--leaf-size", "x"}, "--leaf-size x"},
                    RefusedTrace{{"roof.obj", "rays.csv", "--depth-limit", "0"},
                                 "--depth-limit 0"}));

INSTANTIATE_TEST_SUITE_P(
    Outputs, TraceUsage,
    testing::Values(
        RefusedTrace{{"roof.obj", "rays.csv", "-o", "hits.npy", "--format", "csv"},
                     "-o hits.npy: --format csv"},
        RefusedTrace{{"roof.obj", "rays.csv", "-o", "hits.csv", "--format", "npy"},
                     "-o hits.csv: --format npy"},
        RefusedTrace{{"roof.obj", "rays.csv", "-o", "rays.csv"}, "that is the file of the rays"},
        RefusedTrace{{"roof.obj", "rays.csv", "-o", "./roof.obj"}, "that is the model"}));

using TraceFailure = TraceTest;

TEST_F(TraceFailure, FilesThatCannotBeReadAreNamed) {
  expectFailed(trace({"missing.csv", "-q"}), "missing.csv: cannot be read");
  expectFailed(trace({".", "-q"}), ".: cannot be read");
  expectFailed(run({"trace", "missing.obj", "rays.csv"}), "missing.obj: ");
}

TEST_F(TraceFailure, ModelsWithoutTrianglesSaySo) {
  writeFile("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  const ToolResult result = run({"trace", "points.obj", "rays.csv", "-q"});
  expectFailed(result, "points.obj: has no triangles");
  EXPECT_EQ(result.out, "");
}

TEST_F(TraceFailure, BrokenRaysAreNamedWithTheirLineAndLeaveNoFile) {
  writeFile("broken.csv", "ox,oy,oz,dx,dy,dz\n1,2,3,4,5,6\n1,2,3,four,5,6\n");
  writeFile("hits.csv", "older hits");
  expectFailed(trace({"broken.csv", "-q", "-o", "hits.csv"}),
               "broken.csv:3: column 4: \"four\" is not a number");
  EXPECT_EQ(readFile("hits.csv"), "older hits");
  expectFailed(trace({"broken.csv", "-q", "-o", "new.npy"}), "broken.csv:3: ");
  EXPECT_EQ(filesInFolder(),
            (std::vector<std::string>{"broken.csv", "hits.csv", "rays.csv", "roof.obj"}));
}

TEST_F(TraceFailure, TheFirstFaultIsToldWhicheverThreadFindsAnother) {
  std::string text;
  while (text.size() < 2'000'000)
    text += "1,2,3,4,5,6\n";
  const std::string good = text;
  text += "first,2,3,4,5,6\n" + good + "second,2,3,4,5,6\n" + good;
  writeFile("faults.csv", text);
  const std::size_t goodCount = good.size() / 12;
  for (int repetition = 0; repetition < 5; ++repetition) {
    const ToolResult result = trace({"faults.csv", "-q", "--threads", "4", "--any"});
    expectFailed(result, "faults.csv:" + std::to_string(goodCount + 1) + ": column 1: \"first\"");
    // All blocks before the faulty one were written.
    EXPECT_GT(result.out.size(), 2 * goodCount * 4 / 5);
  }
}

TEST_F(TraceFailure, EmptyAndForeignFilesAreNamed) {
  writeFile("empty.csv", "");
  expectFailed(trace({"empty.csv", "-q"}), "empty.csv: is empty");
  writeFile("rays.npz", std::string("PK\3\4\x14\0\0\0", 8));
  expectFailed(trace({"rays.npz", "-q"}), "rays.npz: is neither CSV nor .npy");
}

TEST_F(TraceFailure, LyingArraysAreRefusedWithoutMemoryForThem) {
  writeFile("huge.npy", npyRayHeader<float>(1'000'000'000'000) + std::string(64, '\0'));
  const ToolResult result = trace({"huge.npy", "-q"});
  expectFailed(result, "huge.npy: ends after 2 of the 1000000000000 rays");
  EXPECT_EQ(result.out, "") << "the size of a file is looked at first";
  EXPECT_LT(result.peakBytes, std::uint64_t{1} << 30);
}

TEST_F(TraceFailure, OutputsThatCannotBeWrittenAreNamed) {
  expectFailed(trace({"rays.csv", "-q", "-o", "missing/hits.csv"}),
               "missing/hits.csv: cannot be written");
  if (fs::exists("/dev/full")) {
    expectFailed(trace({"rays.csv", "-q", "-o", "/dev/full"}), "/dev/full: cannot be written");
    expectFailed(run(ToolStart{.arguments = {"trace", "roof.obj", "rays.csv", "-q"},
                               .standardOutput = "/dev/full"}),
                 "standard output: cannot be written");
  }
}

TEST_F(TraceFailure, AFullDiskLeavesTheOldHitsAndNothingElse) {
  writeFile("hits.csv", "older hits");
  std::string many;
  for (int i = 0; i < 1000; ++i)
    many += kTwoRays;
  writeFile("rays.csv", many);
  expectFailed(run(ToolStart{.arguments = {"trace", "roof.obj", "rays.csv", "-q", "-o", "hits.csv"},
                             .largestFile = 4000}),
               "hits.csv: cannot be written");
  EXPECT_EQ(readFile("hits.csv"), "older hits");
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"hits.csv", "rays.csv", "roof.obj"}));
}

}  // namespace
}  // namespace planetree::test
