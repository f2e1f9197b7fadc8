#pragma once

#include "usage_error.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <string>
#include <string_view>

namespace planetree::tool {

/// What CLI11 finds wrong with a command line, in our words and with advice. `app` has just failed
/// to parse it.
[[nodiscard]] UsageError usageErrorOf(const CLI::App& app, const CLI::ParseError& error);

/// The name is not one of a command; the advice names the nearest that is.
[[nodiscard]] UsageError noSuchCommand(const CLI::App& app, std::string_view name);

}  // namespace planetree::tool
