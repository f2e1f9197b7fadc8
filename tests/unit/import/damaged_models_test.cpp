#include "import/read_with_assimp.hpp"

#include "model_folder.hpp"
#include "sample_models.hpp"
#include "scene_samples.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

// Whatever the bytes, reading ends with a mesh or with an `Error`, and in time.

namespace planetree::test {
namespace {

using namespace importing;

class DamagedModels : public ModelFolder {
 protected:
  /// Reads the bytes with limits that none of the samples needs.
  void expectMeshOrError(const SampleModel& sample, const std::string& bytes) const {
    const std::filesystem::path path = write(sample.name, bytes);
    expectOrError(path, [&] {
      ImportReport report;
      const TriangleMesh<float> mesh = readWithAssimp<float>(path, limits(), &report);
      for (const FaceIndices& face : mesh.faces) {
        for (const std::uint32_t vertex : face)
          EXPECT_LT(vertex, mesh.positions.size());
      }
      EXPECT_LE(report.skippedPolygonCount, report.polygonCount);
    });
  }

  void expectSceneOrError(const SampleModel& sample, const std::string& bytes) const {
    const std::filesystem::path path = write(sample.name, bytes);
    expectOrError(path, [&] {
      const scene::SceneDescription scene = readSceneWithAssimp(path, limits());
      for (const scene::PlacedShape& shape : scene.shapes) {
        EXPECT_LT(shape.material, scene.materials.size());
        EXPECT_TRUE(shape.placement.inverse().has_value());
      }
    });
  }

  static std::vector<SampleModel> scenes() {
    return {{"scene.glb", glbScene()},
            {"scene.gltf", gltfScene("\"uri\": \"" + embeddedImage() + '"')}};
  }

 private:
  static ReaderLimits limits() {
    ReaderLimits limits = usualLimits(0);
    limits.time = std::chrono::seconds(20);
    limits.memory = std::uint64_t{1} << 30;
    return limits;
  }

  template <class Read>
  static void expectOrError(const std::filesystem::path& path, const Read& read) {
    try {
      read();
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
  const auto readPrefixes = [&](const SampleModel& sample, std::size_t count, const auto& expect) {
    const std::size_t step = std::max<std::size_t>(sample.bytes.size() / count, 1);
    for (std::size_t length = 1; length < sample.bytes.size(); length += step) {
      SCOPED_TRACE(sample.name + ", first " + std::to_string(length) + " bytes");
      expect(sample, sample.bytes.substr(0, length));
    }
  };
  for (const SampleModel& sample : sampleModels())
    readPrefixes(sample, 64, [&](const auto&... parts) { expectMeshOrError(parts...); });
  for (const SampleModel& sample : scenes())
    readPrefixes(sample, 24, [&](const auto&... parts) { expectSceneOrError(parts...); });
}

TEST_F(DamagedModels, RandomBytesInTheMiddleAreReadOrRefused) {
  constexpr std::uint32_t kSeed = 20240301;
  const auto readChanged = [&](const SampleModel& sample, std::uint32_t count, const auto& expect) {
    for (std::uint32_t trial = 0; trial < count; ++trial) {
      SCOPED_TRACE(sample.name + ", seed " + std::to_string(kSeed + trial));
      std::mt19937 random(kSeed + trial);
      std::string bytes = sample.bytes;
      const std::size_t changes = 1 + random() % 8;
      for (std::size_t i = 0; i < changes; ++i) {
        bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      expect(sample, bytes);
    }
  };
  for (const SampleModel& sample : sampleModels())
    readChanged(sample, 60, [&](const auto&... parts) { expectMeshOrError(parts...); });
  for (const SampleModel& sample : scenes())
    readChanged(sample, 24, [&](const auto&... parts) { expectSceneOrError(parts...); });
}

}  // namespace
}  // namespace planetree::test
