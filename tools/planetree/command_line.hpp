#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <functional>
#include <memory>
#include <vector>

namespace planetree::tool {

/// The whole command line: all subcommands with their options, and what each of them does. The
/// definitions of the options are the only place where they are named: help, completions and the
/// manual are made from them.
class CommandLine {
 public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  [[nodiscard]] const CLI::App& app() const noexcept { return app_; }

  /// Parses the arguments and does what they say. Throws `UsageError` for what they may not say,
  /// and what the subcommand throws. Returns the exit status of the tool.
  [[nodiscard]] int run(int argc, const char* const* argv);

 private:
  struct Subcommand {
    const CLI::App* app;
    std::function<int()> run;
  };

  /// Adds a subcommand: `addOptions` makes its options, which fill a `Command`; `runCommand` gets
  /// it when they are parsed.
  template <class Command, class Run>
  void add(CLI::App* (*addOptions)(CLI::App&, Command&), const Run& runCommand) {
    const auto command = std::make_shared<Command>();
    CLI::App* const app = addOptions(app_, *command);
    if (app->get_group() == "Subcommands")  // what CLI11 calls them
      app->group("Commands");
    subcommands_.push_back({app, [command, runCommand] { return runCommand(*command); }});
  }

  CLI::App app_;
  std::vector<Subcommand> subcommands_;
};

}  // namespace planetree::tool
