#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace planetree::tool {

/// The text between tags or in an attribute of XML: escaped, and whatever XML cannot hold (control
/// characters, bytes that are no UTF-8) replaced by the mark for it.
[[nodiscard]] std::string xmlText(std::string_view text);

/// Lines of an SVG picture.
class SvgText {
 public:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace planetree::tool
