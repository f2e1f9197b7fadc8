#include "import/import_scene.hpp"

#include "model_folder.hpp"
#include "sample_models.hpp"
#include "scene_samples.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <thread>

namespace planetree::test {
namespace {

using importing::ImportReport;
using importing::importScene;
using scene::ColourSource;
using scene::MeshShape;
using scene::PlacedShape;
using scene::SceneDescription;

using MeshPointer = std::shared_ptr<const MeshShape>;

// assimp holds floats, also where our sums are in double.
constexpr double kFloat = 2e-7;

void expectNear(const Vec3d& value, const Vec3d& expected, double tolerance = kFloat) {
  EXPECT_NEAR(value.x, expected.x, tolerance);
  EXPECT_NEAR(value.y, expected.y, tolerance);
  EXPECT_NEAR(value.z, expected.z, tolerance);
}

bool hasRemark(const SceneDescription& scene, const std::string& words) {
  return std::any_of(scene.remarks.begin(), scene.remarks.end(), [&](const std::string& remark) {
    return remark.find(words) != std::string::npos;
  });
}

const MeshShape& meshOf(const PlacedShape& shape) {
  return *std::get<MeshPointer>(shape.shape);
}

/// The coordinates of the vertex at this position.
std::array<double, 2> coordinatesAt(const MeshShape& mesh, const Vec3d& position) {
  const auto found = std::find(mesh.positions.begin(), mesh.positions.end(), position);
  if (found == mesh.positions.end() || mesh.coordinates.size() != mesh.positions.size()) {
    ADD_FAILURE() << "no such vertex, or no coordinates";
    return {};
  }
  return mesh.coordinates[static_cast<std::size_t>(found - mesh.positions.begin())];
}

class ImportScene : public ModelFolder {
 protected:
  /// The square of OBJ with this word after map_Kd.
  [[nodiscard]] SceneDescription objWithMap(const std::string& colourMap) const {
    static_cast<void>(write("square.mtl", mtlFor(colourMap)));
    return importScene(write("square.obj", objSquare()));
  }

  void expectTexture(const SceneDescription& scene) const {
    EXPECT_EQ(scene.textures.size(), 1u);
    EXPECT_FALSE(hasRemark(scene, "is left out"));
  }

  /// The scene of `gltfScene`, however it is stored.
  static void expectGltfScene(const SceneDescription& scene) {
    ASSERT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.shapes[0].name, "one");
    EXPECT_EQ(scene.shapes[0].placement.origin(), (Vec3d{10, 0, 0}));
    EXPECT_EQ(scene.shapes[1].name, "two");
    EXPECT_EQ(scene.shapes[1].placement.vector({1, 1, 1}), (Vec3d{2, 2, 2}));
    EXPECT_EQ(std::get<MeshPointer>(scene.shapes[0].shape),
              std::get<MeshPointer>(scene.shapes[1].shape));
    EXPECT_TRUE(hasRemark(scene, "flat or infinite: the part flat"));

    const MeshShape& mesh = meshOf(scene.shapes[0]);
    EXPECT_EQ(mesh.faces.size(), 2u);
    EXPECT_EQ(mesh.positions.size(), 4u);
    ASSERT_EQ(mesh.normals.size(), 4u);
    EXPECT_EQ(mesh.normals[3], (Vec3d{0, 0, 1}));
    EXPECT_EQ(coordinatesAt(mesh, {0, 0, 0}), (std::array<double, 2>{0, 0}));
    EXPECT_EQ(coordinatesAt(mesh, {1, 1, 0}), (std::array<double, 2>{1, 1}));

    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].width(), 2u);
    EXPECT_EQ(scene.textures[0].texel(0, 0), (Vec3f{1, 0, 0}));
    EXPECT_EQ(scene.textures[0].at(0.25, 0.25, scene::TextureEdges::Repeated),
              (Vec3d{0, 0, 1}));  // the lower left corner
    EXPECT_EQ(scene.textures[0].at(0.75, 0.75, scene::TextureEdges::Repeated), (Vec3d{0, 1, 0}));
  }
};

