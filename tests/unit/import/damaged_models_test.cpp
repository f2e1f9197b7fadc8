#include "import/read_with_assimp.hpp"

#include "model_folder.hpp"
#include "sample_models.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>

// Whatever the bytes, reading ends with a mesh or with an `Error`, and in time.

namespace planetree::test {
namespace {

using namespace importing;

class DamagedModels : public ModelFolder {
 protected:
  /// Reads the bytes with limits that none of the samples needs.
  void expectMeshOrError(const SampleModel& sample, const std::string& bytes) const {
    ReaderLimits limits = usualLimits(0);
    limits.time = std::chrono::seconds(20);
    limits.memory = std::uint64_t{1} << 30;
    const std::filesystem::path path = write(sample.name, bytes);
    try {
      ImportReport report;
      const TriangleMesh<float> mesh = readWithAssimp<float>(path, limits, &report);
      for (const FaceIndices& face : mesh.faces) {
        for (const std::uint32_t vertex : face)
          EXPECT_LT(vertex, mesh.positions.size());
      }
      EXPECT_LE(report.skippedPolygonCount, report.polygonCount);
    } catch (const Error& error) {
      EXPECT_EQ(error.file(), path.string());
      EXPECT_FALSE(error.advice().empty()) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find("did not get to its end"), std::string::npos)
          << error.what();
    }
  }
};

TEST_F(DamagedModels, SamplesAreSound) {
  for (const SampleModel& sample : sampleModels()) {
    const std::filesystem::path path = write(sample.name, sample.bytes);
    EXPECT_GT(importMesh<float>(path).faces.size(), 0u) << sample.name;
  }
}

TEST_F(DamagedModels, PrefixesAreReadOrRefused) {
  constexpr std::size_t kPrefixes = 64;
  for (const SampleModel& sample : sampleModels()) {
    const std::size_t step = std::max<std::size_t>(sample.bytes.size() / kPrefixes, 1);
    for (std::size_t length = 1; length < sample.bytes.size(); length += step) {
      SCOPED_TRACE(sample.name + ", first " + std::to_string(length) + " bytes");
      expectMeshOrError(sample, sample.bytes.substr(0, length));
    }
  }
}

TEST_F(DamagedModels, RandomBytesInTheMiddleAreReadOrRefused) {
  constexpr std::uint32_t kSeed = 20240301;
  constexpr std::uint32_t kTrials = 60;
  for (const SampleModel& sample : sampleModels()) {
    for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
      SCOPED_TRACE(sample.name + ", seed " + std::to_string(kSeed + trial));
      std::mt19937 random(kSeed + trial);
      std::string bytes = sample.bytes;
      const std::size_t changes = 1 + random() % 8;
      for (std::size_t i = 0; i < changes; ++i) {
        bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      expectMeshOrError(sample, bytes);
    }
  }
}

}  // namespace
}  // namespace planetree::test
