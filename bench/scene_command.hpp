#pragma once

#include <CLI/App.hpp>
#include <string>

namespace planetree::bench {

/// The options of `planetree-bench scene`.
struct SceneCommand {
  std::string scene;
  std::string output;
};

CLI::App* addSceneCommand(CLI::App& app, SceneCommand& command);

/// Makes a scene and writes it as PLY; returns the exit status. Throws `Error`.
int runSceneCommand(const SceneCommand& command);

}  // namespace planetree::bench