TEST_F(ImportScene, ReadsTheMaterialsOfObjFiles) {
  static_cast<void>(write("wood.png", fourColours()));
  static_cast<void>(write("square.mtl", mtlFor("wood.png")));
  ImportReport report;
  const SceneDescription scene = importScene(write("square.obj", objSquare()), &report);
  EXPECT_EQ(scene.name, "square.obj");
  EXPECT_EQ(report.formatName, "OBJ");
  EXPECT_EQ(report.polygonCount, 2u);
  ASSERT_EQ(scene.shapes.size(), 2u);

  const MeshShape& first = meshOf(scene.shapes[0]);
  ASSERT_EQ(first.faces.size(), 1u);
  EXPECT_EQ(first.normals.size(), 3u);
  EXPECT_EQ(coordinatesAt(first, {0, 0, 0}), (std::array<double, 2>{0, 0}));
  EXPECT_EQ(coordinatesAt(first, {1, 0, 0}), (std::array<double, 2>{1, 0}));
  EXPECT_EQ(coordinatesAt(first, {1, 1, 0}), (std::array<double, 2>{1, 1}));
  EXPECT_TRUE(meshOf(scene.shapes[1]).coordinates.empty());
  EXPECT_TRUE(meshOf(scene.shapes[1]).normals.empty());

  const scene::Material& wood = scene.materials.at(scene.shapes[0].material);
  EXPECT_EQ(wood.name, "wood");
  EXPECT_EQ(wood.ambient.value, (Vec3d{0.125, 0.25, 0.375}));
  EXPECT_EQ(wood.diffuse.value, (Vec3d{0.5, 0.75, 1}));
  EXPECT_EQ(wood.specular.value, (Vec3d{0.25, 0.5, 0.625}));
  EXPECT_EQ(wood.emissive.value, (Vec3d{0, 0.0625, 0}));
  EXPECT_EQ(wood.shininess.value, 50);
  EXPECT_EQ(wood.reflective.value, (Vec3d{}));
  EXPECT_EQ(wood.transmissive.value, (Vec3d{}));
  ASSERT_TRUE(wood.diffuse.texture.has_value());
  EXPECT_EQ(wood.ambient.texture, wood.diffuse.texture);
  EXPECT_EQ(scene.textures.at(*wood.diffuse.texture).at(0.25, 0.25, scene::TextureEdges::Repeated),
            (Vec3d{0, 0, 1}));

  const scene::Material& glass = scene.materials.at(scene.shapes[1].material);
  EXPECT_EQ(glass.name, "glass");
  EXPECT_EQ(glass.diffuse.value, (Vec3d{0.125, 0.125, 0.125}));
  EXPECT_EQ(glass.reflective.value, (Vec3d{0.75, 0.75, 0.75}));
  EXPECT_EQ(glass.transmissive.value, (Vec3d{0.75, 0.375, 0.75}));
  EXPECT_EQ(glass.index.value, 1.5);
  EXPECT_EQ(glass.shininess.value, 200);
}

TEST_F(ImportScene, LightsFilesWithoutLightsAndSaysSo) {
  const SceneDescription scene = importScene(write("square.obj", objSquare()));
  EXPECT_EQ(scene.pointLights.size(), 2u);
  EXPECT_TRUE(hasRemark(scene, "no lights"));
  const SceneDescription lit =
      importScene(write("lit.gltf", gltfScene("\"uri\": \"" + embeddedImage() + '"')));
  EXPECT_FALSE(hasRemark(lit, "no lights"));
}

TEST_F(ImportScene, ReadsGltfScenes) {
  const SceneDescription scene =
      importScene(write("scene.gltf", gltfScene("\"uri\": \"" + embeddedImage() + '"')));
  expectGltfScene(scene);

  // What 0.5 and 0.25 of light look like in a picture, by the transfer function of sRGB.
  constexpr double kHalf = 0.735356983052449;
  constexpr double kQuarter = 0.537098730483194;
  const scene::Material& painted = scene.materials.at(scene.shapes[0].material);
  EXPECT_EQ(painted.name, "painted");
  // A mirror is an eighth of it: a quarter is metal, and half of that is smooth.
  expectNear(painted.diffuse.value, Vec3d{kHalf, kQuarter, 1} * 0.875);
  expectNear(painted.ambient.value, painted.diffuse.value, 0);
  expectNear(painted.reflective.value, Vec3d{kHalf, kQuarter, 1} * 0.125);
  expectNear(painted.specular.value,
             (Vec3d{1, 1, 1} * (0.04 * 0.75) + Vec3d{kHalf, kQuarter, 1} * 0.125) * 4.0);
  EXPECT_NEAR(painted.shininess.value, 7.5, 1e-5);
  expectNear(painted.emissive.value, {kHalf, 0, 1});
  EXPECT_EQ(painted.transmissive.value, (Vec3d{}));  // its alpha is not in use
  EXPECT_EQ(painted.diffuse.texture, 0u);
  EXPECT_EQ(painted.reflective.texture, 0u);
}

