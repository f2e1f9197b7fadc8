#include "scene/json_format/material_table.hpp"
#include "scene/json_format/model_table.hpp"
#include "scene/json_format/parse_json.hpp"
#include "scene/json_format/shape_reader.hpp"
#include "scene/json_format/texture_table.hpp"
#include "scene/json_format/value_reader.hpp"
#include "scene/read_scene.hpp"
#include "support/read_file.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace planetree::scene {

namespace {

using namespace json_format;

/// No scene by hand is as large, and a file that is no scene at all is not worth looking at.
constexpr std::size_t kMaxFileSize = std::size_t{1} << 26u;

constexpr double kUsualFov = 40.0;
constexpr double kWidestFov = 179.0;
constexpr double kUsualAspectRatio = 4.0 / 3.0;

class SceneReader {
 public:
  SceneReader(const JsonText& text, const std::filesystem::path& folder,
              const SceneFileReaders& readers) noexcept
      : text_(text),
        textures_(text, folder, readers, scene_),
        materials_(text, textures_, scene_),
        models_(text, folder, readers, scene_),
        shapes_(text, materials_, models_, scene_) {}

  SceneDescription scene() {
    const Value root = parseJson(text_);
    const ObjectReader object(text_, root, kSceneSyntax);
    for (const char* key : {"$schema", "title"}) {
      if (const Value* value = object.find(key))
        static_cast<void>(stringOf(text_, *value, key));
    }
    if (const Value* camera = object.find("camera"))
      scene_.view = readCamera(*camera);
    if (const Value* light = object.find("ambient_light"))
      scene_.ambientLight = colourOf(text_, *light, "\"ambient_light\"");
    if (const Value* lights = object.find("lights"))
      readLights(*lights);
    // Shapes may stand before the materials that they name.
    if (const Value* materials = object.find("materials"))
      materials_.readNamed(*materials);
    if (const Value* background = object.find("background"))
      readBackground(*background);
    if (const Value* shapes = object.find("shapes"))
      shapes_.readAll(*shapes);
    scene_.name = std::filesystem::path(text_.name()).filename().string();
    return std::move(scene_);
  }

 private:
  [[nodiscard]] View readCamera(const Value& value) const;
  void readLights(const Value& value);
  void readPointLight(const Value& value);
  void readDirectionalLight(const Value& value);
  void readBackground(const Value& value);

  const JsonText& text_;
  SceneDescription scene_;
  TextureTable textures_;
  MaterialTable materials_;
  ModelTable models_;
  ShapeReader shapes_;
};

View SceneReader::readCamera(const Value& value) const {
  const ObjectReader camera(text_, value, kCameraSyntax);
  const Value& lookAt = camera.at("look_at");
  const Vec3d eye = vectorOf(text_, camera.at("position"), "\"position\"");
  const Vec3d toward = vectorOf(text_, lookAt, "\"look_at\"") - eye;
  const Vec3d look = normalized(toward);
  if (!(dot(look, look) > 0.5)) {  // of unit length, unless there is no length to divide by
    throw text_.malformed(lookAt.offset, "the camera looks at where it stands",
                          "Give another \"look_at\".");
  }
  Vec3d up{0, 1, 0};
  if (const Value* given = camera.find("up"))
    up = directionOf(text_, *given, "\"up\"");
  const Vec3d right = normalized(cross(look, up));
  constexpr double kLeastSine = 1e-9;
  if (!(length(cross(look, up)) > kLeastSine)) {
    const Value* given = camera.find("up");
    throw text_.malformed(given == nullptr ? lookAt.offset : given->offset,
                          "the camera looks along \"up\"",
                          "Give an \"up\" across the view, as [0, 0, 1].");
  }
  double fov = kUsualFov;
  if (const Value* given = camera.find("fov")) {
    fov = positiveNumberOf(text_, *given, "\"fov\"");
    if (fov > kWidestFov)
      throw text_.malformed(given->offset, "\"fov\" is too wide", "Give at most 179 degrees.");
  }
  double aspectRatio = kUsualAspectRatio;
  if (const Value* given = camera.find("aspect_ratio"))
    aspectRatio = positiveNumberOf(text_, *given, "\"aspect_ratio\"");
  const double height = 2.0 * std::tan(fov * (std::numbers::pi / 360.0));
  return {.eye = eye,
          .look = look,
          .u = right * (height * aspectRatio),
          .v = cross(right, look) * height};
}

void SceneReader::readLights(const Value& value) {
  for (const Value& light : arrayOf(text_, value, "\"lights\"")) {
    const Object& object = objectOf(text_, light, "a light");
    const Value* type = nullptr;
    for (const Member& member : object) {
      if (member.key == "type")
        type = &member.value;
    }
    const std::vector<std::string> known = {"point", "directional"};
    if (type == nullptr)
      throw text_.malformed(light.offset, "the light has no \"type\"", adviceOf("", known));
    const std::string& name = stringOf(text_, *type, "\"type\"");
    if (name == known[0]) {
      readPointLight(light);
    } else if (name == known[1]) {
      readDirectionalLight(light);
    } else {
      throw text_.malformed(type->offset, "there is no light " + inQuotes(name),
                            adviceOf(name, known));
    }
  }
}

void SceneReader::readPointLight(const Value& value) {
  const ObjectReader object(text_, value, kPointLightSyntax);
  const auto amount = [&](const char* key, double usual) {
    const Value* given = object.find(key);
    return given == nullptr ? usual : amountOf(text_, *given, inQuotes(key));
  };
  scene_.pointLights.push_back({.position = vectorOf(text_, object.at("position"), "\"position\""),
                                .colour = colourOf(text_, object.at("colour"), "\"colour\""),
                                .constant = amount("constant", 1.0),
                                .linear = amount("linear", 0.0),
                                .quadratic = amount("quadratic", 0.0)});
}

void SceneReader::readDirectionalLight(const Value& value) {
  const ObjectReader object(text_, value, kDirectionalLightSyntax);
  scene_.directionalLights.push_back(
      {.direction = directionOf(text_, object.at("direction"), "\"direction\""),
       .colour = colourOf(text_, object.at("colour"), "\"colour\"")});
}

void SceneReader::readBackground(const Value& value) {
  CubeMap cube{};
  if (std::holds_alternative<Object>(value.content)) {
    const ObjectReader object(text_, value, kCubeMapSyntax);
    for (std::size_t i = 0; i < cube.textures.size(); ++i)
      cube.textures[i] = textures_.read(object.at(kCubeMapSyntax.required[i]));
  } else {
    cube.textures.fill(textures_.addColour(colourOf(text_, value, "\"background\"")));
  }
  scene_.background = cube;
}

}  // namespace

SceneDescription readJsonScene(std::span<const std::byte> bytes, const std::string& name,
                               const std::filesystem::path& folder,
                               const SceneFileReaders& readers) {
  const JsonText text(bytes, name);
  if (bytes.size() > kMaxFileSize) {
    throw Error(ErrorCode::CapacityExceeded,
                "the file goes on beyond " + std::to_string(kMaxFileSize) + " bytes",
                "Keep large meshes in model files, and name those in the scene.",
                text.placeOf(kMaxFileSize));
  }
  return SceneReader(text, folder, readers).scene();
}

SceneDescription readJsonScene(const std::filesystem::path& path, const SceneFileReaders& readers) {
  const detail::FileContent content = detail::readFile(path);
  return readJsonScene(content.bytes(), path.string(), path.parent_path(), readers);
}

}  // namespace planetree::scene
