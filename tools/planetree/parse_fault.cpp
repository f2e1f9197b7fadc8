#include "parse_fault.hpp"

#include "option_syntax.hpp"
#include "support/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace planetree::tool {

namespace {

/// The command that was being parsed: its name with that of the program, and what it takes.
struct Context {
  std::string name;
  CommandSyntax syntax;

  [[nodiscard]] std::string seeHelp() const { return fmt::format("See {} --help.", name); }

  [[nodiscard]] const OptionSyntax* findOption(std::string_view optionName) const {
    for (const OptionSyntax& option : syntax.options) {
      if (std::find(option.names.begin(), option.names.end(), optionName) != option.names.end())
        return &option;
    }
    return nullptr;
  }
};

Context contextOf(const CLI::App& app) {
  const std::vector<CLI::App*> begun = app.get_subcommands();
  if (begun.empty())
    return {app.get_name(), commandSyntax(app)};
  return {app.get_name() + " " + begun.front()->get_name(), commandSyntax(*begun.front())};
}

std::string adviceFor(const Context& context, const std::optional<std::string>& nearest) {
  return nearest ? fmt::format("Did you mean {}? {}", *nearest, context.seeHelp())
                 : context.seeHelp();
}

UsageError noSuchOption(const Context& context, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  std::vector<std::string> known;
  for (const OptionSyntax& option : context.syntax.options) {
    if (!option.isPositional)
      known.insert(known.end(), option.names.begin(), option.names.end());
  }
  if (context.findOption(name) != nullptr) {
    return {fmt::format("{}: stands before the command", name),
            fmt::format("Write it behind: {} ... {}.", context.name, name)};
  }
  return {fmt::format("{}: {} has no such option", name, context.name),
          adviceFor(context, detail::nearestName(name, known))};
}

UsageError unexpected(const CLI::App& app, const Context& context) {
  const std::vector<std::string> words = app.remaining(true);
  const auto isOption = [](const std::string& word) { return word.starts_with('-'); };
  const auto option = std::find_if(words.begin(), words.end(), isOption);
  if (option != words.end())
    return noSuchOption(context, *option);
  if (app.get_subcommands().empty() && !words.empty())
    return noSuchCommand(app, words.front());
  return {fmt::format("{}: one argument too many", words.empty() ? "" : words.back()),
          context.seeHelp()};
}

/// "--size: 1 required WxH missing", or a complaint that it stands there twice.
UsageError wrongCount(const Context& context, const std::string& message) {
  const std::string name = message.substr(0, message.find(':'));
  const OptionSyntax* const option = context.findOption(name);
  if (message.ends_with("missing") && option != nullptr) {
    return {fmt::format("{}: its value is missing", name),
            fmt::format("Give {} {}. {}", name, option->value, context.seeHelp())};
  }
  return {fmt::format("{}: given more than once", name), "Give it once."};
}

}  // namespace

UsageError usageErrorOf(const CLI::App& app, const CLI::ParseError& error) {
  const Context context = contextOf(app);
  const std::string message = error.what();
  // A misspelt command is missing, too, and its name is left over.
  const bool isCommandMissing = app.get_subcommands().empty() && !app.remaining().empty();
  if (isCommandMissing || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return unexpected(app, context);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    return wrongCount(context, message);
  const std::string required = " is required";
  if (message.ends_with(required)) {
    return {message.substr(0, message.size() - required.size()) + " is missing", context.seeHelp()};
  }
  const std::string notConverted = "Could not convert: ";
  if (message.starts_with(notConverted)) {
    const std::string name =
        message.substr(notConverted.size(), message.find(" =") - notConverted.size());
    return {fmt::format("{}: it takes no value", name), fmt::format("Give {} alone.", name)};
  }
  return {message, context.seeHelp()};
}

UsageError noSuchCommand(const CLI::App& app, std::string_view name) {
  std::vector<std::string> known;
  for (const CommandSyntax& command : commandSyntax(app).commands)
    known.push_back(command.name);
  return {fmt::format("{}: there is no such command", name),
          adviceFor({app.get_name(), {}}, detail::nearestName(name, known))};
}

}  // namespace planetree::tool