TEST_F(ImportScene, ExposesThePhotometricLightsOfGltf) {
  const SceneDescription scene =
      importScene(write("scene.gltf", gltfScene("\"uri\": \"" + embeddedImage() + '"')));
  // The sun is the brightest, with 2 lux, and becomes 1.
  ASSERT_EQ(scene.directionalLights.size(), 1u);
  expectNear(scene.directionalLights[0].direction, {0, -1, 0});
  expectNear(scene.directionalLights[0].colour, {1, 1, 1});
  ASSERT_EQ(scene.pointLights.size(), 1u);
  const scene::PointLight& lamp = scene.pointLights[0];
  EXPECT_EQ(lamp.position, (Vec3d{0, 5, 0}));
  const double distance = 3.0;
  const double fall =
      std::min(1.0, 1.0 / (lamp.constant + distance * (lamp.linear + distance * lamp.quadratic)));
  expectNear(lamp.colour * fall, Vec3d{4, 2, 1} * (0.5 / (distance * distance)));
  EXPECT_EQ(scene.ambientLight, (Vec3d{0.1, 0.1, 0.1}));
}

TEST_F(ImportScene, TakesTheFirstCameraOfGltfWhereItsNodesPutIt) {
  const SceneDescription scene =
      importScene(write("scene.gltf", gltfScene("\"uri\": \"" + embeddedImage() + '"')));
  ASSERT_TRUE(scene.view.has_value());
  expectNear(scene.view->eye, {7, 0, 0}, 1e-6);
  expectNear(scene.view->look, {-1, 0, 0});
  const double height = 2 * std::tan(0.45);
  expectNear(scene.view->u, Vec3d{0, 0, -1} * (1.5 * height), 1e-6);
  expectNear(scene.view->v, Vec3d{0, 1, 0} * height, 1e-6);
  EXPECT_NEAR(scene.view->aspectRatio(), 1.5, 1e-6);
}

TEST_F(ImportScene, ReadsImagesInsideBinaryGltfAndBesideGltf) {
  expectGltfScene(importScene(write("scene.glb", glbScene())));
  static_cast<void>(write("four colours.png", fourColours()));
  expectGltfScene(importScene(write("beside.gltf", gltfScene(R"("uri": "four%20colours.png")"))));
}

