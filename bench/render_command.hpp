#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace planetree::bench {

/// The options of `planetree-bench render`.
struct RenderCommand {
  std::vector<std::filesystem::path> scenes;
  std::vector<unsigned> threadCounts = {1, 0};
  unsigned repetitions = 5;
  std::uint32_t width = 400;
  std::string json;
};

CLI::App* addRenderCommand(CLI::App& app, RenderCommand& command);

/// Measures pictures, writes the JSON and prints the tables; returns the exit status. Throws
/// `Error` and `WrongAnswers`.
int runRenderCommand(const RenderCommand& command);

}  // namespace planetree::bench
