#pragma once

#include <string>
#include <string_view>

namespace planetree::tool {

/// The text as a string of JSON, with its quotes.
[[nodiscard]] std::string jsonString(std::string_view text);

}  // namespace planetree::tool