TEST_F(ImportScene, MovesTextureCoordinatesAsGltfSays) {
  const auto moved = [&](const std::string& transform, const Vec3d& position) {
    const std::string material =
        R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions":
           {"KHR_texture_transform": {)" +
        transform + "}}}}";
    const SceneDescription scene = importScene(write("moved.gltf", gltfWithMaterial(material)));
    return coordinatesAt(meshOf(scene.shapes.at(0)), position);
  };
  // In the file v is down: the square's lower left corner is at (0, 1), the upper right at (1, 0).
  const std::string scaled = R"("scale": [2, 3], "offset": [0.25, 0.5])";
  const auto lower = moved(scaled, {0, 0, 0});
  EXPECT_NEAR(lower[0], 0.25, kFloat);
  EXPECT_NEAR(lower[1], 1 - 3.5, 5 * kFloat);
  const auto upper = moved(scaled, {1, 1, 0});
  EXPECT_NEAR(upper[0], 2.25, kFloat);
  EXPECT_NEAR(upper[1], 1 - 0.5, 5 * kFloat);
  // A quarter turn against the clock around (0, 0) takes what is below to the right of it: (0, 1)
  // to (1, 0).
  const auto turned = moved(R"("rotation": 1.57079632679)", {0, 0, 0});
  EXPECT_NEAR(turned[0], 1, 5 * kFloat);
  EXPECT_NEAR(turned[1], 1 - 0, 5 * kFloat);
}

TEST_F(ImportScene, TakesTheMeanOfMapsOfMetalAndRoughness) {
  // Two of the four texels are blue or white, and two green or white.
  const SceneDescription scene = importScene(write(
      "metal.gltf",
      gltfWithMaterial(R"("pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0}})")));
  const scene::Material& metal = scene.materials.at(scene.shapes.at(0).material);
  expectNear(metal.reflective.value, {0.25, 0.25, 0.25});
  EXPECT_NEAR(metal.shininess.value, 7.5, 1e-5);
  EXPECT_FALSE(metal.diffuse.texture.has_value());
}

TEST_F(ImportScene, LetsLightThroughWhereGltfSays) {
  const auto materialOf = [&](const std::string& material) {
    const SceneDescription scene = importScene(write("glass.gltf", gltfWithMaterial(material)));
    return scene.materials.at(scene.shapes.at(0).material);
  };
  const scene::Material glass = materialOf(
      R"("pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0}, "extensions": {
         "KHR_materials_transmission": {"transmissionFactor": 0.75},
         "KHR_materials_ior": {"ior": 1.25}})");
  expectNear(glass.transmissive.value, {0.75, 0.75, 0.75});
  EXPECT_EQ(glass.index.value, 1.25);
  expectNear(glass.diffuse.value, {0.25, 0.25, 0.25});
  expectNear(glass.reflective.value, Vec3d{1, 1, 1} * (1.0 / 81));

  const scene::Material veil = materialOf(
      R"("pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [1, 1, 1, 0.25]},
         "alphaMode": "BLEND")");
  expectNear(veil.transmissive.value, {0.75, 0.75, 0.75});
  expectNear(veil.diffuse.value, {0.25, 0.25, 0.25});
  EXPECT_EQ(veil.index.value, 1.0);

  const scene::Material sign = materialOf(
      R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
         "extensions": {"KHR_materials_unlit": {}})");
  expectNear(sign.emissive.value, {1, 1, 1});
  EXPECT_EQ(sign.emissive.texture, 0u);
  EXPECT_EQ(sign.diffuse.value, (Vec3d{}));
}

TEST_F(ImportScene, PaintsPlainlyWhereATextureIsMissingOrBroken) {
  const SceneDescription missing = objWithMap("gone.png");
  EXPECT_TRUE(missing.textures.empty());
  EXPECT_TRUE(hasRemark(missing, "gone.png is left out: there is no such file beside the model"));
  const scene::Material& wood = missing.materials.at(missing.shapes.at(0).material);
  EXPECT_FALSE(wood.diffuse.texture.has_value());
  EXPECT_EQ(wood.diffuse.value, (Vec3d{0.5, 0.75, 1}));

  static_cast<void>(write("text.png", "Dear all,\n"));
  EXPECT_TRUE(hasRemark(objWithMap("text.png"), "text.png is left out: "));
  static_cast<void>(write("cut.png", fourColours().substr(0, 30)));
  EXPECT_TRUE(hasRemark(objWithMap("cut.png"), "cut.png is left out: "));
  EXPECT_TRUE(hasRemark(
      importScene(write("bad.gltf", gltfScene(R"("uri": "data:image/png;base64,iVBORw0KGgo=")"))),
      "is left out: "));
}

TEST_F(ImportScene, ReadsATextureOnceForAllItsMaterials) {
  static_cast<void>(write("wood.png", fourColours()));
  static_cast<void>(write("square.mtl", mtlFor("wood.png") + "map_Kd wood.png\n"));
  const SceneDescription scene = importScene(write("square.obj", objSquare()));
  EXPECT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.materials.at(scene.shapes.at(1).material).diffuse.texture, 0u);
}

TEST_F(ImportScene, FindsTexturesAsModelsFromOtherMachinesNameThem) {
  std::filesystem::create_directory(folder() / "maps");
  static_cast<void>(write("maps/my wood.png", fourColours()));
  expectTexture(objWithMap("maps/my wood.png"));
  expectTexture(objWithMap("maps\\my wood.png"));
  expectTexture(objWithMap("\"maps/my wood.png\""));
  expectTexture(objWithMap("./maps/../maps/my wood.png"));
  // Paths that mean another machine: the file itself may have come along.
  static_cast<void>(write("near.png", fourColours()));
  expectTexture(objWithMap("C:\\Users\\Me\\near.png"));
  expectTexture(objWithMap("/home/me/near.png"));
  expectTexture(objWithMap("elsewhere/near.png"));
}

