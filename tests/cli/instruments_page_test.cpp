#include "tool_run.hpp"

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

// docs/instruments.md shows what the tool prints, and the picture that it draws: they are the
// golden ones. After a change that is meant to alter them, look at the new ones and keep them:
//
//     PLANETREE_UPDATE_GOLDENS=1 <build folder>/bin/cli --gtest_filter='InstrumentsPage.*'

namespace planetree::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRepository = PLANETREE_REPOSITORY;
const fs::path kPage = kRepository / "docs" / "instruments.md";
const fs::path kPicture = kRepository / "docs" / "images" / "hills-tree.svg";

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void replaceContent(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

bool isUpdating() {
  return std::getenv("PLANETREE_UPDATE_GOLDENS") != nullptr;
}

/// A command of the page, and where what it prints stands there.
struct Sample {
  std::vector<std::string> arguments;
  std::size_t outputStart = 0;
  std::size_t outputEnd = 0;
};

/// Every block of one command that a block of text follows.
std::vector<Sample> samplesOf(const std::string& page) {
  const std::string command = "```sh\nplanetree ";
  const std::string between = "\n```\n\n```text\n";
  std::vector<Sample> samples;
  for (std::size_t at = page.find(command); at != std::string::npos; at = page.find(command, at)) {
    at += command.size();
    const std::size_t lineEnd = page.find('\n', at);
    if (page.compare(lineEnd, between.size(), between) != 0)
      continue;
    std::istringstream words(page.substr(at, lineEnd - at));
    const std::size_t start = lineEnd + between.size();
    samples.push_back({.arguments = {std::istream_iterator<std::string>(words), {}},
                       .outputStart = start,
                       .outputEnd = page.find("```", start)});
  }
  return samples;
}

/// Times differ from run to run, and instruction sets from machine to machine.
std::string withoutMachine(const std::string& text) {
  const std::string timeless =
      std::regex_replace(text, std::regex("[0-9]+\\.[0-9]{4} s\n"), "(time)\n");
  return std::regex_replace(timeless, std::regex("  instruction set +.*\n"), "(sets)\n");
}

class InstrumentsPage : public ToolTest {
 protected:
  InstrumentsPage() {
    fs::create_directory(folder() / "data");
    fs::copy_file(kRepository / "data" / "hills.obj", folder() / "data" / "hills.obj");
  }
};

TEST_F(InstrumentsPage, ShowsWhatTheToolPrints) {
  std::string page = contentOf(kPage);
  const std::vector<Sample> samples = samplesOf(page);
  ASSERT_GE(samples.size(), 2u);
  // From the last to the first: what is put in moves what is behind it.
  for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample) {
    const ToolResult result = run(sample->arguments);
    ASSERT_EQ(result.status, 0) << result.err;
    const std::size_t length = sample->outputEnd - sample->outputStart;
    if (isUpdating()) {
      page.replace(sample->outputStart, length, result.out);
    } else {
      EXPECT_EQ(withoutMachine(page.substr(sample->outputStart, length)),
                withoutMachine(result.out))
          << "PLANETREE_UPDATE_GOLDENS=1 renews the page";
    }
  }
  if (isUpdating())
    replaceContent(kPage, page);
}

TEST_F(InstrumentsPage, ShowsThePictureThatTheToolDraws) {
  ASSERT_EQ(run({"info", "data/hills.obj", "--plot", "hills.svg", "--face-cost", "0.2"}).status, 0);
  const std::string picture = readFile("hills.svg");
  if (isUpdating())
    replaceContent(kPicture, picture);
  EXPECT_EQ(contentOf(kPicture), picture) << "PLANETREE_UPDATE_GOLDENS=1 renews it";
}

}  // namespace
}  // namespace planetree::test
