#include "completion_script.hpp"

#include <fmt/format.h>

#include <vector>

namespace planetree::tool {

namespace {

// Words are completed by hand and not with -o default: where a command takes no file, none is
// offered. The = between an option and its value is a word of its own in bash.
constexpr const char* kFunctions =
    R"(# Adds the words that begin with what was typed: _planetree_words WORD...
_planetree_words() {
  local candidate
  for candidate in "$@"; do
    if [[ $candidate == "$word"* ]]; then COMPREPLY+=("$candidate"); fi
  done
}

# Adds the files whose names end as one of these, and folders: _planetree_files [EXTENSION...]
_planetree_files() {
  local file extension
  compopt -o filenames 2>/dev/null
  while IFS= read -r file; do
    if (($# == 0)) || [[ -d $file ]]; then COMPREPLY+=("$file"); continue; fi
    for extension in "$@"; do
      if [[ ${file,,} == *."$extension" ]]; then COMPREPLY+=("$file"); break; fi
    done
  done < <(compgen -f -- "$word")
}

)";

constexpr const char* kStart = R"(_planetree() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command='' i
  COMPREPLY=()
  if [[ $word == = ]]; then
    word=''
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    if [[ ${COMP_WORDS[i]} != -* ]]; then command=${COMP_WORDS[i]}; break; fi
  done

)";

/// The call that completes the value of an option.
std::string callFor(const OptionSyntax& option, const std::string& commandNames) {
  switch (option.kind) {
    case ValueKind::Choice:
      return fmt::format("_planetree_words {}", fmt::join(option.choices, " "));
    case ValueKind::Model:
      return fmt::format("_planetree_files {}", fmt::join(modelExtensions(), " "));
    case ValueKind::File:
      return "_planetree_files";
    case ValueKind::Command:
      return "_planetree_words " + commandNames;
    case ValueKind::Text:
    case ValueKind::Nothing:
      break;
  }
  return ":";
}

std::vector<std::string> optionNames(const CommandSyntax& command) {
  std::vector<std::string> names;
  for (const OptionSyntax& option : command.options) {
    if (!option.isPositional)
      names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

/// What may stand where no option is typed: whatever any of the arguments can be.
std::string argumentCalls(const CommandSyntax& command, const std::string& commandNames) {
  std::vector<std::string> calls;
  for (const OptionSyntax& option : command.options) {
    if (option.isPositional)
      calls.push_back(callFor(option, commandNames));
  }
  // A model is a file, too.
  for (const std::string& call : calls) {
    if (call == "_planetree_files")
      return call;
  }
  return calls.empty() ? ":" : calls.front();
}

std::string commandCase(const CommandSyntax& command, const std::string& commandNames) {
  std::string text = fmt::format("    {})\n      case $previous in\n", command.name);
  for (const OptionSyntax& option : command.options) {
    if (option.isPositional || option.kind == ValueKind::Nothing)
      continue;
    text += fmt::format("        {}) {}; return ;;\n", fmt::join(option.names, " | "),
                        callFor(option, commandNames));
  }
  text += "      esac\n";
  text += fmt::format("      if [[ $word == -* ]]; then\n        _planetree_words {}\n",
                      fmt::join(optionNames(command), " "));
  text += fmt::format("      else\n        {}\n      fi\n      ;;\n",
                      argumentCalls(command, commandNames));
  return text;
}

}  // namespace

std::string bashCompletion(const CommandSyntax& program) {
  std::vector<std::string> names;
  for (const CommandSyntax& command : program.commands)
    names.push_back(command.name);
  const std::string commandNames = fmt::format("{}", fmt::join(names, " "));

  std::string text = "# Completion of planetree for bash, made by: planetree completion bash\n\n";
  text += kFunctions;
  text += kStart;
  text += "  case $command in\n";
  text += fmt::format("    '') _planetree_words {} {} ;;\n", commandNames,
                      fmt::join(optionNames(program), " "));
  for (const CommandSyntax& command : program.commands)
    text += commandCase(command, commandNames);
  return text + "  esac\n}\n\ncomplete -F _planetree planetree\n";
}

}  // namespace planetree::tool