TEST_F(ImportScene, LeavesFilesBeyondTheModelAlone) {
  // An absolute path is never opened, though the file is there.
  std::filesystem::create_directory(folder() / "apart");
  const std::filesystem::path apart = write("apart/apart.png", fourColours());
  const SceneDescription scene = objWithMap(apart.string());
  EXPECT_TRUE(scene.textures.empty());
  EXPECT_TRUE(hasRemark(scene, "there is no such file beside the model"));
  EXPECT_TRUE(objWithMap("file://" + apart.string()).textures.empty());
  // A folder above the model is what a relative path may mean.
  static_cast<void>(write("above.png", fourColours()));
  static_cast<void>(write("apart/square.mtl", mtlFor("../above.png")));
  expectTexture(importScene(write("apart/square.obj", objSquare())));
  // Pipes and folders are not opened: this one would wait for ever.
  ASSERT_EQ(::mkfifo((folder() / "pipe.png").c_str(), 0600), 0);
  EXPECT_TRUE(objWithMap("pipe.png").textures.empty());
  EXPECT_TRUE(objWithMap("apart").textures.empty());
}

TEST_F(ImportScene, ReadsMeshesWithoutMaterialsAsClay) {
  const std::string stl =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid s\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto expectClay = [&](const std::filesystem::path& path, const std::string& format,
                              std::size_t faceCount) {
    ImportReport report;
    const SceneDescription scene = importScene(path, &report);
    EXPECT_EQ(report.formatName, format);
    ASSERT_EQ(scene.shapes.size(), 1u) << path;
    EXPECT_EQ(meshOf(scene.shapes[0]).faces.size(), faceCount) << path;
    EXPECT_EQ(scene.materials.at(scene.shapes[0].material).name, "clay") << path;
    EXPECT_EQ(scene.pointLights.size(), 2u) << path;
  };
  expectClay(write("cube.off", offCube()), "OFF", 12);
  expectClay(write("one.stl", stl), "STL", 1);
  expectClay(write("one.ply", ply), "PLY", 1);
  expectClay(write("one.obj", obj), "OBJ", 1);
  expectClay(write("unnamed", obj), "OBJ", 1);
  const std::filesystem::path pipe = folder() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << obj; });
  expectClay(pipe, "OBJ", 1);
  writer.join();
}

TEST_F(ImportScene, ReadsTheMeshOfObjFilesThatAssimpRefuses) {
  ImportReport report;
  const SceneDescription scene =
      importScene(write("square.obj", objSquare() + "f 1 2 9\n"), &report);
  ASSERT_EQ(scene.shapes.size(), 1u);
  EXPECT_EQ(meshOf(scene.shapes[0]).faces.size(), 2u);
  EXPECT_EQ(report.skippedPolygonCount, 1u);
  EXPECT_TRUE(hasRemark(scene, "materials, normals and textures are not read"));
}

TEST_F(ImportScene, MakesOneVertexOfEqualCornersOfObjFaces) {
  const SceneDescription scene =
      importScene(write("quads.obj",
                        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                        "f 1 2 3 4\nf 2 5 6 3\n"));
  const MeshShape& mesh = meshOf(scene.shapes.at(0));
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.faces, (std::vector<FaceIndices>{{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}));
}

TEST_F(ImportScene, ReadsTheOtherSampleFormats) {
  for (const SampleModel& sample : sampleModels()) {
    const SceneDescription scene = importScene(write(sample.name, sample.bytes));
    EXPECT_FALSE(scene.shapes.empty()) << sample.name;
    for (const PlacedShape& shape : scene.shapes)
      EXPECT_LT(shape.material, scene.materials.size()) << sample.name;
  }
}

TEST_F(ImportScene, RefusesWhatImportMeshRefuses) {
  const auto expectFault = [&](const std::filesystem::path& path, ErrorCode code,
                               const std::string& words) {
    expectError([&] { return importScene(path); }, path, code, words);
  };
  expectFault(folder() / "none.glb", ErrorCode::FileNotReadable, "there is no such file");
  expectFault(write("empty.obj", ""), ErrorCode::UnknownFormat, "the file is empty");
  expectFault(write("text.unheard", "Dear all,\n"), ErrorCode::UnknownFormat,
              "none of the formats");
  expectFault(write("bad.obj", "v 0 0 zero\n"), ErrorCode::MalformedFile, "is not a number");
  expectFault(write("bad.dae", "<COLLADA"), ErrorCode::MalformedFile, "cannot be read");
}

}  // namespace
}  // namespace planetree::test
