#include "import/read_with_assimp.hpp"

#include "answers.hpp"
#include "model_folder.hpp"
#include "sample_models.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <chrono>
#include <cstdint>
#include <limits>
#include <string>
#include <thread>

// The program that reads is a shell script here, so that it can crash, hang and lie.

namespace planetree::test {
namespace {

using namespace importing;
using std::chrono::milliseconds;

class ReadWithAssimp : public ModelFolder {
 protected:
  /// Reads a model by a script in place of planetree-assimp.
  TriangleMesh<float> readBy(const std::string& script, ImportReport* report = nullptr) const {
    ReaderLimits limits = limits_;
    limits.program = writeScript("reader", script);
    return readWithAssimp<float>(path_, limits, report);
  }

  /// Reads a model by a program that gives this answer.
  TriangleMesh<float> readAnswer(const std::string& answer, ImportReport* report = nullptr) const {
    const std::filesystem::path file = write("answer", answer);
    return readBy("exec cat '" + file.string() + "'", report);
  }

  void expectFault(const std::string& script, ErrorCode code, const std::string& words) const {
    expectError([&] { return readBy(script); }, path_, code, words);
  }

  void expectUnclear(const std::string& answer, const std::string& words) const {
    expectError([&] { return readAnswer(answer); }, path_, ErrorCode::MalformedFile, words);
  }

