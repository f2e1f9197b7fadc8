#include "answers.hpp"
#include "import/read_with_assimp.hpp"
#include "model_folder.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

// The program that reads is a shell script here, so that it can lie.

namespace planetree::test {
namespace {

using namespace importing;
using scene::MeshShape;
using scene::SceneDescription;

template <class... Numbers>
std::string numbers(Numbers... all) {
  return (bytesOf(all) + ... + std::string());
}

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

const std::string kGreet(kGreeting);

std::string texture(std::uint32_t width, std::uint32_t height) {
  return message(MessageKind::Texture, numbers(width, height) + "a.png");
}
std::string texels(std::initializer_list<float> parts) {
  std::string payload;
  for (const float part : parts)
    payload += bytesOf(part);
  return message(MessageKind::Texels, payload);
}
std::string value(MaterialProperty property, double x, double y = 0, double z = 0) {
  return message(MessageKind::MaterialValue, numbers(property, x, y, z));
}
std::string map(MaterialProperty property, std::uint32_t index) {
  return message(MessageKind::MaterialTexture, numbers(property, index));
}
std::string meshMaterial(std::uint32_t index) {
  return message(MessageKind::MeshMaterial, numbers(index));
}
std::string normals(std::initializer_list<double> parts) {
  std::string payload;
  for (const double part : parts)
    payload += bytesOf(part);
  return message(MessageKind::Normals, payload);
}
std::string coordinates(std::initializer_list<double> parts) {
  std::string payload;
  for (const double part : parts)
    payload += bytesOf(part);
  return message(MessageKind::Coordinates, payload);
}
/// A placement that scales by one number and shifts along x.
std::string placement(std::uint32_t mesh, double scale, double shift, const std::string& name) {
  const double o = 0;
  return message(MessageKind::Placement,
                 numbers(mesh, scale, o, o, o, scale, o, o, o, scale, shift, o, o) + name);
}
std::string light(std::uint32_t kind, double x, double red, double attenuation) {
  const double o = 0;
  return message(MessageKind::Light,
                 numbers(kind, x, o, o, o, -1.0, o, red, o, o, attenuation, o, o));
}
std::string camera(double angle, double aspect) {
  const double o = 0;
  return message(MessageKind::Camera, numbers(1.0, 2.0, 3.0, o, o, -2.0, o, 5.0, o, angle, aspect));
}

const std::string kMaterial = message(MessageKind::Material, "red\nish");
const std::string kMesh = message(MessageKind::Mesh) + kTriangle + polygons({3, 0, 1, 2});
const std::string kPixel = texture(1, 1) + texels({0.25f, 0.5f, 1.0f});

class ReadSceneWithAssimp : public ModelFolder {
 protected:
  /// Reads a model by a program that gives this answer after the greeting.
  SceneDescription readAnswer(const std::string& answer, ImportReport* report = nullptr) const {
    const std::filesystem::path file = write("answer", kGreet + answer);
    const ReaderLimits limits = {
        .program = writeScript("reader", "exec cat '" + file.string() + "'"),
        .time = std::chrono::seconds(20),
        .memory = 1u << 30};
    return readSceneWithAssimp(path_, limits, report);
  }

  void expectUnclear(const std::string& answer, const std::string& words) const {
    expectError([&] { return readAnswer(answer); }, path_, ErrorCode::MalformedFile, words);
  }

  void expectRemark(const std::string& answer, const std::string& words) const {
    const SceneDescription scene = readAnswer(answer);
    for (const std::string& remark : scene.remarks) {
      if (remark.find(words) != std::string::npos)
        return;
    }
    ADD_FAILURE() << "no remark: " << words;
  }

