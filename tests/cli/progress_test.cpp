#include "progress_line.hpp"

#include "terminal.hpp"
#include "trace_test.hpp"

#include <chrono>
#include <csignal>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <vector>

/// What the tool shows of its progress, and where.
namespace planetree::test {
namespace {

TEST(ProgressText, TellsTheTimeThatIsLeft) {
  EXPECT_EQ(tool::progressText("rendering", 0.25, 4.0),
            "rendering [=====               ]  25 %, 12 s left");
  EXPECT_EQ(tool::progressText("tracing", 0.999, 100.0),
            "tracing [=================== ]  99 %, 1 s left");
  EXPECT_EQ(tool::progressText("tracing", 1.0, 3.0),
            "tracing [====================] 100 %, 0 s left");
  EXPECT_EQ(tool::progressText("tracing", 0.5, 61.0),
            "tracing [==========          ]  50 %, 1 min 01 s left");
  EXPECT_EQ(tool::progressText("tracing", 0.5, 3660.0),
            "tracing [==========          ]  50 %, 1 h 01 min left");
}

TEST(ProgressText, TellsTheTimeTakenWhereTheEndIsNotKnown) {
  EXPECT_EQ(tool::progressText("building the tree", 0.0, 12.9), "building the tree, 12 s");
}

/// An OBJ file.
std::string soupOfSmallTriangles(std::uint32_t count) {
  TriangleMesh<float> mesh = randomMesh<float>(54, count);
  for (const FaceIndices& face : mesh.faces) {
    const Vec3f& first = mesh.positions[face[0]];
    for (const std::uint32_t corner : {face[1], face[2]})
      mesh.positions[corner] = first + (mesh.positions[corner] - first) * 0.01f;
  }
  return objOf(mesh);
}

class Progress : public ToolTest {
 protected:
  /// What a terminal is sent by a rendering that would take minutes, until it is interrupted: when
  /// `isEnough`, or after some seconds.
  std::string shown(std::vector<std::string> options,
                    const std::function<bool(const std::string&)>& isEnough) const {
    const Terminal terminal;
    options.insert(options.begin(), {"render", "--size", "200x150", "--samples", "65536"});
    ToolProcess tool(folder(), {.arguments = options, .standardError = terminal.name()});
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    std::string said;
    while (!isEnough(said) && std::chrono::steady_clock::now() < deadline)
      said += terminal.readSome();
    tool.signal(SIGINT);
    EXPECT_EQ(tool.wait().signal, SIGINT) << said;
    return said + terminal.readSome();
  }

 private:
  static constexpr std::chrono::seconds kPatience{20};
};

TEST_F(Progress, OfALongStepIsShownOnATerminalAndWipedOff) {
  const std::string said = shown({}, [](const std::string& text) {
    return text.find("rendering [") != std::string::npos && text.ends_with(" left");
  });
  const std::size_t line = said.find("rendering [");
  ASSERT_NE(line, std::string::npos) << said;
  EXPECT_NE(said.find("\r\x1b[Kplanetree: interrupted, and render.png has "), std::string::npos)
      << said;
  EXPECT_TRUE(said.ends_with(" of the picture\r\n")) << said;
}

TEST_F(Progress, OfABuildIsShownByASubcommandThatSaysNothingElse) {
  // A build of many seconds on any machine, of which many parts are done one after the other.
  writeFile("soup.obj", soupOfSmallTriangles(200'000));
  const Terminal terminal;
  ToolProcess tool(folder(),
                   {.arguments = {"info", "soup.obj", "--threads", "1", "--stops-by-cost", "off",
                                  "--leaf-size", "0", "--references-per-object", "8"},
                    .standardOutput = (streamFolder() / "page").string(),
                    .standardError = terminal.name()});
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds{60};
  std::string said;
  const auto showsBar = [&said] {
    const std::size_t line = said.rfind("building the tree [");
    return line != std::string::npos && said.find(" left", line) != std::string::npos;
  };
  while (!showsBar() && !tool.hasEnded() && std::chrono::steady_clock::now() < deadline)
    said += terminal.readSome();
  EXPECT_TRUE(showsBar()) << said;
  tool.signal(SIGINT);
  EXPECT_EQ(tool.wait().signal, SIGINT) << said;
  said += terminal.readSome();
  EXPECT_TRUE(said.ends_with("\r\x1b[Kplanetree: interrupted\r\n")) << said;
}

TEST_F(Progress, IsNotShownUnderQuiet) {
  const auto start = std::chrono::steady_clock::now();
  const std::string said = shown({"--quiet"}, [start](const std::string&) {
    return std::chrono::steady_clock::now() - start > std::chrono::milliseconds{1500};
  });
  EXPECT_TRUE(said.starts_with("\r\x1b[Kplanetree: interrupted")) << said;
  EXPECT_EQ(said.find('\n'), said.size() - 1) << said;
}

TEST_F(Progress, OfAShortStepIsNotShown) {
  const Terminal terminal;
  ToolProcess tool(folder(), {.arguments = {"render", "--size", "8x8", "--samples", "1"},
                              .standardError = terminal.name()});
  EXPECT_EQ(tool.wait().status, 0);
  const std::string said = terminal.readSome();
  EXPECT_NE(said.find("traced"), std::string::npos) << said;
  EXPECT_EQ(said.find("rendering ["), std::string::npos) << said;
}

TEST_F(Progress, IsNotShownInAFile) {
  ToolProcess tool(folder(), {.arguments = {"render", "--size", "200x150", "--samples", "65536"}});
  std::this_thread::sleep_for(std::chrono::milliseconds{1500});
  tool.signal(SIGINT);
  const ToolResult result = tool.wait();
  EXPECT_EQ(result.err.find("rendering ["), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace planetree::test
