#include "import/read_with_assimp.hpp"

#include "import/mesh_receiver.hpp"
#include "import/message_reader.hpp"
#include "import/reader_process.hpp"
#include "import/scene_receiver.hpp"

#include <planetree/error.hpp>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <exception>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace planetree::importing {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConvert =
    "If the file is whole, convert it to PLY or STL with another program";

/// Where the build leaves the program and where it is installed, seen from the program that runs:
/// both may be moved.
fs::path assimpProgram() {
  std::error_code failed;
  const fs::path self = fs::read_symlink("/proc/self/exe", failed);
  return (self.parent_path() / PLANETREE_ASSIMP_FROM_BIN).lexically_normal();
}

std::uint64_t machineMemory() noexcept {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long pageSize = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || pageSize <= 0)
    return std::uint64_t{1} << 62;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageSize);
}

/// Why a file could not be read although the reader itself has given no reason.
class Faults {
 public:
  Faults(std::string fileName, const ReaderLimits& limits)
      : fileName_(std::move(fileName)), limits_(limits) {}

  [[nodiscard]] Error notStarted(const std::system_error& error) const {
    return {ErrorCode::FileNotReadable,
            "it takes the program " + limits_.program.string() +
                ", which cannot be started: " + error.code().message(),
            "Install planetree again, or convert the file to PLY, STL or OBJ", place()};
  }

  [[nodiscard]] Error tookTooLong() const {
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(limits_.time).count();
    return malformed("assimp did not get to its end within " + std::to_string(seconds) + " s");
  }

  [[nodiscard]] Error stoppedBy(int signal) const {
    if (signal == SIGINT || signal == SIGTERM)
      return {ErrorCode::FileNotReadable, "reading was interrupted", "Start it again", place()};
    if (signal == SIGKILL)
      return malformed("assimp was killed while reading it, perhaps for want of memory");
    return malformed("assimp crashes on it (" + std::string(::strsignal(signal)) + ")");
  }

  [[nodiscard]] Error unclear(const std::exception& fault) const {
    return malformed("the program " + limits_.program.string() +
                     " gave no clear answer: " + fault.what());
  }

 private:
  [[nodiscard]] Error malformed(const std::string& problem) const {
    return {ErrorCode::MalformedFile, problem, kConvert, place()};
  }
  [[nodiscard]] Error::Place place() const { return {fileName_}; }

  std::string fileName_;
  const ReaderLimits& limits_;
};

/// Has the program read the file, and the receiver take what it says.
template <class Receiver>
void receiveAnswer(const fs::path& path, const ReaderLimits& limits,
                   const std::vector<std::string>& request, Receiver& receiver) {
  const Faults faults(path.string(), limits);
  std::optional<ReaderProcess> process;
  try {
    std::vector<std::string> arguments = {path.string(), std::to_string(limits.memory),
                                          std::to_string(::getpid())};
    arguments.insert(arguments.end(), request.begin(), request.end());
    process.emplace(limits.program, std::move(arguments));
  } catch (const std::system_error& error) {
    throw faults.notStarted(error);
  }

  MessageReader messages(process->output(), MessageReader::Clock::now() + limits.time);
  try {
    receiver.receiveAll(messages);
  } catch (const DeadlinePassed&) {
    throw faults.tookTooLong();
  } catch (const BrokenMessages& fault) {
    throw faults.unclear(fault);
  } catch (const MessagesEnd& end) {
    constexpr std::chrono::seconds kPatience(1);
    if (const std::optional<int> signal = process->finish(kPatience))
      throw faults.stoppedBy(*signal);
    throw faults.unclear(end);
  }
}

}  // namespace

ReaderLimits usualLimits(std::uint64_t fileSize) {
  // Slow ends of what assimp does with honest files. A small .gltf may have its numbers elsewhere.
  constexpr std::uint64_t kMemoryForAny = std::uint64_t{4} << 30;
  constexpr std::uint64_t kMemoryPerByte = 64;
  constexpr std::chrono::milliseconds kTimeForAny = std::chrono::minutes(2);
  constexpr std::uint64_t kBytesPerMillisecond = 500;

  // A part of the machine's memory, so that other programs do not have to die for a bad file.
  const std::uint64_t memory =
      std::min(kMemoryForAny + kMemoryPerByte * fileSize, machineMemory() / 4 * 3);
  return {.program = assimpProgram(),
          .time = kTimeForAny + std::chrono::milliseconds(fileSize / kBytesPerMillisecond),
          .memory = memory};
}

template <std::floating_point T>
TriangleMesh<T> readWithAssimp(const fs::path& path, const ReaderLimits& limits,
                               ImportReport* report) {
  MeshReceiver<T> receiver(path.string());
  receiveAnswer(path, limits, {}, receiver);
  if (report)
    *report = receiver.takeReport();
  return receiver.takeMesh();
}

scene::SceneDescription readSceneWithAssimp(const fs::path& path, const ReaderLimits& limits,
                                            ImportReport* report) {
  SceneReceiver receiver(path.string());
  receiveAnswer(path, limits, {std::string(kSceneRequest)}, receiver);
  scene::SceneDescription scene = receiver.takeScene();
  if (report)
    *report = receiver.takeReport();
  return scene;
}

template TriangleMesh<float> readWithAssimp<float>(const fs::path&, const ReaderLimits&,
                                                   ImportReport*);
template TriangleMesh<double> readWithAssimp<double>(const fs::path&, const ReaderLimits&,
                                                     ImportReport*);

}  // namespace planetree::importing
