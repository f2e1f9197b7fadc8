#pragma once

#include <gtest/gtest.h>

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planetree::test {

/// What the tool left when it ended.
struct ToolResult {
  int status = -1;  ///< exit status; -1 if a signal ended it
  int signal = 0;   ///< the signal that ended it
  std::string out;
  std::string err;
  std::uint64_t peakBytes = 0;  ///< the most memory that it held at once
};

/// How to start the tool.
struct ToolStart {
  std::vector<std::string> arguments;
  std::optional<std::uint64_t> largestFile = {};  ///< bytes, as on a disk that is nearly full
  std::string standardOutput = {};                ///< a file to use in place of the captured one
  std::string standardError = {};                 ///< likewise
  std::string standardInput = {};                 ///< a file to read in place of the test's own
  std::vector<std::string> environment = {};      ///< "NAME=value", before that of the test
  bool appendsOutput = false;  ///< standard output is opened as by the shell's >>
};

/// A running tool; `wait` ends it.
class ToolProcess {
 public:
  ToolProcess(const std::filesystem::path& folder, const ToolStart& start);
  ToolProcess(const ToolProcess&) = delete;
  ToolProcess& operator=(const ToolProcess&) = delete;
  ~ToolProcess();

  void signal(int number) const;
  [[nodiscard]] ToolResult wait();
  /// Whether it has ended already; `wait` still has to be called.
  [[nodiscard]] bool hasEnded() const;
  /// What it has said on standard error so far.
  [[nodiscard]] std::string errSoFar() const;

 private:
  std::filesystem::path out_;
  std::filesystem::path err_;
  pid_t pid_ = -1;
};

/// Runs the tool in an empty folder of its own, which goes with the test.
class ToolTest : public testing::Test {
 protected:
  ToolTest();
  ~ToolTest() override;

  /// The tool's current folder.
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::vector<std::string> filesInFolder() const;

  [[nodiscard]] ToolResult run(std::vector<std::string> arguments) const;
  [[nodiscard]] ToolResult run(const ToolStart& start) const;
  /// A small, quick picture: `planetree render` with these arguments besides.
  [[nodiscard]] ToolResult runSmall(std::vector<std::string> arguments) const;

  void writeFile(const std::string& name, const std::string& text) const;
  [[nodiscard]] std::string readFile(const std::string& name) const;
  /// An OBJ file with two triangles of size 1.
  void writeModel(const std::string& name) const;

  /// Where standard output and error of the tool go; outside of `folder()`.
  [[nodiscard]] const std::filesystem::path& streamFolder() const { return streamFolder_; }

 private:
  std::filesystem::path base_;
  std::filesystem::path folder_;
  std::filesystem::path streamFolder_;
};

/// Whether the bytes are a complete PNG file of this size.
[[nodiscard]] testing::AssertionResult isPng(const std::string& bytes, std::uint32_t width,
                                             std::uint32_t height);

}  // namespace planetree::test
