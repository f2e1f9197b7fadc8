#include "command_line.hpp"

#include "compare_command.hpp"
#include "exit_status.hpp"
#include "explain_command.hpp"
#include "help_formatter.hpp"
#include "info_command.hpp"
#include "instruction_set_check.hpp"
#include "output_file.hpp"
#include "parse_fault.hpp"
#include "reference_commands.hpp"
#include "render_command.hpp"
#include "talk.hpp"
#include "trace_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <span>
#include <sstream>
#include <string>

namespace planetree::tool {

namespace {

constexpr const char* kExamples = R"(Examples:
  planetree render                        a picture of a scene made in code
  planetree render bunny.obj              a picture of a model
  planetree trace bunny.obj rays.csv      what each ray of a file hits
  planetree info bunny.obj                what the tree of a model is like
  planetree explain bunny.obj --ray 0,0,5,0,0,-1
                                          how one ray walks through the tree
  planetree compare bunny.obj             what each preset makes of a model
  planetree help trace                    all options of a command
)";

std::string versionText() {
#if defined(__clang__)
  constexpr const char* compiler = "clang++ " __clang_version__;
#else
  constexpr const char* compiler = "g++ " __VERSION__;
#endif
  return fmt::format("planetree {}\ncompiled by {}", PLANETREE_VERSION, compiler);
}

}  // namespace

CommandLine::CommandLine()
    : app_("Ray queries with a kd-tree built by the surface area heuristic", "planetree") {
  app_.formatter(std::make_shared<HelpFormatter>());
  app_.set_version_flag("--version", versionText(), "Print the version and exit");
  app_.footer(kExamples);
  app_.require_subcommand(1);
  app_.get_help_ptr()->description("Print this help and exit");
  add(addRenderCommand, runRenderCommand);
  add(addTraceCommand, runTraceCommand);
  add(addInfoCommand, runInfoCommand);
  add(addExplainCommand, runExplainCommand);
  add(addCompareCommand, runCompareCommand);
  add(addHelpCommand, [this](const HelpCommand& c) { return runHelpCommand(c, app_); });
  add(addCompletionCommand,
      [this](const CompletionCommand& c) { return runCompletionCommand(c, app_); });
  add(addManCommand, [this](const ManCommand& c) { return runManCommand(c, app_); });
}

int CommandLine::run(int argc, const char* const* argv) {
  try {
    app_.parse(argc, argv);
  } catch (const CLI::Success& success) {
    // --help or --version: what was asked for goes to standard output.
    std::ostringstream out;
    const int status = app_.exit(success, out, out);
    const std::string text = out.str();
    writeFile(kStandardOutput, std::as_bytes(std::span(text)));
    return status;
  } catch (const CLI::ParseError& error) {
    if (argc <= 1) {
      printToStandardError(app_.help());
      return kWrongUsage;
    }
    throw usageErrorOf(app_, error);
  }
  checkRequestedInstructionSet();
  for (const Subcommand& subcommand : subcommands_) {
    if (subcommand.app->parsed())
      return subcommand.run();
  }
  return kWrongUsage;
}

}  // namespace planetree::tool
