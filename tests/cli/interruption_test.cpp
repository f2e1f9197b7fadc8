#include "trace_test.hpp"

#include "support/read_png.hpp"

#include <chrono>
#include <csignal>
#include <iostream>
#include <random>
#include <thread>

/// Real signals at the running tool.
namespace planetree::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class Interrupted : public ToolTest {
 protected:
  /// Sends the signal and expects that it ends the tool soon.
  static ToolResult end(ToolProcess& tool, int signal) {
    const Clock::time_point start = Clock::now();
    tool.signal(signal);
    const ToolResult result = tool.wait();
    // Ending takes a few milliseconds; the machine may be busy.
    EXPECT_LT(Clock::now() - start, 1s);
    return result;
  }

  static void waitFor(const ToolProcess& tool, const std::string& said) {
    const Clock::time_point deadline = Clock::now() + 60s;
    while (tool.errSoFar().find(said) == std::string::npos) {
      ASSERT_LT(Clock::now(), deadline) << tool.errSoFar();
      std::this_thread::sleep_for(5ms);
    }
  }
};

class BySignal : public Interrupted, public testing::WithParamInterface<int> {};

TEST_P(BySignal, RenderingKeepsWhatIsThere) {
  writeFile("picture.png", "the old picture");
  // Samples enough to take minutes: the signal always comes while it renders.
  ToolProcess tool(folder(),
                   ToolStart{.arguments = {"render", "--size", "200x150", "--samples", "65536",
                                           "--preview", "0.05", "-o", "picture.png"}});
  const Clock::time_point deadline = Clock::now() + 60s;
  while (readFile("picture.png") == "the old picture") {
    ASSERT_LT(Clock::now(), deadline) << "no preview: " << tool.errSoFar();
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_TRUE(isPng(readFile("picture.png"), 200, 150));
  const ToolResult result = end(tool, GetParam());
  EXPECT_EQ(result.signal, GetParam()) << "a shell has to see that it was interrupted";
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("\nplanetree: interrupted, and picture.png has "), std::string::npos)
      << result.err;
  EXPECT_TRUE(result.err.ends_with(" 1 % of the picture\n")) << result.err;
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"picture.png"});
  const auto picture = readPng(readFile("picture.png"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->image.size, (render::ImageSize{200, 150}));
  EXPECT_TRUE(picture->texts.at("Done").ends_with(" % of the samples"));
}

TEST_P(BySignal, ASecondOneEndsItAtOnceWithoutAFile) {
  writeFile("picture.png", "the old picture");
  // Packing so many pixels takes far longer than the next signal.
  ToolProcess tool(folder(), ToolStart{.arguments = {"render", "--size", "1500x1500", "--samples",
                                                     "256", "-o", "picture.png"}});
  waitFor(tool, "view: ");
  std::this_thread::sleep_for(300ms);
  // Two signals are one to a program that has not run meanwhile.
  while (!tool.hasEnded()) {
    tool.signal(GetParam());
    std::this_thread::sleep_for(5ms);
  }
  const ToolResult result = tool.wait();
  EXPECT_EQ(result.signal, GetParam());
  EXPECT_TRUE(result.err.ends_with("planetree: interrupted\n") ||
              result.err.ends_with("planetree: interrupted, and no file was written\n"))
      << result.err;
  EXPECT_EQ(filesInFolder(), std::vector<std::string>{"picture.png"});
  EXPECT_TRUE(readFile("picture.png") == "the old picture");
}

TEST_P(BySignal, StandardOutputGetsNoHalfPicture) {
  ToolProcess tool(folder(), ToolStart{.arguments = {"render", "--size", "200x150", "--samples",
                                                     "65536", "-o", "-"}});
  waitFor(tool, "view: ");
  std::this_thread::sleep_for(300ms);
  const ToolResult result = end(tool, GetParam());
  EXPECT_EQ(result.signal, GetParam());
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.ends_with("\nplanetree: interrupted\n")) << result.err;
}

INSTANTIATE_TEST_SUITE_P(Signals, BySignal, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST_F(Interrupted, WhileBuildingItEndsAsQuickly) {
  writeFile("heap.obj", objOf(randomMesh<float>(51, 20'000)));
  // Triangles that cross each other are divided without end, unless cost or number end it.
  ToolProcess tool(folder(), ToolStart{.arguments = {"render", "heap.obj", "--leaf-size", "0",
                                                     "--stops-by-cost", "off", "--depth-limit",
                                                     "64", "--references-per-object", "0"}});
  waitFor(tool, "heap.obj: ");
  std::this_thread::sleep_for(300ms);
  EXPECT_FALSE(tool.hasEnded());
  const ToolResult result = end(tool, SIGINT);
  EXPECT_EQ(result.signal, SIGINT);
  EXPECT_TRUE(result.err.ends_with("\nplanetree: interrupted\n")) << result.err;
}

TEST_F(Interrupted, AtAnyMomentItLeavesTheOldFileOrTheWholeNewOne) {
  const auto seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 generator(seed);
  writeFile("heap.obj", objOf(randomMesh<float>(52, 500)));
  writeFile("rays.npy", npyOf(randomRays<float>(53, 20'000)));
  const ToolStart start{.arguments = {"trace", "heap.obj", "rays.npy", "-o", "hits.csv", "-q"}};

  const Clock::time_point begin = Clock::now();
  ASSERT_EQ(run(start).status, 0);
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin);
  const std::string newHits = readFile("hits.csv");

  constexpr int kRuns = 40;
  std::uniform_int_distribution<std::int64_t> anyMoment(0, whole.count() * 5 / 4);
  int endedCount = 0;
  for (int i = 0; i < kRuns; ++i) {
    writeFile("hits.csv", "older hits");
    ToolProcess tool(folder(), start);
    std::this_thread::sleep_for(std::chrono::microseconds(anyMoment(generator)));
    const ToolResult result = end(tool, i % 2 == 0 ? SIGINT : SIGTERM);
    if (result.status != 0) {
      EXPECT_EQ(result.signal, i % 2 == 0 ? SIGINT : SIGTERM);
      ++endedCount;
    }
    const std::string hits = readFile("hits.csv");
    EXPECT_TRUE(hits == newHits || (hits == "older hits" && result.status != 0));
    // Before the handler is there, a signal ends it without a word.
    EXPECT_TRUE(result.err.empty() || result.err.starts_with("planetree: interrupted"))
        << result.err;
    EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"heap.obj", "hits.csv", "rays.npy"}));
  }
  EXPECT_GT(endedCount, 0);
}

TEST_F(Interrupted, WhatItWasStartedToIgnoreItIgnores) {
  const auto previous = std::signal(SIGINT, SIG_IGN);
  ToolProcess tool(folder(), ToolStart{.arguments = {"render", "--size", "200x150"}});
  std::signal(SIGINT, previous);
  waitFor(tool, "view: ");
  tool.signal(SIGINT);
  EXPECT_EQ(tool.wait().status, 0);
}

}  // namespace
}  // namespace planetree::test
