#include "exit_status.hpp"
#include "render_command.hpp"
#include "talk.hpp"
#include "trace_command.hpp"
#include "usage_error.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace {

using namespace planetree::tool;

constexpr const char* kExamples = R"(Examples:
  planetree render                  a picture of a scene made in code
  planetree render bunny.obj        a picture of a model
  planetree trace bunny.obj r.csv   what each ray of a file hits
  planetree render --help           all options of a command
)";

int say(int status, const std::string& message) {
  printToStandardError("planetree: " + message + "\n");
  return status;
}

int run(int argc, char** argv) {
  CLI::App app("Ray queries with a kd-tree built by the surface area heuristic", "planetree");
  app.set_version_flag("--version", "planetree " PLANETREE_VERSION, "Print the version and exit");
  app.footer(kExamples);
  app.require_subcommand(1);
  RenderCommand renderCommand;
  addRenderCommand(app, renderCommand);
  TraceCommand traceCommand;
  const CLI::App* const trace = addTraceCommand(app, traceCommand);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    // --help or --version: what was asked for goes to standard output.
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    const std::vector<CLI::App*> begun = app.get_subcommands();
    const bool namesNoCommand = begun.empty() && argc > 1 && argv[1][0] != '-';
    if (namesNoCommand) {
      throw UsageError(fmt::format("{}: there is no such command", argv[1]),
                       "See planetree --help.");
    }
    const std::string command = begun.empty() ? "" : begun.front()->get_name() + " ";
    throw UsageError(error.what(), fmt::format("See planetree {}--help.", command));
  }
  if (trace->parsed())
    return runTraceCommand(traceCommand);
  return runRenderCommand(renderCommand);
}

}  // namespace

int main(int argc, char** argv) {
  // A closed pipe and a file size limit are then errors of the write, which are reported.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    return say(kWrongUsage, error.what());
  } catch (const std::bad_alloc&) {
    return say(kFailed, "out of memory. Try a model with fewer triangles, or a smaller picture.");
  } catch (const std::exception& error) {
    return say(kFailed, error.what());
  }
}
