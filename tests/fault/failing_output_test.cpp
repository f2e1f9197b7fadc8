#include "fault_folder.hpp"
#include "fault_tally.hpp"
#include "tool_start.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace planetree::test {
namespace {

namespace fs = std::filesystem;

/// A command that writes, and where it writes to.
struct Writing {
  std::string name;
  std::string program;
  std::vector<std::string> arguments;
  std::string output;  ///< a file; empty if it is standard output
};

class FailingOutput : public FaultFolder {
 protected:
  FailingOutput() {
    std::string model;
    std::string rays;
    for (int i = 0; i < 60; ++i) {
      const std::string x = std::to_string(i);
      const std::string first = std::to_string(3 * i + 1);
      model += "v " + x + " 0 0\nv " + x + " 1 0\nv " + x + ".5 0 1\nf " + first + " " +
               std::to_string(3 * i + 2) + " " + std::to_string(3 * i + 3) + "\n";
      rays += x + ".1,0.1,5,0,0,-1\n";
    }
    write("model.obj", model);
    write("rays.csv", rays);
    write("page.md", "<!-- figures: begin -->\nold\n<!-- figures: end -->\n");
  }

  [[nodiscard]] static std::vector<Writing> toolWritings() {
    const std::string tool = PLANETREE_TOOL;
    const std::vector<std::string> picture = {"render",    "-q", "--size",   "16x12",
                                              "--samples", "1",  "model.obj"};
    const auto with = [](std::vector<std::string> arguments, std::vector<std::string> more) {
      arguments.insert(arguments.end(), more.begin(), more.end());
      return arguments;
    };
    const std::vector<std::string> ray = {"explain", "-q", "model.obj", "--ray",
                                          "0.1,0.1,5,0,0,-1"};
    const std::vector<std::string> hits = {"trace", "-q", "model.obj", "rays.csv"};
    const std::vector<std::string> info = {"info", "-q", "model.obj"};
    return {{"a PNG file", tool, with(picture, {"-o", "out.png"}), "out.png"},
            {"an EXR file", tool, with(picture, {"-o", "out.exr"}), "out.exr"},
            {"a PNG stream", tool, with(picture, {"-o", "-"}), ""},
            {"a picture in numbers", tool, with(picture, {"-o", "/dev/null", "--json"}), ""},
            {"CSV hits", tool, with(hits, {"-o", "out.csv"}), "out.csv"},
            {"NPY hits", tool, with(hits, {"-o", "out.npy"}), "out.npy"},
            {"CSV stream", tool, hits, ""},
            {"hits in numbers", tool, with(hits, {"-o", "/dev/null", "--json"}), ""},
            {"explain", tool, ray, ""},
            {"explain --json", tool, with(ray, {"--json"}), ""},
            {"info", tool, info, ""},
            {"info --json", tool, with(info, {"--json"}), ""},
            {"info --plot", tool, with(info, {"--plot", "out.svg"}), "out.svg"},
            {"completion bash", tool, {"completion", "bash"}, ""},
            {"completion zsh", tool, {"completion", "zsh"}, ""},
            {"completion fish", tool, {"completion", "fish"}, ""},
            {"man", tool, {"man"}, ""},
            {"help", tool, {"help", "trace"}, ""},
            {"--help", tool, {"--help"}, ""},
            {"--version", tool, {"--version"}, ""}};
  }

  [[nodiscard]] std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> contents;
    for (const auto& entry : fs::directory_iterator(folder())) {
      const std::string name = entry.path().filename().string();
      contents[name] = read(name);
    }
    return contents;
  }

  [[nodiscard]] OutputStart startOf(const Writing& writing) const {
    return {.program = writing.program, .arguments = writing.arguments, .folder = folder()};
  }

  /// One line that names the tool and what it could not write.
  static void expectOneClearLine(const std::string& name, const Writing& writing,
                                 const OutputResult& result) {
    const std::string named = writing.output.empty() ? "standard output" : writing.output;
    const bool isClear = result.status == 1 && result.err.starts_with("planetree") &&
                         result.err.find(": " + named + ": ") != std::string::npos &&
                         std::count(result.err.begin(), result.err.end(), '\n') == 1;
    if (!isClear) {
      reportLost(name + ": status " + std::to_string(result.status) + ", signal " +
                 std::to_string(result.signal) + ", " + result.err);
    }
  }

