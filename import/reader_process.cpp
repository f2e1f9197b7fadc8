#include "import/reader_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <thread>
#include <utility>

namespace planetree::importing {
namespace {

void require(int error, const char* call) {
  if (error != 0)
    throw std::system_error(error, std::generic_category(), call);
}

class FileActions {
 public:
  FileActions() { require(::posix_spawn_file_actions_init(&actions_), "file actions"); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }

  void open(int stream, int flags) {
    require(::posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", flags, 0),
            "addopen");
  }
  void duplicate(int from, int to) {
    require(::posix_spawn_file_actions_adddup2(&actions_, from, to), "adddup2");
  }
  /// Descriptors that somebody opened without close-on-exec.
  void closeFrom(int first) {
    require(::posix_spawn_file_actions_addclosefrom_np(&actions_, first), "addclosefrom");
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const noexcept { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

class SpawnAttributes {
 public:
  SpawnAttributes() { require(::posix_spawnattr_init(&attributes_), "spawn attributes"); }
  SpawnAttributes(const SpawnAttributes&) = delete;
  SpawnAttributes& operator=(const SpawnAttributes&) = delete;
  ~SpawnAttributes() { ::posix_spawnattr_destroy(&attributes_); }

  /// No signal is blocked, and those that we ignore for ourselves do what they usually do.
  void resetSignals() {
    sigset_t none;
    ::sigemptyset(&none);
    sigset_t usual = none;
    ::sigaddset(&usual, SIGPIPE);
    ::sigaddset(&usual, SIGXFSZ);
    require(::posix_spawnattr_setsigmask(&attributes_, &none), "setsigmask");
    require(::posix_spawnattr_setsigdefault(&attributes_, &usual), "setsigdefault");
    constexpr short kFlags = POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF;
    require(::posix_spawnattr_setflags(&attributes_, kFlags), "setflags");
  }
  [[nodiscard]] const posix_spawnattr_t* get() const noexcept { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

/// Numbers with points and messages in English, whatever the user's language; of the user's own
/// variables only the one without which libraries may not be found.
std::vector<std::string> plainEnvironment() {
  std::vector<std::string> environment = {"LC_ALL=C"};
  if (const char* const libraries = std::getenv("LD_LIBRARY_PATH"))
    environment.push_back(std::string("LD_LIBRARY_PATH=") + libraries);
  return environment;
}

std::vector<char*> pointersTo(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

pid_t spawn(const std::string& program, std::vector<std::string> arguments, int output) {
  FileActions files;
  files.duplicate(output, STDOUT_FILENO);
  files.open(STDIN_FILENO, O_RDONLY);
  files.open(STDERR_FILENO, O_WRONLY);
  files.closeFrom(STDERR_FILENO + 1);
  SpawnAttributes attributes;
  attributes.resetSignals();
  arguments.insert(arguments.begin(), program);
  std::vector<std::string> environment = plainEnvironment();
  pid_t pid = -1;
  require(::posix_spawn(&pid, program.c_str(), files.get(), attributes.get(),
                        pointersTo(arguments).data(), pointersTo(environment).data()),
          program.c_str());
  return pid;
}

pid_t waitFor(pid_t pid, int& status, int options) noexcept {
  pid_t ended = -1;
  do {
    ended = ::waitpid(pid, &status, options);
  } while (ended < 0 && errno == EINTR);
  return ended;
}

/// Whether the program has ended, or does so before long. There is no waiting for a process with a
/// time limit that leaves the signals of the caller alone, so we look again and again.
bool endsWithin(std::chrono::milliseconds patience, pid_t pid, int& status) noexcept {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + patience;
  while (waitFor(pid, status, WNOHANG) == 0) {
    if (Clock::now() >= end)
      return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace

ReaderProcess::ReaderProcess(const std::filesystem::path& program,
                             std::vector<std::string> arguments) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    require(errno, "pipe");
  output_ = ends[0];
  try {
    pid_ = spawn(program.string(), std::move(arguments), ends[1]);
  } catch (...) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
  ::close(ends[1]);
}

ReaderProcess::~ReaderProcess() {
  finish(std::chrono::milliseconds(0));
}

std::optional<int> ReaderProcess::finish(std::chrono::milliseconds patience) noexcept {
  if (pid_ < 0)
    return std::nullopt;
  const pid_t pid = std::exchange(pid_, -1);
  ::close(std::exchange(output_, -1));
  int status = 0;
  if (endsWithin(patience, pid, status))
    return WIFSIGNALED(status) ? std::optional<int>(WTERMSIG(status)) : std::nullopt;
  ::kill(pid, SIGKILL);
  waitFor(pid, status, 0);
  return std::nullopt;
}

}  // namespace planetree::importing