  const std::filesystem::path path_ = "model.glb";
};

TEST_F(ReadSceneWithAssimp, TakesTheSceneThatTheProgramTellsOf) {
  ImportReport report;
  const SceneDescription scene = readAnswer(
      message(MessageKind::Format, "Parrot") + kPixel + kMaterial +
          value(MaterialProperty::Diffuse, 0.5, 0.25, 0) + map(MaterialProperty::Diffuse, 0) +
          kMesh + meshMaterial(0) + normals({0, 0, 1, 0, 0, 1, 0, 0, 1}) +
          coordinates({0, 0, 1, 0, 0, 1}) + kMesh + placement(1, 1, 0, "plain") +
          placement(0, 2, 5, "a\tpart") + placement(0, -1, 7, "mirrored") + light(0, 9, 0.5, 1) +
          camera(1.0, 2.0) + camera(0.5, 1.0) +
          message(MessageKind::Unread, bytesOf(std::uint64_t{7})) + kEnd,
      &report);
  EXPECT_EQ(report.formatName, "Parrot");
  EXPECT_EQ(report.polygonCount, 2u);
  EXPECT_EQ(report.unreadPrimitiveCount, 7u);

  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].texel(0, 0), (Vec3f{0.25f, 0.5f, 1.0f}));
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.materials[0].name, "red ish");
  EXPECT_EQ(scene.materials[0].diffuse.value, (Vec3d{0.5, 0.25, 0}));
  EXPECT_EQ(scene.materials[0].diffuse.texture, 0u);

  ASSERT_EQ(scene.shapes.size(), 3u);
  EXPECT_EQ(scene.shapes[0].name, "plain");
  EXPECT_EQ(scene.materials.at(scene.shapes[0].material).name, "clay");
  EXPECT_EQ(scene.shapes[1].name, "a part");
  EXPECT_EQ(scene.shapes[1].material, 0u);
  EXPECT_EQ(scene.shapes[1].placement.point({1, 1, 1}), (Vec3d{7, 2, 2}));
  EXPECT_EQ(std::get<std::shared_ptr<const MeshShape>>(scene.shapes[1].shape),
            std::get<std::shared_ptr<const MeshShape>>(scene.shapes[2].shape));
  const auto& mesh = std::get<std::shared_ptr<const MeshShape>>(scene.shapes[1].shape);
  EXPECT_EQ(mesh->positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh->faces, (std::vector<FaceIndices>{{0, 1, 2}}));
  EXPECT_EQ(mesh->normals[2], (Vec3d{0, 0, 1}));
  EXPECT_EQ(mesh->coordinates[1], (std::array<double, 2>{1, 0}));

  ASSERT_EQ(scene.pointLights.size(), 1u);
  EXPECT_EQ(scene.pointLights[0].position, (Vec3d{9, 0, 0}));
  EXPECT_EQ(scene.pointLights[0].colour, (Vec3d{0.5, 0, 0}));
  EXPECT_EQ(scene.pointLights[0].constant, 1.0);
  ASSERT_TRUE(scene.view.has_value());
  EXPECT_EQ(scene.view->eye, (Vec3d{1, 2, 3}));
  EXPECT_EQ(scene.view->look, (Vec3d{0, 0, -1}));
  EXPECT_NEAR(length(scene.view->u), 2 * std::tan(0.5), 1e-15);
  EXPECT_NEAR(scene.view->aspectRatio(), 2.0, 1e-15);
}

TEST_F(ReadSceneWithAssimp, RefusesTexturesOfImpossibleSize) {
  expectUnclear(texture(0, 1) + kEnd, "impossible size");
  expectUnclear(texture(kNone, kNone) + kEnd, "impossible size");
  expectUnclear(texture(1u << 14, (1u << 13) + 1) + kEnd, "impossible size");
  // All together count, too.
  expectUnclear(kPixel + texture(1u << 14, 1u << 13) + kEnd, "impossible size");
  expectUnclear(message(MessageKind::Texture, numbers(1u)) + kEnd, "too short");
}

