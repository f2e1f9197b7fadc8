#include "completion_script.hpp"

#include <fmt/format.h>

#include <vector>

namespace planetree::tool {

namespace {

/// In single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\')
      result += '\\';
    result += c;
  }
  return result + "'";
}

/// What completes a value; by itself fish offers no files.
std::string argumentsFor(const OptionSyntax& option, const std::string& commandNames) {
  switch (option.kind) {
    case ValueKind::Choice:
      return fmt::format(" -a {}", quoted(fmt::format("{}", fmt::join(option.choices, " "))));
    case ValueKind::Model:
      return " -a '(__planetree_models)'";
    case ValueKind::File:
      return " -F";
    case ValueKind::Command:
      return fmt::format(" -a {}", quoted(commandNames));
    case ValueKind::Text:
    case ValueKind::Nothing:
      break;
  }
  return "";
}

std::string optionLine(const OptionSyntax& option, const std::string& condition,
                       const std::string& commandNames) {
  std::string text = "complete -c planetree -n " + quoted(condition);
  for (const std::string& name : option.names) {
    if (option.isPositional)
      continue;
    const bool isLong = name.starts_with("--");
    text += (isLong ? " -l " : " -s ") + name.substr(isLong ? 2 : 1);
  }
  if (!option.isPositional && option.kind != ValueKind::Nothing)
    text += " -r";
  text += argumentsFor(option, commandNames);
  if (!option.isPositional)
    text += " -d " + quoted(option.description);
  return text + "\n";
}

}  // namespace

std::string fishCompletion(const CommandSyntax& program) {
  std::vector<std::string> names;
  for (const CommandSyntax& command : program.commands)
    names.push_back(command.name);
  const std::string commandNames = fmt::format("{}", fmt::join(names, " "));

  std::string text =
      "# Completion of planetree for fish, made by: planetree completion fish\n\n"
      "function __planetree_models\n"
      "  set -l token (commandline -ct)\n"
      "  for file in $token*\n"
      "    if test -d $file\n"
      "      echo $file/\n"
      "    else if string match -qir '\\.(" +
      fmt::format("{}", fmt::join(modelExtensions(), "|")) +
      ")$' -- $file\n"
      "      echo $file\n"
      "    end\n"
      "  end\n"
      "end\n\n"
      "complete -c planetree -f\n";
  const std::string noCommand = "__fish_use_subcommand";
  for (const OptionSyntax& option : program.options)
    text += optionLine(option, noCommand, commandNames);
  for (const CommandSyntax& command : program.commands) {
    text += fmt::format("complete -c planetree -n {} -a {} -d {}\n", quoted(noCommand),
                        command.name, quoted(command.description));
  }
  for (const CommandSyntax& command : program.commands) {
    text += "\n";
    for (const OptionSyntax& option : command.options)
      text += optionLine(option, "__fish_seen_subcommand_from " + command.name, commandNames);
  }
  return text;
}

}  // namespace planetree::tool
