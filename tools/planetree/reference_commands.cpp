#include "reference_commands.hpp"

#include "command_options.hpp"
#include "completion_script.hpp"
#include "exit_status.hpp"
#include "man_page.hpp"
#include "output_file.hpp"
#include "parse_fault.hpp"

#include <span>

namespace planetree::tool {

namespace {

constexpr const char* kGroup = "About the tool";

constexpr const char* kCompletionNotes = R"(Examples:
  source <(planetree completion bash)
      completion in this bash; in ~/.bashrc, in all of them
  planetree completion zsh > ~/.zfunc/_planetree
      for zsh, in a folder of its fpath
  planetree completion fish > ~/.config/fish/completions/planetree.fish
      for fish

An installed planetree has put them where the shells look.
)";

constexpr const char* kManNotes = R"(Example:
  planetree man | man -l -

An installed planetree has it as man planetree.
)";

int print(const std::string& text) {
  writeFile(kStandardOutput, std::as_bytes(std::span(text)));
  return kDone;
}

/// CLI11's own function would print the help of the command that was given, which is this one.
std::string helpOf(const CLI::App& program) {
  return program.get_formatter()->make_help(&program, program.get_name(),
                                            CLI::AppFormatMode::Normal);
}

std::string anyText(const OptionText& option) {
  return std::string(option.text);
}

}  // namespace

CLI::App* addHelpCommand(CLI::App& app, HelpCommand& command) {
  CLI::App& help = *app.add_subcommand("help", "Print the help of a command");
  help.group(kGroup);
  addValue(help, "COMMAND", command.command, anyText,
           "Command to tell about; without one, all of them in short")
      ->type_name("");
  help.footer("");
  return &help;
}

CLI::App* addCompletionCommand(CLI::App& app, CompletionCommand& command) {
  CLI::App& completion =
      *app.add_subcommand("completion", "Print a script that completes command lines in a shell");
  completion.group(kGroup);
  completion.footer(kCompletionNotes);
  addValue(completion, "SHELL", command.shell, parseShell, "Shell to make it for")
      ->required()
      ->type_name("bash|zsh|fish");
  return &completion;
}

CLI::App* addManCommand(CLI::App& app, ManCommand& /*command*/) {
  CLI::App& man = *app.add_subcommand("man", "Print the manual page, for the program man");
  man.group(kGroup);
  man.footer(kManNotes);
  return &man;
}

int runHelpCommand(const HelpCommand& command, const CLI::App& app) {
  if (!command.command)
    return print(helpOf(app));
  for (const CLI::App* const found : app.get_subcommands({})) {
    if (found->get_name() == *command.command)
      return print(found->help(app.get_name()));
  }
  throw noSuchCommand(app, *command.command);
}

int runCompletionCommand(const CompletionCommand& command, const CLI::App& app) {
  const CommandSyntax program = commandSyntax(app);
  switch (command.shell) {
    case Shell::Bash:
      return print(bashCompletion(program));
    case Shell::Zsh:
      return print(zshCompletion(program));
    case Shell::Fish:
      return print(fishCompletion(program));
  }
  return kFailed;
}

int runManCommand(const ManCommand& /*command*/, const CLI::App& app) {
  return print(manPage(commandSyntax(app)));
}

}  // namespace planetree::tool
