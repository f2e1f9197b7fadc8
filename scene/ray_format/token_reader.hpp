#pragma once

#include "scene/ray_format/keywords.hpp"
#include "scene/ray_format/lexer.hpp"
#include "scene/ray_format/remarks.hpp"

#include <planetree/geometry/vec3.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planetree::scene::ray_format {

/// Reads the parts that all statements are made of. What is not as expected is an `Error` with
/// `MalformedFile` that names the place, what was expected and what was found.
///
/// A copy of it can read a part a second time.
class TokenReader {
 public:
  /// `remarks` must outlive it.
  TokenReader(const Lexer& lexer, Remarks& remarks)
      : lexer_(lexer), remarks_(&remarks), next_(lexer_.next()) {}

  [[nodiscard]] const Token& peek() const noexcept { return next_; }
  Token take();
  /// Goes on if this comes next.
  bool takeIf(char punctuation);
  void skipSemicolons();

  /// `where` ends the sentence "expected ')' ...".
  void expect(char punctuation, std::string_view where, std::string_view advice);

  /// "=", behind this keyword.
  void expectEquals(const Token& keyword);
  [[nodiscard]] double number();
  [[nodiscard]] std::array<double, 4> fourNumbers();
  [[nodiscard]] Vec3d vector();
  [[nodiscard]] std::array<double, 2> twoNumbers();
  /// Zero or more. `what` is what it is: "a shininess".
  [[nodiscard]] double amount(std::string_view what);
  /// More than zero.
  [[nodiscard]] double positiveNumber(std::string_view what);
  /// "(red, green, blue)", none of them negative.
  [[nodiscard]] Vec3d colour();
  [[nodiscard]] bool boolean();
  /// A word or a string, not empty.
  [[nodiscard]] Token name(std::string_view whose);

  /// "= (x, y, z)" and the like, behind this keyword.
  [[nodiscard]] double numberOf(const Token& keyword);
  [[nodiscard]] Vec3d vectorOf(const Token& keyword);
  [[nodiscard]] double amountOf(const Token& keyword, std::string_view what);
  [[nodiscard]] Vec3d colourOf(const Token& keyword);
  /// "= name" or "name", behind its keyword.
  [[nodiscard]] Token nameOf(std::string_view whose);

  /// Calls `readEntry(keyword)` for each statement between the braces.
  template <class ReadEntry>
  void block(const BlockSyntax& syntax, ReadEntry readEntry) {
    OpenBlock open = beginBlock(syntax);
    while (!endsBlock())
      readEntry(keyword(open));
  }

  /// Calls `readElement()` for each element of "(..., ...)".
  template <class ReadElement>
  void list(std::string_view what, ReadElement readElement) {
    beginList(what);
    if (takeIf(')'))
      return;
    do {
      readElement();
    } while (takeIf(','));
    endList(what);
  }

  /// The error at a place where something else should be.
  [[nodiscard]] Error unexpected(const Token& found, std::string_view expected,
                                 const std::string& advice) const;
  [[nodiscard]] Error malformed(TextPlace place, const std::string& problem,
                                const std::string& advice) const {
    return lexer_.malformed(place, problem, advice);
  }
  [[nodiscard]] const std::string& fileName() const noexcept { return lexer_.name(); }
  void remark(TextPlace place, const std::string& text) { remarks_->add(lexer_, place, text); }

 private:
  struct OpenBlock {
    const BlockSyntax& syntax;
    TextPlace begin;
    std::array<std::optional<TextPlace>, BlockSyntax::kMostKeywords> seen = {};
  };
  /// "(a, b, ...)"; reads each of them by `readNumber()`.
  template <std::size_t count, class ReadNumber>
  [[nodiscard]] std::array<double, count> numbers(ReadNumber readNumber);
  [[nodiscard]] OpenBlock beginBlock(const BlockSyntax& syntax);
  [[nodiscard]] bool endsBlock();
  /// The next keyword, in its spelling in the syntax.
  [[nodiscard]] Token keyword(OpenBlock& block);
  void noteRepeat(const BlockSyntax& syntax, const Token& keyword, TextPlace before);
  void beginList(std::string_view what);
  void endList(std::string_view what);

  Lexer lexer_;
  Remarks* remarks_;
  Token next_;
};

/// "line 3, column 14"
[[nodiscard]] std::string describe(TextPlace place);
/// A token for the end of "expected ..., found ...".
[[nodiscard]] std::string describe(const Token& token);
/// "Did you mean 'sphere'?" or, if nothing is near, `otherwise`.
[[nodiscard]] std::string adviseNearest(const Token& found, std::span<const std::string_view> known,
                                        const std::string& otherwise);
/// "a, b and c"
[[nodiscard]] std::string enumerate(std::span<const std::string_view> words);

}  // namespace planetree::scene::ray_format
