#include "man_page.hpp"

#include "help_formatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace planetree::tool {

namespace {

constexpr const char* kEnd = R"(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
Failed: a file cannot be read or written, or a model has nothing to hit.
.TP
.B 2
Wrong usage: the command line asks for something that cannot be.
.PP
A signal ends the tool at once, as shells show it with 128 added: 130 after
Ctrl\-C, 143 after SIGTERM.
.SH ENVIRONMENT
.TP
.B PLANETREE_ISA
The instruction set to use in place of the best one that the machine has, which
.B planetree info
names. It changes no answer, only how long it takes.
.SH FILES
Results are written under a temporary name,
.IR .planetree\-PROCESS\-N.tmp ,
beside the final one, and renamed when they are complete.
After a failure or a signal nothing of them is left, and an older file is still
there.
.SH STREAMS
Data goes to standard output, and everything else to standard error.
With
.B \-
as its name a file is standard input or output.
)";

/// Text as it is, in lines of the source: nothing of it is taken for a request.
std::string escaped(std::string_view text) {
  std::string result;
  bool isLineStart = true;
  for (const char c : text) {
    if (isLineStart && (c == '.' || c == '\''))
      result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
    isLineStart = c == '\n';
  }
  return result;
}

/// A sentence in short lines of the source, which the page is not laid out by.
std::string sentence(const std::string& text) {
  constexpr std::size_t kSourceWidth = 66;
  std::string lines;
  for (const std::string& line : wrapped(text, kSourceWidth))
    lines += escaped(line) + "\n";
  return lines;
}

std::string bold(std::string_view text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(std::string_view text) {
  return "\\fI" + escaped(text) + "\\fR";
}

std::string upperCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string optionParagraph(const OptionSyntax& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names)
    names.push_back(option.isPositional ? italic(name) : bold(name));
  std::string text = fmt::format(".TP\n{}", fmt::join(names, ", "));
  if (!option.isPositional && option.kind != ValueKind::Nothing)
    text += " " + italic(option.value);
  text += "\n" + sentence(option.description + ".");
  if (!option.defaultValue.empty())
    text += fmt::format("The default is {}.\n", bold(option.defaultValue));
  return text;
}

/// Text that is laid out already.
std::string verbatim(std::string_view text) {
  while (text.ends_with('\n'))
    text.remove_suffix(1);
  return text.empty() ? "" : fmt::format(".nf\n{}\n.fi\n", escaped(text));
}

std::string synopsis(const CommandSyntax& program, const CommandSyntax& command) {
  std::string text = bold(program.name + " " + command.name) + " [" + italic("OPTIONS") + "]";
  for (const OptionSyntax& option : command.options) {
    if (option.isPositional)
      text += option.isRequired ? " " + italic(option.names.back())
                                : " [" + italic(option.names.back()) + "]";
  }
  return text + "\n";
}

bool isSame(const OptionSyntax& a, const OptionSyntax& b) {
  return a.names == b.names && a.value == b.value && a.description == b.description;
}

bool has(const CommandSyntax& command, const OptionSyntax& option) {
  return std::any_of(command.options.begin(), command.options.end(),
                     [&](const OptionSyntax& other) { return isSame(option, other); });
}

bool isCommon(const CommandSyntax& program, const OptionSyntax& option) {
  const auto count =
      std::count_if(program.commands.begin(), program.commands.end(),
                    [&](const CommandSyntax& command) { return has(command, option); });
  return count > 1 && !option.isPositional;
}

std::string commandSection(const CommandSyntax& program, const CommandSyntax& command) {
  std::string text = fmt::format(".SS {} {}\n", program.name, command.name);
  text += synopsis(program, command);
  text += ".PP\n" + sentence(command.description + ".");
  std::vector<std::string> common;
  for (const OptionSyntax& option : command.options) {
    if (isCommon(program, option))
      common.push_back(bold(option.names.back()));
    else
      text += optionParagraph(option);
  }
  text +=
      fmt::format(".PP\nOptions in common with other commands: {}.\n", fmt::join(common, ",\n"));
  const std::string notes = verbatim(command.notes);
  return notes.empty() ? text : text + ".PP\n" + notes;
}

/// What several commands have in common, in the groups of the help.
std::string commonOptions(const CommandSyntax& program) {
  std::vector<OptionSyntax> common;
  std::vector<std::string> groups;
  for (const CommandSyntax& command : program.commands) {
    for (const OptionSyntax& option : command.options) {
      const bool isKnown =
          std::any_of(common.begin(), common.end(),
                      [&](const OptionSyntax& other) { return isSame(option, other); });
      if (isKnown || !isCommon(program, option))
        continue;
      common.push_back(option);
      if (std::find(groups.begin(), groups.end(), option.group) == groups.end())
        groups.push_back(option.group);
    }
  }
  std::string text = ".SH COMMON OPTIONS\n";
  for (const std::string& group : groups) {
    text += fmt::format(".SS {}\n", group);
    for (const OptionSyntax& option : common) {
      if (option.group == group)
        text += optionParagraph(option);
    }
  }
  return text;
}

}  // namespace

std::string manPage(const CommandSyntax& program) {
  std::string text =
      fmt::format(".\\\" Made by: planetree man\n.TH {} 1 {} \"planetree {}\" \"User Commands\"\n",
                  upperCase(program.name), PLANETREE_DATE, PLANETREE_VERSION);
  text += fmt::format(".SH NAME\n{} \\- {}\n", program.name, escaped(program.description));
  text += ".SH SYNOPSIS\n";
  for (const CommandSyntax& command : program.commands)
    text += (&command == &program.commands.front() ? "" : ".br\n") + synopsis(program, command);
  text += ".SH COMMANDS\n";
  for (const CommandSyntax& command : program.commands)
    text += commandSection(program, command);
  text += commonOptions(program);
  text += ".SH OPTIONS WITHOUT A COMMAND\n";
  for (const OptionSyntax& option : program.options)
    text += optionParagraph(option);
  return text + kEnd + ".SH EXAMPLES\n" + verbatim(program.notes);
}

}  // namespace planetree::tool
