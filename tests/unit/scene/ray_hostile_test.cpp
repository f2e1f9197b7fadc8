#include "unit/scene/ray_text.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <variant>

// Scenes that were made to break a reader.
namespace planetree::test {
namespace {

std::string repeated(const std::string& text, std::size_t count) {
  std::string all;
  all.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i)
    all += text;
  return all;
}

constexpr std::size_t kMillion = 1'000'000;

TEST(RayHostile, AMillionNestedGroupsAndTransforms) {
  const std::string problem =
      ": more than 1000 groups and transforms stand inside each other. Make one \"transform\" of "
      "those that follow each other directly, and leave out groups of one";
  EXPECT_EQ(errorOf(repeated("{", kMillion)), "test.ray:2:1001" + problem);
  EXPECT_EQ(errorOf(repeated("scale(1,", kMillion)), "test.ray:2:8001" + problem);
  EXPECT_EQ(errorOf(repeated("{\n", kMillion)), "test.ray:1002:1" + problem);
}

TEST(RayHostile, AThousandNestedOnesAreRead) {
  const std::string groups = repeated("{ translate(1, 0, 0, ", 500);
  const auto scene = readStatements(groups + "sphere {}" + repeated(")}", 500));
  ASSERT_EQ(scene.shapes.size(), 1u);
  EXPECT_EQ(scene.shapes[0].placement.origin(), (Vec3d{500, 0, 0}));
  EXPECT_EQ(readStatements(repeated("{ sphere {} }", 5000)).shapes.size(), 5000u);
}

TEST(RayHostile, OtherBracketsDoNotNest) {
  EXPECT_EQ(errorOf("trimesh { points = " + repeated("(", kMillion)),
            "test.ray:2:22: expected a number, found '('. Numbers look like 2, -0.5 or 1e-3");
  EXPECT_EQ(errorOf("trimesh { materials = (" + repeated("{", kMillion)),
            "test.ray:2:25: expected '}' or a keyword of \"material\", found '{'. It may hold "
            "emissive, ambient, diffuse, specular, reflective, transmissive, index, shininess and "
            "name");
}

TEST(RayHostile, LinesOfAHundredMegabytes) {
  constexpr std::size_t kLong = 100 * kMillion;
  std::string text = "SBT-raytracer 1.0 ";
  const std::size_t begin = text.size();
  text.resize(begin + kLong, ' ');
  text += '?';
  EXPECT_EQ(errorOfText(text).substr(0, 22), "test.ray:1:100000019: ");
  std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), 'a');
  EXPECT_EQ(errorOfText(text),
            "test.ray:1:19: expected a camera, light, material, shape, transform or group, found "
            "\"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...\". A scene has cameras, lights, materials, "
            "shapes, transforms and groups in braces");
  std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), '9');
  EXPECT_EQ(errorOfText(text).substr(0, 15), "test.ray:1:19: ");
  text[begin] = '"';
  EXPECT_EQ(errorOfText(text).substr(0, 15), "test.ray:1:19: ");
  text[begin] = '/';
  text[begin + 1] = '*';
  EXPECT_EQ(errorOfText(text).substr(0, 15), "test.ray:1:19: ");
  text[begin + 1] = '/';
  EXPECT_EQ(errorOfText(text), "no error");
}

TEST(RayHostile, AMillionMaterialsThatSayNothingTakeNoMemory) {
  EXPECT_EQ(readStatements(repeated("material={}", kMillion / 10)).materials.size(), 1u);
}

TEST(RayHostile, RemarksHaveAnEnd) {
  const auto scene = readStatements("camera {" + repeated("fov=9;", kMillion / 10) + "}");
  EXPECT_EQ(scene.remarks.size(), 101u);
  EXPECT_EQ(scene.remarks.back(), "test.ray: there is more like this");
}

TEST(RayHostile, PolygonsOfAMillionCorners) {
  const auto scene = readStatements("trimesh { points = ((0,0,0),(1,0,0),(0,1,0)); faces = ((0" +
                                    repeated(",1,2", kMillion / 2) + ")) }");
  EXPECT_EQ(std::get<std::shared_ptr<const scene::MeshShape>>(scene.shapes[0].shape)->faces.size(),
            kMillion - 1);
}

TEST(RayHostile, ScenesCutOffAnywhereAreErrorsOrScenes) {
  std::ifstream file(kSceneFolder / "transforms.ray", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  ASSERT_GT(whole.size(), 1000u);
  std::size_t errorCount = 0;
  for (std::size_t size = 0; size < whole.size(); ++size)
    errorCount += errorOfText(whole.substr(0, size)) != "no error" ? 1u : 0u;
  EXPECT_GT(errorCount, whole.size() / 2);
  EXPECT_EQ(errorOfText(whole), "no error");
}

TEST(RayHostile, ScenesWithBytesChangedAreErrorsOrScenes) {
  std::ifstream file(kSceneFolder / "coloured_shadows.ray", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  ASSERT_GT(whole.size(), 1000u);
  Random random(20250101);
  const std::string bytes("{}(),;=\"/*.-+eE0123456789 \n\0\xFFxyz", 33);
  std::size_t errorCount = 0;
  constexpr int kTries = 3000;
  for (int i = 0; i < kTries; ++i) {
    std::string changed = whole;
    for (int change = 0; change < 3; ++change) {
      const std::size_t place = random.below(static_cast<std::uint32_t>(whole.size()));
      changed[place] = bytes[random.below(static_cast<std::uint32_t>(bytes.size()))];
    }
    errorCount += errorOfText(changed) != "no error" ? 1u : 0u;
  }
  EXPECT_GT(errorCount, kTries / 2u);
}

/// A mesh of hills with `side` x `side` squares.
std::string hills(std::size_t side) {
  std::string text = "trimesh { gennormals; points = (";
  for (std::size_t i = 0; i <= side; ++i) {
    for (std::size_t j = 0; j <= side; ++j) {
      const double height =
          std::sin(0.3 * static_cast<double>(i)) * std::cos(0.2 * static_cast<double>(j));
      text += (i + j > 0 ? ",\n(" : "(") + std::to_string(i) + ", " + std::to_string(j) + ", " +
              std::to_string(height) + ")";
    }
  }
  text += "); faces = (";
  for (std::size_t i = 0; i < side; ++i) {
    for (std::size_t j = 0; j < side; ++j) {
      const std::size_t a = i * (side + 1) + j;
      text += (i + j > 0 ? ",\n(" : "(") + std::to_string(a) + "," + std::to_string(a + 1) + "," +
              std::to_string(a + side + 2) + "," + std::to_string(a + side + 1) + ")";
    }
  }
  return text + ") }";
}

TEST(RayHostile, TenThousandFacesAreAllRead) {
  const auto scene = readStatements(hills(71));
  EXPECT_EQ(std::get<std::shared_ptr<const scene::MeshShape>>(scene.shapes[0].shape)->faces.size(),
            2u * 71 * 71);
}

}  // namespace
}  // namespace planetree::test