TEST_F(ReadSceneWithAssimp, RefusesTexturesWithoutAllTheirTexels) {
  const std::string half = texture(2, 1) + texels({0, 0, 0});
  expectUnclear(half + kEnd, "lacks texels");
  expectUnclear(half + kPixel + kEnd, "lacks texels");
  expectUnclear(kMaterial + half + map(MaterialProperty::Diffuse, 0) + kEnd, "lacks texels");
  // Promises cost nothing.
  expectUnclear(texture(1u << 14, 1u << 13) + kEnd, "lacks texels");
  expectUnclear(kPixel + texels({0, 0, 0}) + kEnd, "too many texels");
  expectUnclear(texels({0, 0, 0}) + kEnd, "texels without a texture");
  expectUnclear(texture(2, 1) + texels({0, 0}) + kEnd, "no three colours");
}

TEST_F(ReadSceneWithAssimp, KeepsTexelsBetweenBlackAndWhite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const SceneDescription scene = readAnswer(texture(1, 1) + texels({nan, -1, 7}) + kEnd);
  EXPECT_EQ(scene.textures.at(0).texel(0, 0), (Vec3f{0, 0, 1}));
}

TEST_F(ReadSceneWithAssimp, RefusesPropertiesThatBelongNowhere) {
  expectUnclear(value(MaterialProperty::Diffuse, 1) + kEnd, "without a material");
  expectUnclear(kPixel + map(MaterialProperty::Diffuse, 0) + kEnd, "without a material");
  expectUnclear(kMaterial + value(static_cast<MaterialProperty>(kMaterialProperties), 1) + kEnd,
                "unknown kind");
  expectUnclear(kMaterial + value(static_cast<MaterialProperty>(kNone), 1) + kEnd, "unknown kind");
  expectUnclear(kMaterial + kPixel + map(static_cast<MaterialProperty>(kNone), 0) + kEnd,
                "unknown kind");
  expectUnclear(kMaterial + map(MaterialProperty::Diffuse, 0) + kEnd, "not told of");
  expectUnclear(kMaterial + kPixel + map(MaterialProperty::Diffuse, 1) + kEnd, "not told of");
  expectUnclear(kMaterial + message(MessageKind::MaterialValue, numbers(1u, 2.0)) + kEnd,
                "too short");
  expectUnclear(kMaterial + kPixel + message(MessageKind::MaterialTexture, numbers(1u)) + kEnd,
                "too short");
}

TEST_F(ReadSceneWithAssimp, RefusesPartsOfNoMesh) {
  expectUnclear(kTriangle + kEnd, "without a mesh");
  expectUnclear(polygons({3, 0, 1, 2}) + kEnd, "without a mesh");
  expectUnclear(normals({0, 0, 1}) + kEnd, "without a mesh");
  expectUnclear(coordinates({0, 0}) + kEnd, "without a mesh");
  expectUnclear(kMaterial + meshMaterial(0) + kEnd, "without a mesh");
  // A placement ends the mesh.
  expectUnclear(kMesh + placement(0, 1, 0, "") + kTriangle + kEnd, "without a mesh");
}

TEST_F(ReadSceneWithAssimp, RefusesMeshesWhoseListsDoNotFit) {
  expectUnclear(kMesh + normals({0, 0, 1}) + kEnd, "more or fewer normals");
  expectUnclear(kMesh + normals({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}) + kEnd,
                "more or fewer normals");
  expectUnclear(kMesh + coordinates({0, 0}) + kMesh + kEnd, "more or fewer normals or coord");
  expectUnclear(kMesh + coordinates({0, 0, 0, 0, 0, 0, 0, 0}) + placement(0, 1, 0, "") + kEnd,
                "more or fewer normals or coord");
  expectUnclear(kMesh + normals({0, 0}) + kEnd, "a normal has no three");
  expectUnclear(kMesh + coordinates({0}) + kEnd, "not complete");
  expectUnclear(kMesh + message(MessageKind::Vertices, "12345") + kEnd, "three coordinates");
  expectUnclear(kMesh + polygons({4, 0}) + kEnd, "lacks corners");
  expectUnclear(kMesh + polygons({4, 0}) + kMesh + kEnd, "lacks corners");
  expectUnclear(kMesh + polygons({kNone, 0, 1, 2}) + placement(0, 1, 0, "") + kEnd,
                "lacks corners");
}

