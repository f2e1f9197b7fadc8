#include "mesh_bytes.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

// Whatever the bytes, reading ends with a mesh or with an `Error`. Sanitizer builds give these
// tests their teeth.

namespace planetree::test {
namespace {

struct Sample {
  std::string name;
  std::string bytes;
  bool isBinary = false;
};

std::string plyHeader(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment small\nelement vertex 4\nproperty float x\nproperty double y\n"
         "property short z\nproperty list char uchar near\nelement face 2\nproperty uchar flags\n"
         "property list uint int vertex_indices\nelement edge 1\nproperty int a\nend_header\n";
}

std::string binaryPly(std::endian order) {
  std::string file =
      plyHeader(order == std::endian::little ? "binary_little_endian" : "binary_big_endian");
  for (int i = 0; i < 4; ++i) {
    file += bytesOf(static_cast<float>(i), order) + bytesOf(static_cast<double>(i * i), order) +
            bytesOf(static_cast<std::int16_t>(i), order) + "\2ab";
  }
  file += '\1' + bytesOf(3u, order) + bytesOf(0, order) + bytesOf(1, order) + bytesOf(2, order);
  file += '\1' + bytesOf(4u, order) + bytesOf(0, order) + bytesOf(1, order) + bytesOf(2, order) +
          bytesOf(3, order);
  return file + bytesOf(7, order);
}

std::string binaryStl() {
  std::string file = "solid but binary" + std::string(64, ' ') + bytesOf(3u);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 12; ++j)
      file += bytesOf(static_cast<float>((i * j) % 5));
    file += std::string(2, '\0');
  }
  return file;
}

std::vector<Sample> samples() {
  return {
      {"ascii.ply", plyHeader("ascii") +
                        "0 0 0 0\n1 0 0 1 7\n0.5 1e3 -2 0\n3 -4 5 2 8 9\n0 3 0 1 2\n"
                        "1 4 0 1 2 3\n7\n"},
      {"little.ply", binaryPly(std::endian::little), true},
      {"big.ply", binaryPly(std::endian::big), true},
      {"text.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\n"
       "endloop\nendfacet\nendsolid a\n"},
      {"binary.stl", binaryStl(), true},
      {"model.obj",
       "# a\nmtllib a.mtl\no b\nv 0 0 0\nv 1.5 0 0 1\nv 1 -1e2 0 1 0 0\nvn 0 0 1\nvt 0 0\n"
       "f 1/1/1 2//1 3/1\ng c\ns off\nf -1 -2 \\\n-3\nl 1 2\nf 1 2 3 4 # end\n"},
      {"model.off",
       "# a\nCOFF\n4 2 0 # b\n0 0 0 1 0 0 1\n1.5 0 0\n1 -1e2 0\n\n0 1 0\n3 0 1 2\n"
       "4 0 1 2 3 0.5 0.5 0.5\n"},
  };
}

/// True if the bytes could be read; false if they were refused with an `Error`.
template <class T>
bool isRead(const Sample& sample, const std::string& bytes) {
  try {
    MeshReadReport report;
    const TriangleMesh<T> mesh = readText<T>(bytes, &report, sample.name);
    EXPECT_LE(mesh.positions.size(), bytes.size());
    EXPECT_LE(mesh.faces.size(), bytes.size());
    for (const FaceIndices& face : mesh.faces) {
      for (const std::uint32_t corner : face)
        EXPECT_LT(corner, mesh.positions.size());
    }
    EXPECT_TRUE(mesh.sourceFaces.empty() || mesh.sourceFaces.size() == mesh.faces.size());
    return true;
  } catch (const Error& error) {
    EXPECT_FALSE(error.advice().empty()) << error.what();
    EXPECT_EQ(error.file(), sample.name);
    return false;
  }
}

TEST(DamagedFiles, SamplesAreSound) {
  for (const Sample& sample : samples()) {
    EXPECT_TRUE(isRead<float>(sample, sample.bytes)) << sample.name;
    EXPECT_TRUE(isRead<double>(sample, sample.bytes)) << sample.name;
  }
}

TEST(DamagedFiles, EveryPrefixIsReadOrRefused) {
  for (const Sample& sample : samples()) {
    for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
      const bool wasRead = isRead<float>(sample, sample.bytes.substr(0, length));
      if (sample.isBinary) {
        EXPECT_FALSE(wasRead) << sample.name << ", first " << length << " bytes";
      }
    }
  }
}

TEST(DamagedFiles, RandomBytesInTheMiddleAreReadOrRefused) {
  constexpr std::uint32_t kSeed = 20240229;
  constexpr int kTrials = 3000;
  for (const Sample& sample : samples()) {
    for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
      SCOPED_TRACE(sample.name + ", seed " + std::to_string(kSeed + trial));
      std::mt19937 random(kSeed + trial);
      std::string bytes = sample.bytes;
      const std::size_t changes = 1 + random() % 4;
      for (std::size_t i = 0; i < changes; ++i) {
        bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      static_cast<void>(isRead<float>(sample, bytes));
      static_cast<void>(isRead<double>(sample, bytes));
    }
  }
}

TEST(DamagedFiles, ShuffledPiecesAreReadOrRefused) {
  constexpr std::uint32_t kSeed = 77;
  constexpr int kTrials = 3000;
  const std::vector<Sample> all = samples();
  for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
    SCOPED_TRACE("seed " + std::to_string(kSeed + trial));
    std::mt19937 random(kSeed + trial);
    const Sample& sample = all[random() % all.size()];
    const auto piece = [&random](const std::string& bytes) {
      const std::size_t begin = random() % bytes.size();
      return bytes.substr(begin, random() % bytes.size());
    };
    const std::size_t kept = random() % sample.bytes.size();
    const std::string bytes = sample.bytes.substr(0, kept) + piece(sample.bytes) +
                              piece(all[random() % all.size()].bytes);
    static_cast<void>(isRead<float>(sample, bytes));
  }
}

TEST(DamagedFiles, NoiseIsReadOrRefused) {
  constexpr std::uint32_t kSeed = 5;
  constexpr int kTrials = 2000;
  const std::vector<Sample> all = samples();
  for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
    SCOPED_TRACE("seed " + std::to_string(kSeed + trial));
    std::mt19937 random(kSeed + trial);
    const Sample& sample = all[trial % all.size()];
    std::string bytes = sample.bytes.substr(0, random() % 8);
    const std::size_t length = random() % 300;
    while (bytes.size() < length)
      bytes += static_cast<char>(random());
    static_cast<void>(isRead<float>(sample, bytes));
  }
}

}  // namespace
}  // namespace planetree::test
