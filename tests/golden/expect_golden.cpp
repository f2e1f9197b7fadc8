#include "golden/expect_golden.hpp"

#include "support/read_png.hpp"

#include "render/file/encode_png.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

namespace planetree::test {

namespace fs = std::filesystem;

using render::Image;

namespace {

double rootMeanSquare(const Image& a, const Image& b) {
  double sum = 0.0;
  const auto addSquare = [&sum](int first, int second) {
    sum += (first - second) * (first - second);
  };
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    addSquare(a.pixels[i].red, b.pixels[i].red);
    addSquare(a.pixels[i].green, b.pixels[i].green);
    addSquare(a.pixels[i].blue, b.pixels[i].blue);
  }
  return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

void writePng(const Image& image, const fs::path& path) {
  const std::vector<std::byte> png = encodePng(image);
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  ASSERT_TRUE(file.flush()) << path;
}

}  // namespace

void expectGolden(const Image& actual, const std::string& name, double tolerance) {
  const fs::path goldenPath = fs::path(PLANETREE_GOLDEN_FOLDER) / (name + ".png");
  if (std::getenv("PLANETREE_UPDATE_GOLDENS") != nullptr) {
    writePng(actual, goldenPath);
    GTEST_SKIP() << "kept as the new " << goldenPath;
  }
  const auto golden = readPng(goldenPath);
  ASSERT_TRUE(golden) << goldenPath << " is missing; PLANETREE_UPDATE_GOLDENS=1 makes it";
  ASSERT_EQ(actual.size, golden->image.size);
  const double difference = rootMeanSquare(actual, golden->image);
  if (difference <= tolerance)
    return;
  const fs::path actualPath = fs::path(PLANETREE_ACTUAL_FOLDER) / (name + ".png");
  writePng(actual, actualPath);
  ADD_FAILURE() << actualPath << " differs from " << goldenPath << " by " << difference
                << "/255 in the root mean square";
}

}  // namespace planetree::test
