#include "bench/scene_command.hpp"

#include "bench/scene/generated_scenes.hpp"
#include "bench/scene/write_ply.hpp"
#include "bench/support/files.hpp"
#include "bench/usage_error.hpp"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>
#include <cstdio>
#include <map>

namespace planetree::bench {

namespace {

using MakeScene = TriangleMesh<float> (*)();

const std::map<std::string, MakeScene>& sceneMakers() {
  static const std::map<std::string, MakeScene> makers = {{"terrain", [] { return makeTerrain(); }},
                                                          {"foliage", &makeFoliage},
                                                          {"interior", &makeInterior}};
  return makers;
}

}  // namespace

CLI::App* addSceneCommand(CLI::App& app, SceneCommand& command) {
  CLI::App* const scene = app.add_subcommand("scene", "Make a scene to measure with");
  scene->add_option("scene", command.scene, "terrain, foliage or interior")
      ->required()
      ->check(CLI::IsMember(&sceneMakers()))
      ->type_name("SCENE");
  scene->add_option("-o,--output", command.output, "PLY file to write; - is standard output")
      ->required()
      ->type_name("FILE");
  return scene;
}

int runSceneCommand(const SceneCommand& command) {
  checkIsWritable(command.output);
  const TriangleMesh<float> mesh = sceneMakers().at(command.scene)();
  writeWholeFile(command.output, plyBytes(mesh));
  fmt::print(stderr, "{}: {} triangles\n", command.scene, mesh.faces.size());
  return kDone;
}

}  // namespace planetree::bench
