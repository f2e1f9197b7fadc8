#pragma once

#include "option_syntax.hpp"

#include <string>

namespace planetree::tool {

/// The manual page planetree(1) in the language of man(7): all commands and options in one page.
/// Options that several commands have in common are described once.
[[nodiscard]] std::string manPage(const CommandSyntax& program);

}  // namespace planetree::tool
