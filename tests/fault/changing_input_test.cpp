#include "bits_of.hpp"
#include "fault_folder.hpp"
#include "fault_scenes.hpp"
#include "fault_tally.hpp"
#include "file_reading.hpp"
#include "model_files.hpp"

#include "import/import_mesh.hpp"
#include "import/read_with_assimp.hpp"
#include "ray_files/ray_reader.hpp"
#include "unit/import/sample_models.hpp"

#include <planetree/error.hpp>
#include <planetree/mesh/read_mesh.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace planetree::test {
namespace {

namespace fs = std::filesystem;

/// A change of a file that another program might make while it is read.
struct Change {
  std::string name;
  std::function<void(const fs::path&, const std::string& bytes)> make;
  bool leavesOldContent = false;  ///< who has opened the file before has all of it
};

void append(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::app) << bytes;
}

/// The time of the last change, which has steps of some milliseconds, is another one after this.
void letTimePass() {
  std::this_thread::sleep_for(std::chrono::milliseconds(12));
}

const std::vector<Change>& changes() {
  static const std::vector<Change> all = {
      {"emptied", [](const fs::path& path, const std::string&) { fs::resize_file(path, 0); }},
      {"cut in half", [](const fs::path& path,
                         const std::string& bytes) { fs::resize_file(path, bytes.size() / 2); }},
      {"cut at the end of a line",
       [](const fs::path& path, const std::string& bytes) {
         fs::resize_file(path, bytes.rfind('\n', bytes.size() - 2) + 1);
       }},
      {"longer", [](const fs::path& path, const std::string& bytes) { append(path, bytes); }},
      {"longer by a byte", [](const fs::path& path, const std::string&) { append(path, "\n"); }},
      {"written anew",
       [](const fs::path& path, const std::string& bytes) {
         letTimePass();
         std::ofstream(path, std::ios::binary) << bytes;
       }},
      {"replaced",
       [](const fs::path& path, const std::string& bytes) {
         const fs::path other = path.string() + ".new";
         std::ofstream(other, std::ios::binary) << bytes.substr(0, bytes.size() / 3);
         fs::rename(other, path);
       },
       true},
      {"removed", [](const fs::path& path, const std::string&) { fs::remove(path); }, true}};
  return all;
}

/// An error that says that the file was changed, names it, and says what to do.
bool tellsOfChange(const Error& error, const fs::path& path) {
  return error.code() == ErrorCode::FileNotReadable && error.file() == path.string() &&
         std::string(error.what()).find("changed while it was being read") != std::string::npos &&
         !error.advice().empty();
}

using ChangingInput = FaultFolder;

TEST_F(ChangingInput, ModelsAreReadAsTheyWereOrRefused) {
  const auto mesh = MeshGenerator(8).soupOfAnyCoordinates<float>(200, 0.2f);
  for (const ModelFile& file : modelFilesOf(mesh)) {
    for (const Change& change : changes()) {
      const fs::path path = write(file.name, file.bytes);
      const std::string expected = bitsOf(readMesh<float>(path));
      const BeforeReading changing([&] { change.make(path, file.bytes); });
      const std::string name = file.name + " " + change.name;
      ++faultTally().injectedCount;
      try {
        const TriangleMesh<float> read = readMesh<float>(path);
        if (!change.leavesOldContent || bitsOf(read) != expected)
          reportLost(name);
      } catch (const Error& error) {
        if (change.leavesOldContent || !tellsOfChange(error, path))
          reportLost(name + ": " + error.what());
      }
    }
  }
}

/// Formats that count what they hold, so that no part of a file passes for a file.
TEST_F(ChangingInput, ModelsThatOthersWriteAllTheTimeAreReadWholeOrRefused) {
  const auto mesh = MeshGenerator(9).soupOfAnyCoordinates<float>(5000, 0.2f);
  for (const ModelFile& file : modelFilesOf(mesh)) {
    if (file.name == "model.obj" || file.name == "text.stl")
      continue;
    const fs::path path = write(file.name, file.bytes);
    const std::string expected = bitsOf(readMesh<float>(path));
    std::atomic<bool> isDone = false;
    std::thread writer([&] {
      for (std::size_t i = 0; !isDone; ++i) {
        fs::resize_file(path, i % 7 * file.bytes.size() / 7);
        std::ofstream(path, std::ios::binary) << file.bytes;
        if (i % 2 == 0)
          std::this_thread::sleep_for(std::chrono::microseconds(300));
      }
    });
    const int rounds = triesEveryFault() ? 2000 : 60;
    for (int i = 0; i < rounds; ++i) {
      ++faultTally().injectedCount;
      try {
        if (bitsOf(readMesh<float>(path)) != expected)
          reportLost(file.name + ": neither the old nor the new content");
      } catch (const Error& error) {
        if (error.file() != path.string() || error.advice().empty())
          reportLost(error.what());
      }
    }
    isDone = true;
    writer.join();
  }
}

TEST_F(ChangingInput, RaysAreReadAsTheyWereOrRefused) {
  // More than is read at a time.
  std::string csv;
  while (csv.size() < 3'000'000)
    csv += "0.25,0.5,2,0,0,-1\n";
  const std::size_t rayCount = csv.size() / 18;
  for (const Change& change : changes()) {
    const fs::path path = write("rays.csv", csv);
    ++faultTally().injectedCount;
    const auto rays = tool::openRays(path);
    tool::RayBlock block;
    std::size_t count = 0;
    try {
      while (rays->next(block, [] { return true; })) {
        if (count == 0)
          change.make(path, csv);
        count += rays->decodeFloat(block).size();
      }
      if (!change.leavesOldContent || count != rayCount)
        reportLost("rays " + change.name);
    } catch (const Error& error) {
      if (change.leavesOldContent || error.file() != path.string() || error.advice().empty())
        reportLost("rays " + change.name + ": " + error.what());
    }
  }
}