TEST_F(ReadSceneWithAssimp, SkipsAndCountsPolygonsWithoutTheirVertices) {
  ImportReport report;
  const SceneDescription scene = readAnswer(
      kMesh + kMesh + polygons({3, 0, 1, 3, 2, 0, 1}) + placement(1, 1, 0, "") + kEnd, &report);
  EXPECT_EQ(report.polygonCount, 4u);
  EXPECT_EQ(report.skippedPolygonCount, 2u);
  ASSERT_EQ(report.skipped.size(), 2u);
  EXPECT_EQ(report.skipped[0].polygon, 2u);
  EXPECT_EQ(report.skipped[0].reason, "refers to vertex 3, which does not exist");
  EXPECT_EQ(report.skipped[1].reason, "has fewer than three corners");
  EXPECT_EQ(std::get<std::shared_ptr<const MeshShape>>(scene.shapes.at(0).shape)->faces.size(), 1u);
}

TEST_F(ReadSceneWithAssimp, RefusesMaterialsAndMeshesThatWereNotToldOf) {
  expectUnclear(kMesh + meshMaterial(0) + kEnd, "a material that was not told of");
  expectUnclear(kMaterial + kMesh + meshMaterial(kNone) + kEnd, "a material that was not told of");
  expectUnclear(placement(0, 1, 0, "") + kEnd, "a mesh that was not told of");
  expectUnclear(kMesh + placement(1, 1, 0, "") + kEnd, "a mesh that was not told of");
  expectUnclear(kMesh + message(MessageKind::Placement, numbers(0u, 1.0)) + kEnd, "too short");
}

TEST_F(ReadSceneWithAssimp, LeavesOutPlacementsThatCannotBeWithARemark) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const std::string& bad : {placement(0, 0, 0, "flat"), placement(0, 1, infinity, "flat"),
                                 placement(0, std::numeric_limits<double>::quiet_NaN(), 0, "flat"),
                                 placement(0, 1e-200, 0, "flat")}) {
    EXPECT_TRUE(readAnswer(kMesh + bad + kEnd).shapes.empty());
    expectRemark(kMesh + bad + kEnd, "the part flat");
  }
}

TEST_F(ReadSceneWithAssimp, LeavesOutMeshesWithoutFaces) {
  EXPECT_TRUE(
      readAnswer(message(MessageKind::Mesh) + placement(0, 1, 0, "") + kEnd).shapes.empty());
}

TEST_F(ReadSceneWithAssimp, RefusesLightsAndCamerasThatBreakTheRules) {
  expectUnclear(light(8, 0, 1, 1) + kEnd, "a light of unknown kind");
  expectUnclear(light(kNone, 0, 1, 1) + kEnd, "a light of unknown kind");
  expectUnclear(message(MessageKind::Light, numbers(0u, 1.0)) + kEnd, "too short");
  expectUnclear(message(MessageKind::Camera, numbers(0.0)) + kEnd, "too short");
}

TEST_F(ReadSceneWithAssimp, LeavesOutLightsAndCamerasThatCannotBeWithARemark) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const std::string& bad : {light(0, nan, 1, 1), light(0, 0, -1, 1), light(0, 0, infinity, 1),
                                 light(0, 0, 1, -1), light(0, 0, 1, nan)}) {
    EXPECT_TRUE(readAnswer(bad + kEnd).pointLights.empty());
    expectRemark(bad + kEnd, "a light with impossible numbers");
  }
  for (const std::string& bad : {camera(0, 1), camera(-1, 1), camera(nan, 1), camera(3.2, 1),
                                 camera(1, nan), camera(1, -1), camera(1, infinity)}) {
    EXPECT_FALSE(readAnswer(bad + kEnd).view.has_value());
    expectRemark(bad + kEnd, "a camera with impossible numbers");
    EXPECT_TRUE(readAnswer(bad + camera(1, 1) + kEnd).view.has_value());
  }
}

