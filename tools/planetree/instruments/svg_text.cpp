#include "instruments/svg_text.hpp"

#include <nlohmann/json.hpp>

namespace planetree::tool {

namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

/// JSON has to be UTF-8 too, and its writer replaces what is not.
std::string validUtf8(std::string_view text) {
  using nlohmann::json;
  const std::string quoted = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  return json::parse(quoted).get<std::string>();
}

}  // namespace

std::string xmlText(std::string_view text) {
  std::string safe;
  for (const char c : validUtf8(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') {
          safe += kReplacement;
        } else {
          safe += c;
        }
    }
  }
  return safe;
}

}  // namespace planetree::tool
