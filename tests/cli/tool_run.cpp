#include "tool_run.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace planetree::test {

namespace fs = std::filesystem;

namespace {

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void redirect(int stream, const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_NOCTTY, 0600);
  if (file < 0 || ::dup2(file, stream) < 0)
    ::_exit(126);
}

/// In the new process, where only calls that are safe after fork may be made.
[[noreturn]] void becomeTool(const fs::path& folder, const ToolStart& start, const std::string& out,
                             const std::string& err, std::vector<char*>& arguments,
                             std::vector<char*>& environment) {
  constexpr int kWriting = O_WRONLY | O_CREAT;
  redirect(STDOUT_FILENO, out, kWriting | (start.appendsOutput ? O_APPEND : O_TRUNC));
  redirect(STDERR_FILENO, err, kWriting | O_TRUNC);
  if (!start.standardInput.empty())
    redirect(STDIN_FILENO, start.standardInput, O_RDONLY);
  if (::chdir(folder.c_str()) != 0)
    ::_exit(126);
  if (start.largestFile) {
    const rlimit limit{.rlim_cur = *start.largestFile, .rlim_max = *start.largestFile};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0)
      ::_exit(126);
  }
  ::execve(PLANETREE_TOOL, arguments.data(), environment.data());
  ::_exit(127);
}

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = at; i < at + 4; ++i) {
    number = number << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return number;
}

}  // namespace

ToolProcess::ToolProcess(const fs::path& folder, const ToolStart& start)
    : out_(folder.parent_path() / "streams" / "out"),
      err_(folder.parent_path() / "streams" / "err") {
  std::vector<std::string> words = {PLANETREE_TOOL};
  words.insert(words.end(), start.arguments.begin(), start.arguments.end());
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::vector<std::string> variables = start.environment;
  std::vector<char*> environment;
  for (std::string& variable : variables)
    environment.push_back(variable.data());
  for (char** variable = ::environ; *variable != nullptr; ++variable)
    environment.push_back(*variable);
  environment.push_back(nullptr);
  const std::string out = start.standardOutput.empty() ? out_.string() : start.standardOutput;
  const std::string err = start.standardError.empty() ? err_.string() : start.standardError;
  pid_ = ::fork();
  if (pid_ == 0)
    becomeTool(folder, start, out, err, arguments, environment);
  if (pid_ < 0)
    throw std::system_error(errno, std::generic_category(), "fork");
}

ToolProcess::~ToolProcess() {
  if (pid_ <= 0)
    return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void ToolProcess::signal(int number) const {
  ::kill(pid_, number);
}

ToolResult ToolProcess::wait() {
  int status = 0;
  rusage usage = {};
  ::wait4(std::exchange(pid_, -1), &status, 0, &usage);
  return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0,
          .out = contentOf(out_),
          .err = contentOf(err_),
          .peakBytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024};
}

bool ToolProcess::hasEnded() const {
  siginfo_t info = {};
  constexpr int kWithoutReaping = WEXITED | WNOHANG | WNOWAIT;
  return ::waitid(P_PID, static_cast<id_t>(pid_), &info, kWithoutReaping) == 0 && info.si_pid != 0;
}

std::string ToolProcess::errSoFar() const {
  return contentOf(err_);
}

ToolTest::ToolTest() {
  std::string pattern = (fs::temp_directory_path() / "planetree-cli-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr)
    throw std::runtime_error("no temporary folder");
  base_ = pattern;
  folder_ = base_ / "work";
  streamFolder_ = base_ / "streams";
  fs::create_directory(folder_);
  fs::create_directory(streamFolder_);
}

ToolTest::~ToolTest() {
  std::error_code ignored;
  fs::remove_all(base_, ignored);
}

std::vector<std::string> ToolTest::filesInFolder() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

ToolResult ToolTest::run(std::vector<std::string> arguments) const {
  return run(ToolStart{.arguments = std::move(arguments)});
}

ToolResult ToolTest::run(const ToolStart& start) const {
  return ToolProcess(folder_, start).wait();
}

ToolResult ToolTest::runSmall(std::vector<std::string> arguments) const {
  std::vector<std::string> all = {"render", "--samples", "1"};
  if (std::find(arguments.begin(), arguments.end(), "--size") == arguments.end()) {
    all.insert(all.end(), {"--size", "24x16"});
  }
  all.insert(all.end(), arguments.begin(), arguments.end());
  return run(std::move(all));
}

void ToolTest::writeFile(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string ToolTest::readFile(const std::string& name) const {
  return contentOf(folder_ / name);
}

void ToolTest::writeModel(const std::string& name) const {
  writeFile(name,
            "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0.5\n"
            "f 1 2 3\nf 1 3 4\n");
}

testing::AssertionResult isPng(const std::string& bytes, std::uint32_t width,
                               std::uint32_t height) {
  const std::string start = "\x89PNG\r\n\x1a\n";
  const std::string end("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  if (bytes.size() < 24 || bytes.compare(0, start.size(), start) != 0) {
    return testing::AssertionFailure() << "no PNG file";
  }
  if (bytes.compare(bytes.size() - end.size(), end.size(), end) != 0) {
    return testing::AssertionFailure() << "a PNG file without its end";
  }
  if (bigEndian(bytes, 16) != width || bigEndian(bytes, 20) != height) {
    return testing::AssertionFailure()
           << "a PNG of " << bigEndian(bytes, 16) << " x " << bigEndian(bytes, 20);
  }
  return testing::AssertionSuccess();
}

}  // namespace planetree::test
