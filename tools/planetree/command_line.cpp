#include "command_line.hpp"

#include "explain_command.hpp"
#include "help_formatter.hpp"
#include "info_command.hpp"
#include "render_command.hpp"
#include "trace_command.hpp"
#include "usage_error.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace planetree::tool {

namespace {

constexpr const char* kExamples = R"(Examples:
  planetree render                  a picture of a scene made in code
  planetree render bunny.obj        a picture of a model
  planetree trace bunny.obj r.csv   what each ray of a file hits
  planetree info bunny.obj          what the tree of a model is like
  planetree explain bunny.obj --ray 0,0,5,0,0,-1
                                    how one ray walks through the tree
  planetree render --help           all options of a command
)";

}  // namespace

CommandLine::CommandLine()
    : app_("Ray queries with a kd-tree built by the surface area heuristic", "planetree") {
  app_.formatter(std::make_shared<HelpFormatter>());
  app_.set_version_flag("--version", "planetree " PLANETREE_VERSION, "Print the version and exit");
  app_.footer(kExamples);
  app_.require_subcommand(1);
  add(addRenderCommand, runRenderCommand);
  add(addTraceCommand, runTraceCommand);
  add(addInfoCommand, runInfoCommand);
  add(addExplainCommand, runExplainCommand);
}

int CommandLine::run(int argc, const char* const* argv) {
  try {
    app_.parse(argc, argv);
  } catch (const CLI::Success& success) {
    // --help or --version: what was asked for goes to standard output.
    return app_.exit(success);
  } catch (const CLI::ParseError& error) {
    const std::vector<CLI::App*> begun = app_.get_subcommands();
    const bool namesNoCommand = begun.empty() && argc > 1 && argv[1][0] != '-';
    if (namesNoCommand) {
      throw UsageError(fmt::format("{}: there is no such command", argv[1]),
                       "See planetree --help.");
    }
    const std::string command = begun.empty() ? "" : begun.front()->get_name() + " ";
    throw UsageError(error.what(), fmt::format("See planetree {}--help.", command));
  }
  for (const Subcommand& subcommand : subcommands_) {
    if (subcommand.app->parsed())
      return subcommand.run();
  }
  return 0;
}

}  // namespace planetree::tool
