#pragma once

#include "scene/ray_format/token.hpp"

#include <planetree/error.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace planetree::scene::ray_format {

/// The two words every scene begins with are one, though there is a hyphen in it.
inline constexpr std::string_view kFormatName = "SBT-raytracer";

/// Cuts the text of a scene into tokens, one after the other, and leaves blanks and comments out.
/// It keeps nothing but its place, so a copy of it can read a part a second time.
///
/// `text` and `name` must outlive it.
class Lexer {
 public:
  Lexer(std::span<const std::byte> text, const std::string& name) noexcept;

  /// The next token; at the end of the text, always `End`. Throws `Error` with `MalformedFile` for
  /// bytes that belong to no token, and for comments and strings without an end.
  [[nodiscard]] Token next();

  /// An error with `MalformedFile` at that place, to be thrown.
  [[nodiscard]] Error malformed(TextPlace place, const std::string& problem,
                                const std::string& advice) const;
  /// A line for `SceneDescription::remarks`.
  [[nodiscard]] std::string remark(TextPlace place, const std::string& text) const;

  [[nodiscard]] const std::string& name() const noexcept { return *name_; }

 private:
  void skipBlanksAndComments();
  void skipLongComment();
  [[nodiscard]] Token string();
  /// The token of `kind` with the next bytes.
  [[nodiscard]] Token cut(TokenKind kind, std::size_t length) noexcept;
  [[nodiscard]] std::string_view rest() const noexcept { return text_.substr(offset_); }
  [[nodiscard]] TextPlace place() const noexcept;

  std::string_view text_;
  const std::string* name_;
  std::size_t offset_ = 0;
  std::size_t lineOffset_ = 0;  ///< where the present line begins
  std::int64_t line_ = 1;
};

}  // namespace planetree::scene::ray_format
