#pragma once

#include <planetree/error.hpp>

#include "render/render_image.hpp"
#include "render/rendering.hpp"
#include "render/tracer.hpp"
#include "scene/build_scene.hpp"
#include "scene/scene_description.hpp"

#include "support/promise.hpp"
#include "support/tree_promises.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

/// What holds of every scene that was read, whatever the bytes were: it has a tree, and a picture.
namespace planetree::fuzz {

/// What `read` makes of a scene file with this name; nothing if it refuses it as it should, with an
/// `Error` that says where in the file. Anything else that it throws ends the program.
template <class Read>
std::optional<scene::SceneDescription> readSceneOrRefuse(const std::string& name,
                                                         const Read& read) {
  try {
    return read();
  } catch (const Error& error) {
    const auto details = [&error] { return std::string(error.what()); };
    require(error.file() == name, "an error names the file", details);
    require(error.line() >= 1 && error.column() >= 1, "an error has a line and a column", details);
    require(!error.advice().empty(), "an error gives advice", details);
    require(error.code() == ErrorCode::MalformedFile || error.code() == ErrorCode::UnknownFormat ||
                error.code() == ErrorCode::FileNotReadable ||
                error.code() == ErrorCode::CapacityExceeded,
            "what cannot be read is malformed, or names a file that is", details);
    return std::nullopt;
  }
}

inline void requireSoundMesh(const scene::MeshShape& mesh, std::size_t materialCount,
                             std::size_t byteCount) {
  const std::size_t vertexCount = mesh.positions.size();
  require(mesh.faces.size() <= byteCount, "a triangle takes at least a byte");
  for (const FaceIndices& face : mesh.faces) {
    for (const std::uint32_t corner : face)
      require(corner < vertexCount, "faces refer to vertices that there are");
  }
  for (const std::size_t size :
       {mesh.normals.size(), mesh.coordinates.size(), mesh.vertexMaterials.size()})
    require(size == 0 || size == vertexCount, "all vertices carry something or none");
  require(mesh.faceMaterials.empty() || mesh.faceMaterials.size() == mesh.faces.size(),
          "all faces have a material or none");
  for (const std::vector<std::uint32_t>* const materials :
       {&mesh.vertexMaterials, &mesh.faceMaterials}) {
    for (const std::uint32_t material : *materials)
      require(material < materialCount, "a mesh refers to materials that there are");
  }
}

inline void requireSoundScene(const scene::SceneDescription& scene, std::size_t byteCount) {
  require(scene.shapes.size() <= byteCount, "a shape takes at least a byte");
  for (const scene::PlacedShape& shape : scene.shapes) {
    require(shape.material < scene.materials.size(), "a shape has a material");
    require(shape.placement.inverse().has_value(), "no shape is flattened by its placement");
    if (const auto* mesh = std::get_if<std::shared_ptr<const scene::MeshShape>>(&shape.shape))
      requireSoundMesh(**mesh, scene.materials.size(), byteCount);
  }
  if (scene.view) {
    for (const double x : {0.0, 0.5, 1.0})
      require(isFinite(scene.view->direction(x, 1.0 - x)), "a camera sees in all its directions");
  }
}

/// A small picture, with all that it can have.
inline void drawScene(const scene::BuiltScene& scene) {
  const render::TreeTracer tracer(scene.tree());
  render::RenderSettings settings;
  settings.size = {3, 2};
  settings.mode = render::RenderMode::Whitted;
  settings.whitted.depthLimit = 3;
  settings.view = scene.description().view.value_or(scene::View{});
  settings.grid = render::SampleGrid{.side = 2, .threshold = 0.1f};
  settings.threadCount = 1;
  settings.scene = &scene;
  settings.hasLayers = true;
  const render::Rendering rendering = render::renderImage(tracer, settings);
  require(rendering.isComplete, "a picture comes to its end");
  require(render::shownImage(rendering).pixels.size() == settings.size.pixelCount(),
          "a picture has all its pixels");
  for (const render::Channel& channel : render::channelImage(rendering).channels) {
    require(channel.values.size() == settings.size.pixelCount(), "so have its channels",
            [&channel] { return channel.name; });
  }
}

/// Builds and draws a scene that was read from so many bytes.
inline void checkScene(scene::SceneDescription description, std::size_t byteCount) {
  requireSoundScene(description, byteCount);
  BuildOptions options;
  options.threadCount = 1;
  BuildControl control;
  control.memoryLimit = kMemoryLimit;
  std::optional<scene::BuiltScene> scene;
  try {
    scene.emplace(std::move(description), options, control);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::MemoryLimitExceeded, "what was read can be built",
            [&error] { return std::string(error.what()); });
    return;
  }
  requireSoundTree(scene->tree());
  drawScene(*scene);
}

}  // namespace planetree::fuzz