  const std::filesystem::path path_ = "model.glb";
  ReaderLimits limits_ = {.program = {}, .time = milliseconds(20'000), .memory = 1u << 30};
};

TEST_F(ReadWithAssimp, TakesTheMeshThatTheProgramTellsOf) {
  ImportReport report;
  const TriangleMesh<float> mesh =
      readAnswer(kStart + message(MessageKind::Format, "Parrot") + kTriangle +
                     message(MessageKind::Remark, "a\nbird") + polygons({3, 0, 1}) +
                     polygons({2, 4, 0, 1, 2, 0}) +
                     message(MessageKind::Unread, bytesOf(std::uint64_t{7})) + kEnd,
                 &report);
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.faces.size(), 3u);
  EXPECT_EQ(report.polygonCount, 2u);
  EXPECT_EQ(report.formatName, "Parrot");
  EXPECT_EQ(report.unreadPrimitiveCount, 7u);
  EXPECT_EQ(report.remarks, std::vector<std::string>{"a bird"});
}

TEST_F(ReadWithAssimp, SkipsAndCountsPolygonsWithoutTheirVertices) {
  ImportReport report;
  const TriangleMesh<float> mesh =
      readAnswer(kStart + kTriangle + polygons({3, 0, 1, 3, 0, 3, 0, 1, 2, 3, 0, 1, 0xFFFFFFFFu}) +
                     message(MessageKind::Mesh) + polygons({3, 0, 1, 2}) + kEnd,
                 &report);
  EXPECT_EQ(mesh.faces.size(), 1u);
  EXPECT_EQ(mesh.sourceFace(0), 2u);
  EXPECT_EQ(report.polygonCount, 5u);
  EXPECT_EQ(report.skippedPolygonCount, 4u);
  ASSERT_EQ(report.skipped.size(), 4u);
  EXPECT_EQ(report.skipped[0].reason, "refers to vertex 3, which does not exist");
  EXPECT_EQ(report.skipped[1].reason, "has fewer than three corners");
  EXPECT_EQ(report.skipped[3].reason, "refers to vertex 0, which does not exist");
}

TEST_F(ReadWithAssimp, PassesFailuresOn) {
  const std::string start(kGreeting);
  const auto expectPassedOn = [&](FailureKind kind, const std::string& text, ErrorCode code,
                                  const std::string& words) {
    expectError([&] { return readAnswer(start + failure(kind, text)); }, path_, code, words);
  };
  expectPassedOn(FailureKind::Malformed, "no\x1B[1m\nhead.", ErrorCode::MalformedFile,
                 "cannot be read: no [1m head. ");
  expectPassedOn(FailureKind::OutOfMemory, "", ErrorCode::MalformedFile, "more memory");
  expectPassedOn(FailureKind::TooLarge, "", ErrorCode::CapacityExceeded, "more vertices");
  expectPassedOn(FailureKind::UnknownFormat, "", ErrorCode::UnknownFormat, "none of the formats");
}

TEST_F(ReadWithAssimp, TellsOfCrashes) {
  expectFault("kill -SEGV $$", ErrorCode::MalformedFile,
              "assimp crashes on it (Segmentation fault)");
  expectFault("kill -ABRT $$", ErrorCode::MalformedFile, "assimp crashes on it (Aborted)");
  expectFault("printf 'planetree reads\\n'; kill -FPE $$", ErrorCode::MalformedFile,
              "assimp crashes on it (Floating point exception)");
  expectFault("kill -KILL $$", ErrorCode::MalformedFile, "killed while reading");
  expectFault("kill -INT $$", ErrorCode::FileNotReadable, "interrupted");
}

TEST_F(ReadWithAssimp, EndsProgramsThatTakeTooLong) {
  limits_.time = milliseconds(300);
  const auto start = std::chrono::steady_clock::now();
  expectFault("exec sleep 60", ErrorCode::MalformedFile, "did not get to its end within 1 s");
  expectFault("while :; do :; done", ErrorCode::MalformedFile, "did not get to its end");
  // One that says something now and then takes too long none the less.
  const std::filesystem::path remark = write("remark", message(MessageKind::Remark, "busy"));
  expectFault("printf 'planetree reads\\n'; while :; do cat '" + remark.string() + "'; done",
              ErrorCode::MalformedFile, "did not get to its end");
  // And so does one that closes its output.
  expectFault("exec >&-; exec sleep 60", ErrorCode::MalformedFile, "end too early");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST_F(ReadWithAssimp, RefusesAnswersThatBreakTheRules) {
  expectUnclear("", "end too early");
  expectUnclear("Hello, world! What is it?", "greeting");
  expectUnclear(std::string(kGreeting), "end too early");
  expectUnclear(kStart + kTriangle, "end too early");
  expectUnclear(std::string(kGreeting) + message(static_cast<MessageKind>(99)), "unknown kind");
  expectUnclear(std::string(kGreeting) + bytesOf(MessageKind::Vertices) + bytesOf(0xFFFFFFFFu),
                "too long");
  expectUnclear(kStart + message(MessageKind::Vertices, "12345"), "three coordinates");
  expectUnclear(kStart + message(MessageKind::Polygons, "12345"), "too short");
  expectUnclear(kStart + message(MessageKind::Unread, "1"), "too short");
  expectUnclear(kStart + kTriangle + polygons({0xFFFFFFFFu, 0, 1, 2}) + kEnd, "lacks corners");
  expectUnclear(kStart + kTriangle + polygons({4, 0}) + message(MessageKind::Mesh) + kEnd,
                "lacks corners");
  expectUnclear(std::string(kGreeting) + message(MessageKind::Failure, ""), "too short");
  expectUnclear(std::string(kGreeting) + failure(static_cast<FailureKind>(9), ""), "unknown kind");
}

TEST_F(ReadWithAssimp, TakesAllPrefixesAndChangesOfAnAnswerInOrder) {
  const std::string answer = kStart + kTriangle + polygons({3, 0, 1, 2}) + kEnd;
  for (std::size_t length = 0; length < answer.size(); length += 7) {
    EXPECT_THROW(static_cast<void>(readAnswer(answer.substr(0, length))), Error) << length;
  }
  for (std::size_t i = 0; i < answer.size(); i += 3) {
    std::string changed = answer;
    changed[i] = static_cast<char>(~changed[i]);
    try {
      const TriangleMesh<float> mesh = readAnswer(changed);
      for (const FaceIndices& face : mesh.faces) {
        for (const std::uint32_t vertex : face)
          EXPECT_LT(vertex, mesh.positions.size());
      }
    } catch (const Error& error) {
      EXPECT_FALSE(error.advice().empty());
    }
  }
}

TEST_F(ReadWithAssimp, NamesAProgramThatIsMissing) {
  limits_.program = folder() / "nowhere";
  expectError([&] { return readWithAssimp<float>(path_, limits_); }, path_,
              ErrorCode::FileNotReadable, "nowhere, which cannot be started: No such file");
}

TEST_F(ReadWithAssimp, GivesTheProgramNothingButWhatItNeeds) {
  // No open files beyond the three streams, nothing to read, no noise, a plain environment, and no
  // signal ignored.
  struct sigaction ignored = {};
  ignored.sa_handler = SIG_IGN;
  struct sigaction before = {};
  ::sigaction(SIGPIPE, &ignored, &before);
  const int opened = ::open("/dev/null", O_RDONLY);
  const int leaked =
      ::fcntl(opened, F_DUPFD, 77);  // without close-on-exec, and above the shell's own
  ::close(opened);
  const std::filesystem::path seen = folder() / "seen";
  expectFault("exec 3>'" + seen.string() + "'; ls /proc/$$/fd | grep " + std::to_string(leaked) +
                  " >&3; read line || echo nothing >&3; echo noise >&2; "
                  "echo ${HOME-no home} $LC_ALL >&3; kill -PIPE $$; echo here >&3",
              ErrorCode::MalformedFile, "crashes on it (Broken pipe)");
  ::close(leaked);
  ::sigaction(SIGPIPE, &before, nullptr);
  std::ifstream file(seen);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "nothing");
  std::getline(file, line);
  EXPECT_EQ(line, "no home C");
  EXPECT_FALSE(std::getline(file, line)) << line;
}

TEST_F(ReadWithAssimp, LeavesNoProcessBehind) {
  limits_.time = milliseconds(100);
  expectFault("kill -SEGV $$", ErrorCode::MalformedFile, "crashes");
  expectFault("exec sleep 60", ErrorCode::MalformedFile, "end");
  static_cast<void>(readAnswer(kStart + kEnd));
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST_F(ReadWithAssimp, BoundsTheMemoryOfTheRealProgram) {
  ReaderLimits limits = usualLimits(0);
  limits.memory = 8u << 20;  // not even enough to begin with
  std::string triangles;
  for (int i = 0; i < 50'000; ++i)
    triangles += "0 0 0 1 0 0 0 1 0\n";
  const std::filesystem::path path = write("triangles.raw", triangles);
  try {
    static_cast<void>(readWithAssimp<float>(path, limits));
    GTEST_SKIP() << "the program runs under a sanitizer, which has limits of its own";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::MalformedFile);
    EXPECT_NE(std::string(error.what()).find("memory"), std::string::npos) << error.what();
  }
}

TEST_F(ReadWithAssimp, AnswersFilesThatPromiseMoreThanTheyHold) {
  std::string nodes = gltfNodes();
  const std::string count = "\"count\": 4";
  nodes.replace(nodes.find(count), count.size(), "\"count\": 2147483647");
  const std::filesystem::path path = write("square.glb", glb(nodes, squareBuffer()));
  expectError([&] { return readWithAssimp<float>(path, usualLimits(0)); }, path,
              ErrorCode::MalformedFile, "");
}

TEST_F(ReadWithAssimp, LimitsGrowWithTheFile) {
  const ReaderLimits small = usualLimits(0);
  const ReaderLimits large = usualLimits(std::uint64_t{1} << 30);
  EXPECT_EQ(small.program.filename(), "planetree-assimp");
  EXPECT_LT(small.time, large.time);
  EXPECT_LE(small.memory, large.memory);
}

TEST_F(ReadWithAssimp, EndsTheProgramWithItsParent) {
  // A process that starts the real program on a pipe that nobody writes to, and is then killed.
  const std::filesystem::path pipe = folder() / "model.raw";
  const ReaderLimits limits = usualLimits(0);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string memory = std::to_string(limits.memory);
  const std::filesystem::path parent =
      writeScript("parent", "mkfifo '" + pipe.string() + "'; '" + limits.program.string() + "' '" +
                                pipe.string() + "' " + memory + " $$ & kill -KILL $$");
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    ::execl(parent.c_str(), parent.c_str(), nullptr);
    ::_exit(127);
  }
  ::close(ends[1]);
  ::waitpid(child, nullptr, 0);
  // The pipe ends when the last of the two has gone.
  std::array<char, 256> bytes;
  while (::read(ends[0], bytes.data(), bytes.size()) > 0) {
  }
  ::close(ends[0]);
}

}  // namespace
}  // namespace planetree::test