TEST_F(ReadSceneWithAssimp, TakesNumbersOfMaterialsThatCannotBeForNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SceneDescription scene = readAnswer(
      kMaterial + value(MaterialProperty::Diffuse, nan, 0, 0) +
      value(MaterialProperty::Specular, 1e300, 0, 0) + value(MaterialProperty::Opacity, -3) +
      value(MaterialProperty::RefractiveIndex, 0) + value(MaterialProperty::Shininess, nan) + kEnd);
  const scene::Material& material = scene.materials.at(0);
  EXPECT_EQ(material.diffuse.value, (Vec3d{0.6, 0.6, 0.6}));
  EXPECT_EQ(material.specular.value, (Vec3d{}));
  EXPECT_EQ(material.transmissive.value, (Vec3d{}));
  EXPECT_EQ(material.index.value, 1.0);
  EXPECT_EQ(material.shininess.value, 0.0);
}

TEST_F(ReadSceneWithAssimp, KeepsFewOfManyRemarks) {
  std::string answer;
  for (int i = 0; i < 1000; ++i)
    answer += message(MessageKind::Remark, "remark " + std::to_string(i));
  ImportReport report;
  EXPECT_LT(readAnswer(answer + kEnd, &report).remarks.size(), 100u);
  EXPECT_EQ(report.remarkCount, 1000u);
  // However much assimp talks, what is left out is told.
  const std::string omission = message(MessageKind::Omission, "no\nnose");
  const SceneDescription scene = readAnswer(answer + omission + kEnd);
  EXPECT_EQ(scene.remarks.at(0), "no nose");
  std::string omissions;
  for (int i = 0; i < 100; ++i)
    omissions += message(MessageKind::Omission, "omission " + std::to_string(i));
  EXPECT_LT(readAnswer(omissions + kEnd).remarks.size(), 20u);
  expectRemark(omissions + kEnd, "more is left out");
}

TEST_F(ReadSceneWithAssimp, PassesFailuresOn) {
  expectError([&] { return readAnswer(failure(FailureKind::Malformed, "no head")); }, path_,
              ErrorCode::MalformedFile, "cannot be read: no head");
  expectUnclear(failure(static_cast<FailureKind>(9), ""), "unknown kind");
  expectUnclear("", "end too early");
}

TEST_F(ReadSceneWithAssimp, TakesAllPrefixesAndChangesOfAnAnswerInOrder) {
  const std::string answer = kPixel + kMaterial + value(MaterialProperty::Diffuse, 0.5) +
                             map(MaterialProperty::Diffuse, 0) + kMesh + meshMaterial(0) +
                             normals({0, 0, 1, 0, 0, 1, 0, 0, 1}) +
                             coordinates({0, 0, 1, 0, 0, 1}) + placement(0, 2, 5, "part") +
                             light(0, 9, 0.5, 1) + camera(1, 2) + kEnd;
  for (std::size_t length = 0; length < answer.size(); length += 31) {
    EXPECT_THROW(static_cast<void>(readAnswer(answer.substr(0, length))), Error) << length;
  }
  for (std::size_t i = 0; i < answer.size(); i += 5) {
    std::string changed = answer;
    changed[i] = static_cast<char>(~changed[i]);
    try {
      const SceneDescription scene = readAnswer(changed);
      for (const scene::PlacedShape& shape : scene.shapes) {
        EXPECT_LT(shape.material, scene.materials.size());
        EXPECT_TRUE(shape.placement.isFinite());
        const auto& mesh = *std::get<std::shared_ptr<const MeshShape>>(shape.shape);
        EXPECT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
        for (const FaceIndices& face : mesh.faces) {
          for (const std::uint32_t vertex : face)
            EXPECT_LT(vertex, mesh.positions.size());
        }
      }
      for (const scene::Material& material : scene.materials)
        EXPECT_TRUE(!material.diffuse.texture || *material.diffuse.texture < scene.textures.size());
    } catch (const Error& error) {
      EXPECT_FALSE(error.advice().empty());
    }
  }
}

}  // namespace
}  // namespace planetree::test
