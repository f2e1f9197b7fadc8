#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdint>
#include <string>
#include <vector>

/// The command line as plain data, read off the definitions of the options: what completions and
/// the manual are made from.
namespace planetree::tool {

/// What an option takes, as the word behind its name says.
enum class ValueKind : std::uint8_t {
  Nothing,  ///< a flag
  Choice,   ///< "a|b": one of these words
  Model,    ///< "MODEL": a file with a mesh
  File,     ///< "FILE", "FILE.svg", "RAYS": any file
  Command,  ///< "COMMAND": a subcommand
  Text,     ///< anything else
};

struct OptionSyntax {
  std::vector<std::string> names;  ///< "-o", "--output"; "MODEL" for a positional
  std::string value;               ///< "FILE"; empty for flags
  ValueKind kind = ValueKind::Nothing;
  std::vector<std::string> choices;  ///< of a `Choice`
  std::string description;           ///< one line
  std::string defaultValue;          ///< may be empty
  std::string group;                 ///< "Tree"
  bool isPositional = false;
  bool isRequired = false;
};

struct CommandSyntax {
  std::string name;         ///< "trace"; "planetree" for the program itself
  std::string description;  ///< one line
  std::string notes;        ///< what the help says after the options
  std::string group;
  std::vector<OptionSyntax> options;  ///< in their order, the positional ones too
  std::vector<CommandSyntax> commands;
};

/// How the names of most models end, without the dot; docs/model_files.md has all of them.
[[nodiscard]] const std::vector<std::string>& modelExtensions();

[[nodiscard]] OptionSyntax optionSyntax(const CLI::Option& option);
[[nodiscard]] CommandSyntax commandSyntax(const CLI::App& app);

}  // namespace planetree::tool