  /// Writes where only so many bytes have room, for some numbers of them.
  void tryFullDisk(const Writing& writing, std::uint64_t most) {
    SCOPED_TRACE(writing.name);
    OutputStart start = startOf(writing);
    // Outside of the folder: the file of a redirection is made by the shell.
    const fs::path stream = folder().string() + ".out";
    if (writing.output.empty())
      start.standardOutput = stream;
    ASSERT_EQ(run(start).status, 0);
    const std::uint64_t size =
        fs::file_size(writing.output.empty() ? stream : folder() / writing.output);
    ASSERT_GT(size, 0u);
    std::map<std::string, std::string> before = files();
    if (!writing.output.empty()) {
      write(writing.output, "the old file");
      before = files();
    }
    // Where it tells how long something took, it may be shorter the next time.
    constexpr std::uint64_t kMostOfTimes = 100;
    const bool tellsTimes = writing.arguments.back() == "--json" || writing.name == "info";
    const std::uint64_t least = tellsTimes ? size - std::min(size, kMostOfTimes) : size;
    // Of long outputs not even the long form tries every byte.
    const std::uint64_t step = triesEveryFault() ? 1 + least / 500 : 1;
    for (const std::uint64_t room : someOf(least, most)) {
      if (room % step != 0)
        continue;
      const std::string name = writing.name + ", room for " + std::to_string(room - 1);
      start.largestFile = room - 1;
      expectOneClearLine(name, writing, run(start));
      ++faultTally().injectedCount;
      if (files() != before)
        reportLeak(name);
      if (HasFailure())
        break;
    }
    start.largestFile = size + kMostOfTimes;
    EXPECT_EQ(run(start).status, 0);
    fs::remove(stream);
  }
};

TEST_F(FailingOutput, FullDisksAreToldAndLeaveTheOldFile) {
  for (const Writing& writing : toolWritings())
    tryFullDisk(writing, 6);
}

TEST_F(FailingOutput, FullDisksAreToldByTheBenchmark) {
  const std::string bench = PLANETREE_BENCH;
  const std::vector<std::string> rivals = {"rivals",        "--quick", "--engines",
                                           "planetree",     "--kinds", "random",
                                           "--repetitions", "1",       "--json"};
  std::vector<std::string> json = rivals;
  json.insert(json.end(), {"out.json", "model.obj"});
  ASSERT_EQ(run({.program = bench, .arguments = json, .folder = folder()}).status, 0);
  write("results.json", read("out.json"));
  const Writing page = {
      "--page", bench, {"report", "results.json", "--page", "page.md", "--plots", "."}, "page.md"};
  ASSERT_EQ(run({.program = bench, .arguments = page.arguments, .folder = folder()}).status, 0);
  const std::map<std::string, std::string> before = files();
  // The page is written last, and is the largest file.
  const auto expectTold = [&](const std::vector<std::string>& arguments, std::uint64_t room) {
    const OutputResult result =
        run({.program = bench, .arguments = arguments, .folder = folder(), .largestFile = room});
    const std::string name = arguments.front() + ", room for " + std::to_string(room);
    const std::size_t lastLine = result.err.rfind('\n', result.err.size() - 2) + 1;
    if (result.status != 1 || result.err.compare(lastLine, 17, "planetree-bench: ") != 0)
      reportLost(name + ": signal " + std::to_string(result.signal) + ", " + result.err);
    ++faultTally().injectedCount;
    if (files().size() != before.size() || read("page.md") != before.at("page.md") ||
        read("out.json") != before.at("out.json"))
      reportLeak(name);
  };
  for (const std::uint64_t room : {0u, 1u, 100u})
    expectTold(page.arguments, room);
  expectTold(json, 10);
}

TEST_F(FailingOutput, FullDevicesAreTold) {
  if (!fs::exists("/dev/full"))
    GTEST_SKIP() << "there is no /dev/full";
  for (const Writing& writing : toolWritings()) {
    if (!writing.output.empty())
      continue;
    OutputStart start = startOf(writing);
    start.standardOutput = "/dev/full";
    expectOneClearLine(writing.name, writing, run(start));
    ++faultTally().injectedCount;
  }
}

