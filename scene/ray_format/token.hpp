#pragma once

#include <cstdint>
#include <string_view>

namespace planetree::scene::ray_format {

/// A place in the text of a scene, counted from 1; columns count bytes.
struct TextPlace {
  std::int64_t line = 1;
  std::int64_t column = 1;
};

enum class TokenKind : std::uint8_t {
  Word,         ///< a keyword or an unquoted name
  String,       ///< a quoted one
  Number,       ///< what begins like a number; it may turn out to be none
  Punctuation,  ///< one of ( ) { } , ; =
  End,          ///< of the file
};

/// The smallest piece of a scene that means something. It points into the text.
struct Token {
  TokenKind kind = TokenKind::End;
  std::string_view text = {};  ///< of strings without the quotes
  TextPlace place = {};

  [[nodiscard]] bool is(char punctuation) const noexcept {
    return kind == TokenKind::Punctuation && text.front() == punctuation;
  }
  [[nodiscard]] bool isWord(std::string_view word) const noexcept {
    return kind == TokenKind::Word && text == word;
  }
  /// Material names and names of files may stand with or without quotes, and begin with a digit:
  /// where a name is expected, "3d" is one, and so is "3".
  [[nodiscard]] bool isName() const noexcept {
    return kind == TokenKind::Word || kind == TokenKind::String ||
           (kind == TokenKind::Number && text.find_first_of("+-.") == std::string_view::npos);
  }
};

}  // namespace planetree::scene::ray_format
