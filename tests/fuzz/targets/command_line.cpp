#include "explain_command.hpp"
#include "info_command.hpp"
#include "instruments/ray_option.hpp"
#include "parse_fault.hpp"
#include "reference_commands.hpp"
#include "render_command.hpp"
#include "trace_command.hpp"
#include "usage_error.hpp"

#include "support/byte_stream.hpp"
#include "support/promise.hpp"
#include "support/take_options.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

// Any words as the arguments of the tool, one in each line. They are parsed, and nothing is run.

namespace planetree::fuzz {
namespace {

/// The options of all commands, as `CommandLine` has them.
struct Commands {
  CLI::App app{"", "planetree"};
  tool::RenderCommand render;
  tool::TraceCommand trace;
  tool::InfoCommand info;
  tool::ExplainCommand explain;
  tool::HelpCommand help;
  tool::CompletionCommand completion;
  tool::ManCommand man;

  Commands() {
    app.set_version_flag("--version", "0");
    app.require_subcommand(1);
    tool::addRenderCommand(app, render);
    tool::addTraceCommand(app, trace);
    tool::addInfoCommand(app, info);
    tool::addExplainCommand(app, explain);
    tool::addHelpCommand(app, help);
    tool::addCompletionCommand(app, completion);
    tool::addManCommand(app, man);
  }
};

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    // The system hands no word over beyond a zero.
    const std::string_view line = text.substr(0, end);
    lines.emplace_back(line.substr(0, line.find('\0')));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void requireBuildable(const tool::TreeOptions& tree, const tool::RunOptions& run) {
  const BuildOptions options = tool::buildOptions(tree, run);
  require(areValid(options), "whatever the tool takes for build options the library takes, too");
  require(options.threadCount <= 1024, "threads are few");
}

/// What the commands themselves look at before they open a file.
void lookAt(const Commands& commands) {
  const tool::RenderCommand& render = commands.render;
  requireBuildable(render.tree, render.run);
  require(render.size.width > 0 && render.size.height != 0u, "a picture has pixels");
  requireBuildable(commands.info.tree, commands.info.run);
  requireBuildable(commands.trace.tree, commands.trace.run);
  const tool::ExplainCommand& explain = commands.explain;
  requireBuildable(explain.tree, explain.run);
  tool::checkRayLimits(commands.trace.limits);
  tool::checkRayLimits(explain.limits);
  const tool::OptionText ray{"--ray", explain.ray};
  const Rayf inFloat = tool::parseRay<float>(ray, explain.limits);
  require(isFinite(inFloat.origin) && inFloat.tMin <= inFloat.tMax, "a ray that is taken can hit");
  const Rayd inDouble = tool::parseRay<double>(ray, explain.limits);
  require(isFinite(inDouble.origin) && inDouble.tMin <= inDouble.tMax, "in double as well");
}

void parse(const std::vector<std::string>& words) {
  Commands commands;
  std::vector<const char*> arguments = {"planetree"};
  for (const std::string& word : words)
    arguments.push_back(word.c_str());
  try {
    commands.app.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::Success&) {
    return;
  } catch (const CLI::ParseError& error) {
    throw tool::usageErrorOf(commands.app, error);
  }
  lookAt(commands);
}

}  // namespace
}  // namespace planetree::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace planetree;
  try {
    fuzz::parse(fuzz::linesOf(fuzz::ByteStream(data, size).text()));
  } catch (const tool::UsageError& error) {
    fuzz::require(std::string_view(error.what()).size() > 3, "a usage error says something");
  }
  return 0;
}