/// An array of float32 with six columns.
std::string npyOf(std::size_t rayCount) {
  std::string header =
      "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(rayCount) + ", 6), }";
  header.resize(118 - 1, ' ');
  header += '\n';
  std::string bytes = std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(118) + '\0' + header;
  const std::string ray(24, '\x3f');
  for (std::size_t i = 0; i < rayCount; ++i)
    bytes += ray;
  return bytes;
}

TEST_F(ChangingInput, ArraysOfRaysAreReadAsTheyWereOrRefused) {
  constexpr std::size_t kRayCount = 100'000;
  const std::string npy = npyOf(kRayCount);
  for (const Change& change : changes()) {
    const fs::path path = write("rays.npy", npy);
    ++faultTally().injectedCount;
    const auto rays = tool::openRays(path);
    tool::RayBlock block;
    std::size_t count = 0;
    try {
      while (rays->next(block, [] { return true; })) {
        if (count == 0)
          change.make(path, npy);
        count += rays->decodeFloat(block).size();
      }
      if (!change.leavesOldContent || count != kRayCount)
        reportLost("an array " + change.name);
    } catch (const Error& error) {
      if (change.leavesOldContent || error.file() != path.string() || error.advice().empty())
        reportLost("an array " + change.name + ": " + error.what());
    }
  }
}

TEST_F(ChangingInput, WhatIsNoFileIsReadOrRefused) {
  const auto codeOf = [](const fs::path& path) -> std::optional<ErrorCode> {
    try {
      static_cast<void>(readMesh<float>(path));
      return std::nullopt;
    } catch (const Error& error) {
      EXPECT_EQ(error.file(), path.string());
      EXPECT_FALSE(error.advice().empty());
      return error.code();
    }
  };
  EXPECT_EQ(codeOf(folder()), ErrorCode::FileNotReadable);
  EXPECT_EQ(codeOf(folder() / "missing"), ErrorCode::FileNotReadable);
  EXPECT_EQ(codeOf(write("file", "") / "below"), ErrorCode::FileNotReadable);
  EXPECT_EQ(codeOf("/dev/null"), ErrorCode::UnknownFormat);
  EXPECT_EQ(codeOf("/dev/zero"), ErrorCode::FileNotReadable);
  // Files of no size that have content, and one that has a size and may not be read.
  EXPECT_EQ(codeOf("/proc/self/status"), ErrorCode::UnknownFormat);
  EXPECT_EQ(codeOf("/proc/self/maps"), ErrorCode::UnknownFormat);
  EXPECT_EQ(codeOf("/proc/self/mem"), ErrorCode::FileNotReadable);
  fs::create_symlink("loop", folder() / "loop");
  EXPECT_EQ(codeOf(folder() / "loop"), ErrorCode::FileNotReadable);
  fs::create_symlink("nowhere", folder() / "dangling");
  EXPECT_EQ(codeOf(folder() / "dangling"), ErrorCode::FileNotReadable);
  EXPECT_EQ(codeOf(folder() / std::string(5000, 'x')), ErrorCode::FileNotReadable);
  if (::geteuid() != 0) {
    const fs::path locked = write("locked.obj", "v 0 0 0\n");
    fs::permissions(locked, fs::perms::none);
    EXPECT_EQ(codeOf(locked), ErrorCode::FileNotReadable);
  }
}

TEST_F(ChangingInput, PipesAreReadToTheirEnd) {
  const auto mesh = MeshGenerator(10).soupOfAnyCoordinates<float>(3000, 0.2f);
  for (const ModelFile& file : modelFilesOf(mesh)) {
    const fs::path pipe = folder() / file.name;
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << file.bytes; });
    const std::string read = bitsOf(readMesh<float>(pipe));
    writer.join();
    const auto bytes = std::as_bytes(std::span(file.bytes));
    EXPECT_EQ(read, bitsOf(readMesh<float>(bytes, file.name))) << file.name;
  }
}

/// A script in the place of planetree-assimp: it changes the model, and then gives a whole answer.
TEST_F(ChangingInput, ImportedModelsThatChangeAreRefused) {
  const fs::path path = write("square.glb", glb(gltfNodes(), squareBuffer()));
  const fs::path script =
      write("reader", "#!/bin/sh\nsleep 0.02\necho >> '" + path.string() + "'\nexec '" +
                          importing::usualLimits(0).program.string() + "' \"$1\" \"$2\" $PPID\n");
  fs::permissions(script, fs::perms::owner_all);
  importing::ReaderLimits limits = importing::usualLimits(0);
  EXPECT_EQ(importing::readWithAssimp<float>(path, limits).faces.size(), 4u);
  limits.program = script;
  ++faultTally().injectedCount;
  try {
    static_cast<void>(importing::readWithAssimp<float>(path, limits));
    reportLost("an import of a file that grows");
  } catch (const Error& error) {
    if (!tellsOfChange(error, path))
      reportLost(error.what());
  }
}

}  // namespace
}  // namespace planetree::test
