#include "help_formatter.hpp"

#include "option_syntax.hpp"

#include <fmt/format.h>

#include <utility>

namespace planetree::tool {

namespace {

constexpr std::size_t kTerminalWidth = 80;
constexpr std::size_t kDescriptionColumn = 30;

/// A name and what it means, side by side where the name leaves room.
std::string twoColumns(const std::string& name, const std::string& description) {
  const std::string indent(kDescriptionColumn, ' ');
  std::string text = "  " + name;
  const bool leavesRoom = text.size() + 2 <= kDescriptionColumn;
  text += leavesRoom ? indent.substr(text.size()) : "\n" + indent;
  const auto lines = wrapped(description, kTerminalWidth - kDescriptionColumn);
  return text + fmt::format("{}\n", fmt::join(lines, "\n" + indent));
}

std::string described(const OptionSyntax& option) {
  return option.defaultValue.empty()
             ? option.description
             : fmt::format("{} (default {})", option.description, option.defaultValue);
}

}  // namespace

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  const CommandSyntax syntax = commandSyntax(*app);
  std::string usage = "\nUsage: " + name;
  if (!syntax.commands.empty())
    return usage + " COMMAND [OPTIONS]\n";
  usage += " [OPTIONS]";
  for (const OptionSyntax& option : syntax.options) {
    if (option.isPositional)
      usage += option.isRequired ? " " + option.names.back() : " [" + option.names.back() + "]";
  }
  return usage + "\n";
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return commandSyntax(*app).description + ".\n";
}

std::string HelpFormatter::make_group(std::string group, bool isPositional,
                                      std::vector<const CLI::Option*> options) const {
  // CLI11 ends each group but the last one with a blank line; the first one needs one before it.
  const bool isFirst = isPositional || group == "Options";
  std::string text =
      fmt::format("{}{}:\n", isFirst ? "\n" : "", isPositional ? "Arguments" : group);
  for (const CLI::Option* const option : options)
    text += make_option(option, isPositional);
  return text;
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool isPositional) const {
  const OptionSyntax syntax = optionSyntax(*option);
  std::string name = fmt::format("{}", fmt::join(syntax.names, ", "));
  if (!isPositional && !syntax.value.empty())
    name += " " + syntax.value;
  return twoColumns(name, described(syntax));
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return twoColumns(command->get_name(), command->get_description());
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const std::size_t end = text.find_first_of(" \n");
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (word.empty())
      continue;
    std::string& line = lines.back();
    if (line.empty()) {
      line = word;
    } else if (line.size() + 1 + word.size() <= width) {
      line.append(" ").append(word);
    } else {
      lines.emplace_back(word);
    }
  }
  return lines;
}

}  // namespace planetree::tool
