#include "bits_of.hpp"
#include "fault_folder.hpp"
#include "fault_tally.hpp"
#include "memory_faults.hpp"

#include "import/import_mesh.hpp"
#include "import/message.hpp"
#include "import/read_with_assimp.hpp"
#include "unit/import/sample_models.hpp"

#include <planetree/error.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

/// planetree-assimp dies, says nonsense, or cannot be started. More is in tests/unit/import.
namespace planetree::test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

/// The processes that this one has started.
std::vector<pid_t> children() {
  std::ifstream list("/proc/self/task/" + std::to_string(::getpid()) + "/children");
  std::vector<pid_t> found;
  for (pid_t pid = 0; list >> pid;)
    found.push_back(pid);
  return found;
}

class DyingReader : public FaultFolder {
 protected:
  DyingReader() : path_(write("square.glb", glb(gltfNodes(), squareBuffer()))) {
    limits_ = importing::usualLimits(0);
    // What the real program answers.
    expected_ = bitsOf(importing::readWithAssimp<float>(path_, limits_));
  }
  ~DyingReader() override {
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a process was left behind";
    EXPECT_EQ(errno, ECHILD);
  }

  void useScript(const std::string& lines) {
    limits_.program = write("reader", "#!/bin/sh\n" + lines + "\n");
    fs::permissions(limits_.program, fs::perms::owner_all);
  }

  /// The real program, as a word of a script that stands in for it.
  [[nodiscard]] static std::string real() {
    return "'" + importing::usualLimits(0).program.string() + "' \"$1\" \"$2\" $$";
  }

  /// Reads once: the whole mesh, or an error that names the file and these words.
  void tryRead(const std::string& name, bool mayBeWhole, const std::string& words = {}) {
    const HeldMemory before = heldMemory();
    const std::size_t fileCount = openFileCount();
    std::string fault;
    try {
      const TriangleMesh<float> mesh = importing::readWithAssimp<float>(path_, limits_);
      if (!mayBeWhole || bitsOf(mesh) != expected_)
        fault = "a mesh";
    } catch (const Error& error) {
      const std::string text = error.what();
      if (error.file() != path_.string() || error.advice().empty() ||
          text.find(words) == std::string::npos)
        fault = text;
      wasRefused_ = true;
    }
    const bool isHeld = !othersUseMemory_ && fault.empty() && heldMemory() != before;
    ++faultTally().injectedCount;
    if (!fault.empty())
      reportLost(name + ": " + fault);
    if (isHeld || openFileCount() != fileCount || !children().empty())
      reportLeak(name);
  }

  fs::path path_;
  importing::ReaderLimits limits_;
  std::string expected_;
  bool wasRefused_ = false;
  bool othersUseMemory_ = false;
};

TEST_F(DyingReader, AtAnyByteOfItsAnswerIsTold) {
  // It may not write to files itself.
  useScript(real() + " | cat > '" + (folder() / "answer").string() + "'");
  tryRead("an answer that goes elsewhere", false, "end too early");
  const std::string answer = read("answer");
  ASSERT_GT(answer.size(), 100u);
  for (const std::uint64_t length : someOf(answer.size(), 12)) {
    write("part", answer.substr(0, length - 1));
    const std::string say = "cat '" + (folder() / "part").string() + "'; ";
    const std::string name = "byte " + std::to_string(length);
    useScript(say + "kill -KILL $$");
    tryRead(name + ", killed", false, "was killed");
    useScript(say + "exit 3");
    tryRead(name + ", ended", false, "end too early");
  }
  // All has been told: what becomes of it then is no matter.
  for (const char* end : {"kill -KILL $$", "exit 3", "cat /dev/zero", "exec sleep 60"}) {
    useScript("cat '" + (folder() / "answer").string() + "'; " + end);
    tryRead(std::string("all, then ") + end, true);
  }
}

TEST_F(DyingReader, WithNonsenseInItsAnswerIsTold) {
  for (const char* source : {"/dev/urandom", "/dev/zero", "/dev/null"}) {
    useScript("exec head -c 1000000 " + std::string(source));
    tryRead(source, false, "gave no clear answer");
    useScript("printf 'planetree reads\\n'; exec head -c 1000000 " + std::string(source));
    tryRead(std::string("greeting and ") + source, false);
  }
}

TEST_F(DyingReader, KilledAtAnyMomentIsTold) {
  // Large enough that there are moments.
  std::string triangles;
  for (int i = 0; i < 20'000; ++i) {
    const std::string x = std::to_string(i);
    triangles += x + " 0 0 " + x + " 1 0 " + x + " 0 1\n";
  }
  path_ = write("triangles.raw", triangles);
  const auto start = std::chrono::steady_clock::now();
  expected_ = bitsOf(importing::readWithAssimp<float>(path_, limits_));
  const auto whole = std::chrono::steady_clock::now() - start;
  othersUseMemory_ = true;
  const int rounds = triesEveryFault() ? 400 : 20;
  for (int i = 0; i < rounds; ++i) {
    std::atomic<bool> isDone = false;
    std::thread killer([&] {
      std::this_thread::sleep_for(whole * i / rounds);
      while (!isDone) {
        for (const pid_t child : children())
          ::kill(child, SIGKILL);
        std::this_thread::sleep_for(milliseconds(1));
      }
    });
    tryRead("killed at moment " + std::to_string(i), true);
    isDone = true;
    killer.join();
  }
  EXPECT_TRUE(wasRefused_);
}

TEST_F(DyingReader, ThatCannotBeStartedIsNamed) {
  limits_.program = folder() / "missing";
  tryRead("missing", false, "missing, which cannot be started: No such file");
  limits_.program = folder();
  tryRead("a folder", false, "cannot be started: Permission denied");
  limits_.program = write("text", "no program\n");
  tryRead("no permission", false, "cannot be started: Permission denied");
  fs::permissions(limits_.program, fs::perms::owner_all);
  tryRead("no program", false, "cannot be started: Exec format error");
}

TEST_F(DyingReader, WithoutAnyMoreFilesIsTold) {
#ifdef PLANETREE_HAS_SANITIZER
  GTEST_SKIP() << "sanitizers open pipes to find out which addresses can be read";
#endif
  rlimit usual = {};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &usual), 0);
  // Everything may be opened but the pipe, or but one end of it.
  const auto used = static_cast<rlim_t>(::dup(STDIN_FILENO));
  ::close(static_cast<int>(used));
  for (const rlim_t more : {0u, 1u, 2u}) {
    std::string told;
    rlimit few = usual;
    few.rlim_cur = used + more;
    ::setrlimit(RLIMIT_NOFILE, &few);
    try {
      static_cast<void>(importing::readWithAssimp<float>(path_, limits_));
      told = "a mesh";
    } catch (const Error& error) {
      told = error.what();
    }
    ::setrlimit(RLIMIT_NOFILE, &usual);
    ++faultTally().injectedCount;
    if (more < 2 && told.find("Too many open files") == std::string::npos)
      reportLost(told);
  }
  tryRead("afterwards", true);
}

}  // namespace
}  // namespace planetree::test
