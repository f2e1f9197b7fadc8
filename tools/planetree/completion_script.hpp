#pragma once

#include "option_syntax.hpp"

#include <string>

/// Scripts that complete the tool's command lines in a shell: its commands, their options, the
/// words that an option takes, and files, where a model is wanted those that look like one.
namespace planetree::tool {

/// Needs nothing but bash itself.
[[nodiscard]] std::string bashCompletion(const CommandSyntax& program);
[[nodiscard]] std::string zshCompletion(const CommandSyntax& program);
[[nodiscard]] std::string fishCompletion(const CommandSyntax& program);

}  // namespace planetree::tool
