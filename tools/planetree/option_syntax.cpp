#include "option_syntax.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace planetree::tool {

namespace {

/// Descriptions may have line ends, for help that is not wrapped.
std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

bool isChoiceWord(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '-';
  });
}

/// The words of "a|b"; none if it is something else.
std::vector<std::string> choicesOf(std::string_view value) {
  std::vector<std::string> words;
  while (true) {
    const std::size_t bar = value.find('|');
    const std::string_view word = value.substr(0, bar);
    if (!isChoiceWord(word))
      return {};
    words.emplace_back(word);
    if (bar == std::string_view::npos)
      break;
    value.remove_prefix(bar + 1);
  }
  return words;
}

ValueKind kindOf(std::string_view value, const std::vector<std::string>& choices) {
  if (value.empty())
    return ValueKind::Nothing;
  if (!choices.empty())
    return ValueKind::Choice;
  if (value == "MODEL")
    return ValueKind::Model;
  if (value.starts_with("FILE") || value == "RAYS")
    return ValueKind::File;
  return value == "COMMAND" ? ValueKind::Command : ValueKind::Text;
}

std::vector<std::string> namesOf(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& letter : option.get_snames())
    names.push_back("-" + letter);
  for (const std::string& word : option.get_lnames())
    names.push_back("--" + word);
  if (option.get_positional())
    names.push_back(option.get_name(true, false));
  return names;
}

}  // namespace

const std::vector<std::string>& modelExtensions() {
  static const std::vector<std::string> extensions = {"ply", "stl", "obj",   "off", "gltf", "glb",
                                                      "dae", "fbx", "blend", "3ds", "dxf",  "lwo"};
  return extensions;
}

OptionSyntax optionSyntax(const CLI::Option& option) {
  OptionSyntax syntax;
  syntax.names = namesOf(option);
  syntax.isPositional = option.get_positional();
  syntax.isRequired = option.get_required();
  syntax.description = oneLine(option.get_description());
  syntax.defaultValue = option.get_default_str();
  syntax.group = option.get_group();
  const bool takesValue = option.get_type_size() != 0;
  // A positional option is named after what it takes, unless it takes one of some words.
  if (takesValue)
    syntax.value = option.get_type_name();
  if (takesValue && syntax.isPositional && syntax.value.empty())
    syntax.value = syntax.names.back();
  syntax.choices = choicesOf(syntax.value);
  syntax.kind = kindOf(syntax.value, syntax.choices);
  return syntax;
}

CommandSyntax commandSyntax(const CLI::App& app) {
  CommandSyntax syntax{.name = app.get_name(),
                       .description = oneLine(app.get_description()),
                       .notes = app.get_footer(),
                       .group = app.get_group(),
                       .options = {},
                       .commands = {}};
  for (const CLI::Option* const option : app.get_options({})) {
    if (!option->get_group().empty())
      syntax.options.push_back(optionSyntax(*option));
  }
  for (const CLI::App* const command : app.get_subcommands({}))
    syntax.commands.push_back(commandSyntax(*command));
  return syntax;
}

}  // namespace planetree::tool
