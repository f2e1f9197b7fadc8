#pragma once

#include "option_values.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <optional>
#include <string>

/// Commands that print what the command line itself is: help, completions, the manual.
namespace planetree::tool {

struct HelpCommand {
  std::optional<std::string> command;
};

struct CompletionCommand {
  Shell shell = Shell::Bash;
};

struct ManCommand {};

CLI::App* addHelpCommand(CLI::App& app, HelpCommand& command);
CLI::App* addCompletionCommand(CLI::App& app, CompletionCommand& command);
CLI::App* addManCommand(CLI::App& app, ManCommand& command);

/// Each prints on standard output, and returns the exit status of the tool. `app` is the whole
/// program.
[[nodiscard]] int runHelpCommand(const HelpCommand& command, const CLI::App& app);
[[nodiscard]] int runCompletionCommand(const CompletionCommand& command, const CLI::App& app);
[[nodiscard]] int runManCommand(const ManCommand& command, const CLI::App& app);

}  // namespace planetree::tool
