#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace planetree::tool {

/// A bar of at most `width` columns, for terminals: `value` of `highest`, in steps of an eighth of
/// a column. What is not zero is always seen. Nothing stands behind the end of the bar.
[[nodiscard]] std::string textBar(double value, double highest, std::size_t width);

/// The columns that UTF-8 text takes, for text without wide and combining characters.
[[nodiscard]] std::size_t columnCount(std::string_view text) noexcept;

/// The text in at most that many columns; if it is longer, its end is replaced by an ellipsis.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t width);

/// The text in that many columns, with blanks behind it or before it.
[[nodiscard]] std::string padded(std::string text, std::size_t width);
[[nodiscard]] std::string paddedLeft(const std::string& text, std::size_t width);

}  // namespace planetree::tool
