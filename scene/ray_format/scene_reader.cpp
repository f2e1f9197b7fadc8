#include "scene/ray_format/scene_reader.hpp"

#include "scene/ray_format/light_reader.hpp"
#include "scene/ray_format/transform_reader.hpp"
#include "support/text_lines.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace planetree::scene::ray_format {
namespace {

using planetree::detail::quoted;

constexpr double kNewestVersion = 1.1;
/// Scenes made by hand or by programs stay far below; a level takes more memory than text.
constexpr std::size_t kMostLevels = 1000;

constexpr auto kSceneKeywords = [] {
  std::array<std::string_view, kBlocks.size() + kTransformKeywords.size()> keywords;
  const auto end = std::transform(kBlocks.begin(), kBlocks.end(), keywords.begin(),
                                  [](const BlockSyntax& block) { return block.name; });
  std::copy(kTransformKeywords.begin(), kTransformKeywords.end(), end);
  return keywords;
}();
constexpr const char* kSceneAdvice =
    "A scene has cameras, lights, materials, shapes, transforms and groups in braces";
constexpr const char* kGroupAdvice =
    "Cameras and lights stand outside of all groups and transforms";

template <std::size_t count>
bool isOneOf(const Token& token, const std::array<std::string_view, count>& keywords) {
  return token.kind == TokenKind::Word &&
         std::find(keywords.begin(), keywords.end(), token.text) != keywords.end();
}

std::string adviseInGroup(const Token& token) {
  if (isOneOf(token, kSceneKeywords))
    return kGroupAdvice;
  // The first four cannot stand there.
  return adviseNearest(token, std::span(kSceneKeywords).subspan(4), kGroupAdvice);
}

std::string adviseInTransform(const Token& token) {
  if (token.isWord("material"))
    return "Put it into the shape, or both into a group, { material = ...; ... }";
  return adviseInGroup(token);
}

}  // namespace

SceneReader::SceneReader(const Lexer& lexer, const std::filesystem::path& folder,
                         SceneDescription& scene)
    : remarks_(scene.remarks),
      tokens_(lexer, remarks_),
      scene_(scene),
      textures_(scene, folder),
      materials_(scene, textures_) {}

void SceneReader::read() {
  readHeader();
  levels_.push_back({LevelKind::Scene, {}, {}});
  while (readStatement()) {
  }
  scene_.view = camera_.view();
}

void SceneReader::readHeader() {
  const Token& name = tokens_.peek();
  if (!name.isWord(kFormatName)) {
    throw tokens_.unexpected(
        name, std::string(kFormatName) + " at the beginning",
        "If this is a .ray scene, begin it with " + std::string(kFormatName) + " 1.0");
  }
  tokens_.take();
  const Token version = tokens_.peek();
  const double number = tokens_.number();
  if (!(number >= 0.0 && number <= kNewestVersion)) {
    throw tokens_.unexpected(version, "a version up to 1.1",
                             "Save the scene in version 1.1 or an older one");
  }
  tokens_.skipSemicolons();
}

bool SceneReader::readStatement() {
  tokens_.skipSemicolons();
  const LevelKind kind = levels_.back().kind;
  const Token token = tokens_.peek();
  if (token.kind == TokenKind::End) {
    if (kind == LevelKind::Scene)
      return false;
    throw unclosed();
  }
  if (kind == LevelKind::Scene)
    readInScene(token);
  else if (kind == LevelKind::Group)
    readInGroup(token);
  else
    readInTransform(token);
  return true;
}

void SceneReader::readInScene(const Token& token) {
  if (readElement(token))
    return;
  if (token.is('}')) {
    throw tokens_.unexpected(token, "a statement",
                             "There is one '}' too many, or a '{' is missing before it");
  }
  if (!isOneOf(token, kSceneKeywords)) {
    throw tokens_.unexpected(token, "a camera, light, material, shape, transform or group",
                             adviseNearest(token, kSceneKeywords, kSceneAdvice));
  }
  if (token.text == "material") {
    readMaterial();
    return;
  }
  tokens_.take();
  if (token.text == "camera")
    camera_.read(tokens_);
  else if (token.text == "ambient_light")
    readAmbientLight(tokens_, token, scene_);
  else if (token.text == "point_light")
    readPointLight(tokens_, token, scene_);
  else
    readDirectionalLight(tokens_, token, scene_);
}

void SceneReader::readInGroup(const Token& token) {
  if (readElement(token))
    return;
  if (token.is('}')) {
    tokens_.take();
    close();
  } else if (token.isWord("material")) {
    readMaterial();
  } else {
    throw tokens_.unexpected(token, "a shape, transform, material, group or '}'",
                             adviseInGroup(token));
  }
}

void SceneReader::readInTransform(const Token& token) {
  Level& transform = levels_.back();
  if (!transform.isFilled) {
    transform.isFilled = true;
    if (!readElement(token)) {
      throw tokens_.unexpected(token, "a shape, transform or group to be transformed",
                               adviseInTransform(token));
    }
    return;
  }
  if (!token.is(')')) {
    throw tokens_.unexpected(
        token,
        "')' of the " + quoted(transform.begin.text) + " at " + describe(transform.begin.place),
        "A transform takes one shape, transform or group; put several into a group, { ... }");
  }
  tokens_.take();
  close();
}

bool SceneReader::readElement(const Token& token) {
  const Surroundings surroundings = levels_.back().surroundings;
  if (isOneOf(token, kShapeKeywords)) {
    tokens_.take();
    scene_.shapes.push_back(readShape(tokens_, token, materials_, surroundings));
    return true;
  }
  if (isOneOf(token, kTransformKeywords)) {
    tokens_.take();
    const Affine placement = readTransform(tokens_, token, surroundings.placement);
    open(LevelKind::Transform, token, {placement, surroundings.material});
    return true;
  }
  if (token.is('{')) {
    tokens_.take();
    open(LevelKind::Group, token, surroundings);
    return true;
  }
  return false;
}

void SceneReader::readMaterial() {
  const Token keyword = tokens_.take();
  Surroundings& surroundings = levels_.back().surroundings;
  surroundings.material = materials_.readAssignment(tokens_, keyword, surroundings.material);
}

void SceneReader::open(LevelKind kind, const Token& begin, const Surroundings& surroundings) {
  if (levels_.size() > kMostLevels) {
    throw tokens_.malformed(begin.place,
                            "more than " + std::to_string(kMostLevels) +
                                " groups and transforms stand inside each other",
                            "Make one \"transform\" of those that follow each other directly, and "
                            "leave out groups of one");
  }
  levels_.push_back({kind, begin, surroundings});
}

void SceneReader::close() {
  levels_.pop_back();
}

Error SceneReader::unclosed() const {
  const Level& level = levels_.back();
  const bool isGroup = level.kind == LevelKind::Group;
  const std::string what = isGroup ? "group" : quoted(level.begin.text);
  return tokens_.unexpected(tokens_.peek(),
                            std::string("the '") + (isGroup ? '}' : ')') + "' that ends the " +
                                what + " at " + describe(level.begin.place),
                            "Add it where the " + what + " is to end");
}

}  // namespace planetree::scene::ray_format
