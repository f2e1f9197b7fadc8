#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace planetree::bench {

/// The options of `planetree-bench rivals`.
struct RivalsCommand {
  std::vector<std::filesystem::path> scenes;
  std::vector<std::string> measures = {"rays"};
  std::vector<std::string> kinds = {"primary", "ao", "diffuse", "random"};
  std::vector<std::string> engines;
  std::string json;
  std::vector<unsigned> threadCounts = {0};
  unsigned repetitions = 5;
  bool isQuick = false;
};

CLI::App* addRivalsCommand(CLI::App& app, RivalsCommand& command);

/// Measures, writes the JSON and prints the tables; returns the exit status. Throws `UsageError`,
/// `Error` and `WrongAnswers`.
int runRivalsCommand(const RivalsCommand& command);

}  // namespace planetree::bench
