#include "trace_test.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <system_error>
#include <thread>

namespace planetree::test {
namespace {

using namespace std::chrono_literals;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kCountsMemory = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kCountsMemory = false;
#else
constexpr bool kCountsMemory = true;
#endif
#else
constexpr bool kCountsMemory = true;
#endif

/// One end of a pipe with a name. Both ends wait for each other when they are opened.
class PipeEnd {
 public:
  PipeEnd(const std::filesystem::path& path, int flags) : file_(::open(path.c_str(), flags)) {
    if (file_ < 0)
      throw std::system_error(errno, std::generic_category(), path.string());
  }
  PipeEnd(const PipeEnd&) = delete;
  PipeEnd& operator=(const PipeEnd&) = delete;
  ~PipeEnd() { close(); }

  /// False if nobody reads any more.
  bool write(const std::string& bytes) const {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
      if (count < 0)
        return false;
      done += static_cast<std::size_t>(count);
    }
    return true;
  }

  /// What has arrived, waiting for the first of it; empty at the end.
  [[nodiscard]] std::string readSome() const {
    std::string bytes(4096, '\0');
    const ssize_t count = ::read(file_, bytes.data(), bytes.size());
    bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return bytes;
  }

  void close() {
    if (file_ >= 0)
      ::close(file_);
    file_ = -1;
  }

 private:
  int file_;
};

class TraceStream : public TraceTest {
 protected:
  TraceStream() {
    // A pipe whose reader ended is an error of the write, not the end of the test.
    std::signal(SIGPIPE, SIG_IGN);
    makePipe("in");
    makePipe("out");
  }

  void makePipe(const std::string& name) const {
    if (::mkfifo(pipe(name).c_str(), 0600) != 0)
      throw std::system_error(errno, std::generic_category(), name);
  }
  [[nodiscard]] std::filesystem::path pipe(const std::string& name) const {
    return streamFolder() / ("pipe-" + name);
  }

  /// Sends `count` rays, a few at a time, and returns what the tool did.
  ToolResult traceFromPipe(std::size_t count, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"trace", "roof.obj", "-", "-q", "--threads", "2"});
    ToolProcess tool(folder(), {.arguments = arguments, .standardInput = pipe("in").string()});
    PipeEnd rays(pipe("in"), O_WRONLY);
    rays.write(npyRayHeader<float>(count));
    const Rayf ray{.origin = {0.25f, 0.5f, 2}, .direction = {0, 0, -1}};
    const std::vector<Rayf> some(1000, ray);
    for (std::size_t sent = 0; sent < count; sent += some.size()) {
      const std::size_t bytes = std::min(some.size(), count - sent) * sizeof(Rayf);
      if (!rays.write({reinterpret_cast<const char*>(some.data()), bytes}))
        break;
    }
    rays.close();
    return tool.wait();
  }
};

TEST_F(TraceStream, AMillionRaysTakeNoMoreMemoryThanAThousand) {
  const ToolResult few = traceFromPipe(1000, {"-o", "few.npy"});
  const ToolResult many = traceFromPipe(1'000'000, {"-o", "many.npy"});
  EXPECT_EQ(few.status, 0) << few.err;
  EXPECT_EQ(many.status, 0) << many.err;
  const std::string table = readFile("many.npy");
  EXPECT_NE(table.find("'shape': (1000000,)"), std::string::npos);
  const std::vector<Hitf> hits = hitsOfNpy<float>(table);
  ASSERT_EQ(hits.size(), 1'000'000u);
  EXPECT_TRUE(std::all_of(hits.begin(), hits.end(),
                          [](const Hitf& hit) { return hit.primitive == 1 && hit.t == 1.75f; }));
  // The rays are 32 MB and so are the hits; the blocks at hand are a few.
  if (kCountsMemory) {
    EXPECT_LT(many.peakBytes, few.peakBytes + 16'000'000);
  }
}

TEST_F(TraceStream, ATableToAPipeHasItsLengthIfTheRaysTellTheirs) {
  std::string table;
  std::thread reader([&] {
    const PipeEnd hits(pipe("out"), O_RDONLY);
    for (std::string some = hits.readSome(); !some.empty(); some = hits.readSome())
      table += some;
  });
  writeFile("rays.npy", npyOf(randomRays<float>(41, 5000)));
  const ToolResult result = run(ToolStart{.arguments = {"trace", "roof.obj", "rays.npy", "-q"},
                                          .standardOutput = pipe("out").string()});
  reader.join();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(trace({"rays.npy", "-o", "hits.npy"}).status, 0);
  EXPECT_TRUE(table == readFile("hits.npy"));
}

TEST_F(TraceStream, ATableOfUnknownLengthIsRefusedForAPipeBeforeAnyWork) {
  const PipeEnd hits(pipe("out"), O_RDONLY | O_NONBLOCK);
  writeFile("rays.npy", npyOf(randomRays<float>(42, 3)));
  const std::vector<std::vector<std::string>> commands = {
      {"trace", "roof.obj", "rays.csv", "--format", "npy"},
      {"trace", "roof.obj", "rays.npy", "--all"}};
  for (const std::vector<std::string>& arguments : commands) {
    const ToolResult result =
        run(ToolStart{.arguments = arguments, .standardOutput = pipe("out").string()});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err.rfind("planetree: --format npy: ", 0), 0u) << result.err;
    EXPECT_NE(result.err.find("-o hits.npy"), std::string::npos) << result.err;
  }
}

