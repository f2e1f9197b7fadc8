#include "tool_start.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <thread>

namespace planetree::test {
namespace {

void require(bool isDone, const char* call) {
  if (!isDone)
    throw std::system_error(errno, std::generic_category(), call);
}

struct Pipe {
  std::array<int, 2> ends = {-1, -1};

  Pipe() { require(::pipe2(ends.data(), O_CLOEXEC) == 0, "pipe"); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close(0);
    close(1);
  }
  void close(std::size_t end) {
    if (ends[end] >= 0)
      ::close(ends[end]);
    ends[end] = -1;
  }
  /// What comes until `most` bytes have come, or no more.
  [[nodiscard]] std::string read(std::size_t most) const {
    std::string bytes;
    std::array<char, 4096> some;
    while (bytes.size() < most) {
      const ssize_t count =
          ::read(ends[0], some.data(), std::min(some.size(), most - bytes.size()));
      if (count <= 0)
        break;
      bytes.append(some.data(), static_cast<std::size_t>(count));
    }
    return bytes;
  }
};

void setLimit(decltype(RLIMIT_AS) resource, const std::optional<std::uint64_t>& most) {
  if (!most)
    return;
  const rlimit limit{.rlim_cur = *most, .rlim_max = *most};
  if (::setrlimit(resource, &limit) != 0)
    ::_exit(126);
}

/// In the new process, where only calls that are safe after fork may be made.
[[noreturn]] void become(const OutputStart& start, std::vector<char*>& arguments, int out,
                         int err) {
  if (!start.standardInput.empty())
    ::dup2(::open(start.standardInput.c_str(), O_RDWR | O_CLOEXEC), STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  for (const int stream : start.closedStreams)
    ::close(stream);
  if (::chdir(start.folder.c_str()) != 0)
    ::_exit(126);
  std::signal(SIGPIPE, start.ignoresClosedPipes ? SIG_IGN : SIG_DFL);
  setLimit(RLIMIT_FSIZE, start.largestFile);
  setLimit(RLIMIT_AS, start.memory);
  // A program that is ended by a signal need not leave its memory.
  setLimit(RLIMIT_CORE, 0);
  ::execv(arguments.front(), arguments.data());
  ::_exit(127);
}

}  // namespace

OutputResult run(const OutputStart& start) {
  std::vector<std::string> words = {start.program};
  words.insert(words.end(), start.arguments.begin(), start.arguments.end());
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);

  Pipe out;
  Pipe err;
  int file = -1;
  if (!start.standardOutput.empty()) {
    file = ::open(start.standardOutput.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    require(file >= 0, start.standardOutput.c_str());
  }
  const pid_t pid = ::fork();
  if (pid == 0)
    become(start, arguments, file >= 0 ? file : out.ends[1], err.ends[1]);
  require(pid > 0, "fork");
  if (file >= 0)
    ::close(file);
  out.close(1);
  err.close(1);

  OutputResult result;
  std::thread reader([&] { result.err = err.read(std::string::npos); });
  result.out = out.read(start.readBytes.value_or(std::string::npos));
  out.close(0);
  reader.join();
  int status = 0;
  ::waitpid(pid, &status, 0);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return result;
}

}  // namespace planetree::test
