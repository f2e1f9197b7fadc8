#pragma once

#include "render_command.hpp"

#include <string>

/// Options of `planetree render` that other subcommands have as well.
namespace planetree::tool {

/// MODEL, which may be left out; `verb` says what is done with it.
void addSubjectArgument(CLI::App& app, RenderCommand& command, const std::string& verb);
void addModeOption(CLI::App& app, RenderCommand& command);
/// --samples and --seed.
void addSampleOptions(CLI::App& app, RenderCommand& command);
/// --camera, --fov and --up.
void addViewOptions(CLI::App& app, RenderCommand& command);
/// All that mode whitted alone has.
void addWhittedOptions(CLI::App& app, RenderCommand& command);
/// --show-cells.
void addCellsOption(CLI::App& app, RenderCommand& command);

}  // namespace planetree::tool
