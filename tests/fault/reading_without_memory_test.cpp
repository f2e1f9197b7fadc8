#include "fault_folder.hpp"
#include "fault_scenes.hpp"
#include "model_files.hpp"
#include "try_faults.hpp"

#include "import/import_mesh.hpp"
#include "unit/import/sample_models.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <sys/wait.h>

#include <cerrno>
#include <filesystem>
#include <span>
#include <string>

namespace planetree::test {
namespace {

std::string bitsOf(const MeshReadReport& report) {
  std::string bits = std::to_string(report.polygonCount) + ' ' +
                     std::to_string(report.skippedPolygonCount) + ' ' +
                     std::to_string(report.unreadPrimitiveCount);
  for (const SkippedPolygon& skipped : report.skipped)
    bits += skipped.reason;
  return bits;
}

/// What a reader gave, or why it refused the file.
template <class T>
struct Reading {
  TriangleMesh<T> mesh;
  MeshReadReport report;
  std::string refusal;
};

template <class T>
std::string bitsOf(const Reading<T>& reading) {
  return test::bitsOf(reading.mesh) + bitsOf(reading.report) + reading.refusal;
}

template <class T, class Read>
Reading<T> readingOf(const Read& read) {
  Reading<T> reading;
  try {
    reading.mesh = read(reading.report);
  } catch (const Error& error) {
    reading.refusal = error.what();
  }
  return reading;
}

using ReadingWithoutMemory = FaultFolder;

TEST_F(ReadingWithoutMemory, IsToldForEachFormat) {
  for (const ModelFile& file :
       modelFilesOf(MeshGenerator(7).soupOfAnyCoordinates<float>(200, 0.2f))) {
    const std::filesystem::path path = write(file.name, file.bytes);
    tryFaults(file.name, [&] {
      return readingOf<float>(
          [&](MeshReadReport& report) { return readMesh<float>(path, &report); });
    });
    tryFaults(file.name + " in double", [&] { return readMesh<double>(path); });
    const auto bytes = std::as_bytes(std::span(file.bytes));
    tryFaults(file.name + " in memory", [&] { return readMesh<float>(bytes, file.name); });
  }
}

TEST_F(ReadingWithoutMemory, IsToldWhereThereIsSomethingElseToTell) {
  for (const ModelFile& file : faultyModelFiles()) {
    const std::filesystem::path path = write(file.name, file.bytes);
    tryFaults(file.name, [&] {
      return readingOf<float>(
          [&](MeshReadReport& report) { return readMesh<float>(path, &report); });
    });
  }
  tryFaults("no file", [&] {
    return readingOf<float>([&](MeshReadReport&) { return readMesh<float>(folder() / "missing"); });
  });
  tryFaults("a folder", [&] {
    return readingOf<float>([&](MeshReadReport&) { return readMesh<float>(folder()); });
  });
}

TEST_F(ReadingWithoutMemory, IsToldOfImportsAndLeavesNoProcess) {
  // A program is started each time, which takes some milliseconds.
  constexpr std::uint64_t kMost = 30;
  constexpr std::uint64_t kChecks = 3;
  std::vector<ModelFile> files = {{"square.glb", glb(gltfNodes(), squareBuffer())},
                                  {"broken.glb", glb(gltfNodes(), "too short")},
                                  {"square.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}};
  for (const ModelFile& file : files) {
    const std::filesystem::path path = write(file.name, file.bytes);
    tryFaults(
        file.name,
        [&] {
          return readingOf<float>([&](MeshReadReport& report) {
            importing::ImportReport found;
            TriangleMesh<float> mesh = importing::importMesh<float>(path, &found);
            report = found;
            return mesh;
          });
        },
        kMost, kChecks);
  }
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace
}  // namespace planetree::test
