#include "completion_script.hpp"

#include <fmt/format.h>

#include <vector>

namespace planetree::tool {

namespace {

/// The text inside of '...' and inside of [...] or before a colon of _arguments and _describe.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'')
      result += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      result += std::string("\\") + c;
    else
      result += c;
  }
  return result;
}

/// ":FILE:_files" and the like: what is asked for, and what completes it.
std::string action(const OptionSyntax& option, const std::string& commandNames) {
  const std::string message = escaped(option.value);
  switch (option.kind) {
    case ValueKind::Choice:
      return fmt::format(":{}:({})", message, fmt::join(option.choices, " "));
    case ValueKind::Model:
      return fmt::format(":{}:_files -g \"(#i)*.({})(-.)\"", message,
                         fmt::join(modelExtensions(), "|"));
    case ValueKind::File:
      return fmt::format(":{}:_files", message);
    case ValueKind::Command:
      return fmt::format(":{}:({})", message, commandNames);
    case ValueKind::Text:
      return fmt::format(":{}: ", message);
    case ValueKind::Nothing:
      break;
  }
  return "";
}

/// One argument of _arguments for each name of an option; those of one option exclude each other.
std::string optionSpec(const OptionSyntax& option, const std::string& commandNames) {
  std::string text;
  for (const std::string& name : option.names) {
    const bool isLong = name.starts_with("--");
    const std::string takesValue = option.kind == ValueKind::Nothing ? "" : isLong ? "=" : "+";
    const std::string exclusion =
        option.names.size() > 1 ? fmt::format("({})", fmt::join(option.names, " ")) : "";
    text += fmt::format(" \\\n        '{}{}{}[{}]{}'", exclusion, name, takesValue,
                        escaped(option.description), action(option, commandNames));
  }
  return text;
}

std::string commandCase(const CommandSyntax& command, const std::string& commandNames) {
  std::string text = fmt::format("    {})\n      _arguments -s", command.name);
  for (const OptionSyntax& option : command.options) {
    if (!option.isPositional) {
      text += optionSpec(option, commandNames);
    } else {
      const char* const colon = option.isRequired ? ":" : "::";
      text += fmt::format(" \\\n        '{}{}'", colon, action(option, commandNames).substr(1));
    }
  }
  return text + "\n      ;;\n";
}

}  // namespace

std::string zshCompletion(const CommandSyntax& program) {
  std::vector<std::string> names;
  std::string described;
  for (const CommandSyntax& command : program.commands) {
    names.push_back(command.name);
    described += fmt::format("    '{}:{}'\n", command.name, escaped(command.description));
  }
  const std::string commandNames = fmt::format("{}", fmt::join(names, " "));

  std::string text =
      "#compdef planetree\n# Completion of planetree for zsh, made by: planetree completion zsh\n\n"
      "_planetree() {\n  local context state state_descr line\n  typeset -A opt_args\n"
      "  local -a commands=(\n" +
      described + "  )\n\n  _arguments -C";
  for (const OptionSyntax& option : program.options)
    text += optionSpec(option, commandNames);
  text +=
      " \\\n        ':command:->command' '*::argument:->argument'\n"
      "  if [[ $state == command ]]; then\n    _describe command commands\n    return\n  fi\n"
      "  [[ $state == argument ]] || return\n  case $line[1] in\n";
  for (const CommandSyntax& command : program.commands)
    text += commandCase(command, commandNames);
  // The file may be sourced, or found and called by the completion system.
  return text +
         "  esac\n}\n\nif [[ $funcstack[1] == _planetree ]]; then\n  _planetree \"$@\"\nelse\n"
         "  compdef _planetree planetree\nfi\n";
}

}  // namespace planetree::tool