TEST_F(TraceStream, ATableOfUnknownLengthIsRefusedWhereEverythingIsAppended) {
  writeFile("log", "older lines\n");
  const auto append = [&](const char* format) {
    return run(ToolStart{.arguments = {"trace", "roof.obj", "rays.csv", "-q", "--format", format},
                         .standardOutput = (folder() / "log").string(),
                         .appendsOutput = true});
  };
  EXPECT_EQ(append("npy").status, 2);
  EXPECT_EQ(readFile("log"), "older lines\n");
  EXPECT_EQ(append("csv").status, 0);
  EXPECT_EQ(readFile("log"), std::string("older lines\n") + kTwoHits);
}

TEST_F(TraceStream, EachRayIsAnsweredBeforeTheNextIsSent) {
  for (const char* threads : {"1", "2"}) {
    ToolProcess tool(folder(),
                     {.arguments = {"trace", "roof.obj", "-", "--any", "-q", "--threads", threads},
                      .standardOutput = pipe("out").string(),
                      .standardInput = pipe("in").string()});
    // The tool opens its output first.
    const PipeEnd hits(pipe("out"), O_RDONLY);
    PipeEnd rays(pipe("in"), O_WRONLY);
    std::string expected = "hit\n";
    std::string received;
    for (const bool isHit : {true, false, true}) {
      rays.write(isHit ? "0.25,0.5,2,0,0,-1\n" : "0,0,9,0,0,1\n");
      expected += isHit ? "1\n" : "0\n";
      while (received.size() < expected.size()) {
        const std::string some = hits.readSome();
        ASSERT_FALSE(some.empty()) << "the tool ended: " << tool.errSoFar();
        received += some;
      }
      EXPECT_EQ(received, expected);
    }
    rays.close();
    EXPECT_EQ(tool.wait().status, 0);
  }
}

TEST_F(TraceStream, AStreamThatEndsEarlyIsAFailure) {
  ToolProcess tool(folder(), {.arguments = {"trace", "roof.obj", "-", "-q", "-o", "hits.npy"},
                              .standardInput = pipe("in").string()});
  PipeEnd rays(pipe("in"), O_WRONLY);
  rays.write(npyRayHeader<float>(3) + std::string(40, '\0'));
  rays.close();
  expectFailed(tool.wait(), "standard input: ends after 1 of the 3 rays");
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"rays.csv", "roof.obj"}));
}

TEST_F(TraceStream, AFaultIsToldWhileTheRaysGoOn) {
  for (const char* threads : {"1", "4"}) {
    ToolProcess tool(folder(), {.arguments = {"trace", "roof.obj", "-", "-q", "--threads", threads},
                                .standardInput = pipe("in").string()});
    const PipeEnd rays(pipe("in"), O_WRONLY);
    rays.write("1,2,3,4,5,6\n1,2,3,4,5,six\n");
    expectFailed(tool.wait(), "standard input:2: column 6");
  }
}

TEST_F(TraceStream, AReaderThatLeavesIsAFailureAndNotASignal) {
  writeFile("rays.npy", npyOf(randomRays<float>(42, 100'000)));
  ToolProcess tool(folder(), {.arguments = {"trace", "roof.obj", "rays.npy", "-q"},
                              .standardOutput = pipe("out").string()});
  PipeEnd hits(pipe("out"), O_RDONLY);
  EXPECT_FALSE(hits.readSome().empty());
  hits.close();
  expectFailed(tool.wait(), "standard output: cannot be written");
}

class TraceInterrupted : public TraceStream, public testing::WithParamInterface<int> {
 protected:
  /// Waits until the tool has begun to write.
  void waitForTemporaryFile() const {
    const auto deadline = std::chrono::steady_clock::now() + 60s;
    while (filesInFolder().size() < 4) {
      ASSERT_LT(std::chrono::steady_clock::now(), deadline);
      std::this_thread::sleep_for(5ms);
    }
  }
};

TEST_P(TraceInterrupted, WhileItWaitsForRaysLeavesTheOldHits) {
  writeFile("hits.csv", "older hits");
  ToolProcess tool(folder(), {.arguments = {"trace", "roof.obj", "-", "-q", "-o", "hits.csv"},
                              .standardInput = pipe("in").string()});
  const PipeEnd rays(pipe("in"), O_WRONLY);
  rays.write(kTwoRays);
  waitForTemporaryFile();
  tool.signal(GetParam());
  const ToolResult result = tool.wait();
  EXPECT_EQ(result.signal, GetParam());
  EXPECT_EQ(result.err, "planetree: interrupted, and no file was written\n");
  EXPECT_EQ(readFile("hits.csv"), "older hits");
  EXPECT_EQ(filesInFolder(), (std::vector<std::string>{"hits.csv", "rays.csv", "roof.obj"}));
}

TEST_P(TraceInterrupted, WhileNobodyReadsItsHits) {
  writeFile("rays.npy", npyOf(randomRays<float>(43, 100'000)));
  ToolProcess tool(folder(), {.arguments = {"trace", "roof.obj", "rays.npy", "-q"},
                              .standardOutput = pipe("out").string()});
  const PipeEnd hits(pipe("out"), O_RDONLY);
  EXPECT_FALSE(hits.readSome().empty());
  std::this_thread::sleep_for(200ms);
  tool.signal(GetParam());
  const ToolResult result = tool.wait();
  EXPECT_EQ(result.signal, GetParam());
  EXPECT_EQ(result.err, "planetree: interrupted\n");
}

INSTANTIATE_TEST_SUITE_P(Signals, TraceInterrupted, testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace planetree::test