TEST_F(FailingOutput, AReaderThatLeavesEndsTheToolQuietly) {
  // More than a pipe holds, so that the tool has to wait for its reader.
  std::string rays;
  for (int i = 0; i < 20'000; ++i)
    rays += "0.1,0.1,5,0,0,-1\n";
  write("rays.csv", rays);
  const Writing writing = {"trace", PLANETREE_TOOL, {"trace", "model.obj", "rays.csv"}, ""};
  OutputStart start = startOf(writing);
  start.readBytes = 40;
  const std::map<std::string, std::string> before = files();
  const OutputResult result = run(start);
  EXPECT_EQ(result.signal, SIGPIPE);
  EXPECT_EQ(result.out, "t,geometry,primitive,u,v,nx,ny,nz\n4.8,0,");
  EXPECT_EQ(result.err.find("planetree: "), std::string::npos) << result.err;
  EXPECT_EQ(files(), before);

  start.ignoresClosedPipes = true;
  start.arguments.push_back("-q");
  expectOneClearLine("ignored", writing, run(start));
  faultTally().injectedCount += 2;
}

TEST_F(FailingOutput, AReaderThatIsGoneEndsEveryCommandQuietly) {
  for (const Writing& writing : toolWritings()) {
    OutputStart start = startOf(writing);
    start.readBytes = 0;
    const OutputResult result = run(start);
    ++faultTally().injectedCount;
    const bool isStream = writing.output.empty();
    // It may have been faster than the end of the reader.
    const bool isQuiet = result.err.empty() && (result.signal == SIGPIPE || result.status == 0);
    // The plot is not all that `info` writes.
    const bool mayFail = isStream || writing.name == "info --plot";
    if (!isQuiet || (!mayFail && result.status != 0))
      reportLost(writing.name + ": signal " + std::to_string(result.signal) + ", " + result.err);
  }
}

TEST_F(FailingOutput, AClosedStandardOutputIsTold) {
  for (const Writing& writing : toolWritings()) {
    OutputStart start = startOf(writing);
    start.closedStreams = {STDOUT_FILENO};
    const OutputResult result = run(start);
    ++faultTally().injectedCount;
    if (writing.output.empty()) {
      expectOneClearLine(writing.name, writing, result);
    } else if (writing.name != "info --plot") {
      EXPECT_EQ(result.status, 0) << writing.name << result.err;
    }
  }
}

TEST_F(FailingOutput, ClosedStreamsStayOutOfTheFiles) {
  std::map<std::string, std::string> whole;
  for (const Writing& writing : toolWritings()) {
    if (!writing.output.empty() && writing.name != "info --plot") {
      ASSERT_EQ(run(startOf(writing)).status, 0) << writing.name;
      whole[writing.name] = read(writing.output);
    }
  }
  const std::vector<std::vector<int>> closings = {
      {STDERR_FILENO}, {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}, {STDIN_FILENO}};
  for (const auto& closed : closings) {
    for (const Writing& writing : toolWritings()) {
      if (!whole.contains(writing.name))
        continue;
      OutputStart start = startOf(writing);
      // With all that it says.
      std::erase(start.arguments, "-q");
      start.closedStreams = closed;
      fs::remove(folder() / writing.output);
      EXPECT_EQ(run(start).status, 0) << writing.name;
      ++faultTally().injectedCount;
      // Pictures hold the command that made them, which is the same.
      if (read(writing.output) != whole.at(writing.name))
        reportLost(writing.name + " with closed streams is another file");
    }
  }
}

/// The number of a closed stream is the next that the system gives away: here, to a copy of
/// standard input.
TEST_F(FailingOutput, WhatGoesToAClosedStreamGoesNowhereElse) {
  const std::map<std::string, std::string> before = files();
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--json"}}) {
    OutputStart start = {.program = PLANETREE_TOOL,
                         .arguments = {"trace", "-q", "model.obj", "-"},
                         .folder = folder(),
                         .closedStreams = {STDOUT_FILENO},
                         .standardInput = folder() / "rays.csv"};
    start.arguments.insert(start.arguments.end(), more.begin(), more.end());
    const OutputResult result = run(start);
    ++faultTally().injectedCount;
    if (result.status != 1 ||
        result.err.find("standard output: cannot be written") == result.err.npos)
      reportLost("hits to a closed stream: " + result.err);
    if (files() != before)
      reportLost("hits to a closed stream went to the rays");
  }
}

TEST_F(FailingOutput, AModelFromAClosedStandardInputIsToldToBeMissing) {
  const OutputResult result = run({.program = PLANETREE_TOOL,
                                   .arguments = {"trace", "model.obj", "-"},
                                   .folder = folder(),
                                   .closedStreams = {STDIN_FILENO}});
  ++faultTally().injectedCount;
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(result.err.starts_with("planetree: standard input: cannot be read")) << result.err;
}

}  // namespace
}  // namespace planetree::test
