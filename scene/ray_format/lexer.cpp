#include "scene/ray_format/lexer.hpp"

#include "support/text_lines.hpp"

#include <algorithm>

namespace planetree::scene::ray_format {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kLineEnds = "\r\n";

// Not those of <cctype>, which depend on the locale.
constexpr bool isDigit(char c) noexcept {
  return c >= '0' && c <= '9';
}
constexpr bool isOfWord(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || isDigit(c);
}
constexpr bool beginsNumber(char c) noexcept {
  return isDigit(c) || c == '+' || c == '-' || c == '.';
}
/// Letters, too: 1x is to be one wrong number, not a number and a name.
constexpr bool isOfNumber(char c) noexcept {
  return beginsNumber(c) || isOfWord(c);
}
constexpr bool isPunctuation(char c) noexcept {
  return std::string_view("(){},;=").find(c) != std::string_view::npos;
}

/// Whether a line ends with this byte: "\n", "\r\n", and "\r" alone, as on old Macs.
bool endsLine(std::string_view text, std::size_t offset) noexcept {
  return text[offset] == '\n' ||
         (text[offset] == '\r' && !text.substr(offset + 1).starts_with('\n'));
}

template <class Predicate>
std::size_t lengthOf(std::string_view text, Predicate isPart) noexcept {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), isPart) -
                                  text.begin());
}

std::size_t lengthOfWord(std::string_view text) noexcept {
  const std::size_t length = lengthOf(text, isOfWord);
  const bool isFormatName =
      text.starts_with(kFormatName) && lengthOf(text.substr(kFormatName.size()), isOfWord) == 0;
  return isFormatName ? kFormatName.size() : length;
}

std::string describeByte(char c) {
  if (c > ' ' && c <= '~')
    return std::string("'") + c + "'";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  const auto value = static_cast<unsigned char>(c);
  return std::string("the byte 0x") + kDigits[value / 16] + kDigits[value % 16];
}

}  // namespace

Lexer::Lexer(std::span<const std::byte> text, const std::string& name) noexcept
    : text_(reinterpret_cast<const char*>(text.data()), text.size()), name_(&name) {
  if (text_.starts_with(kByteOrderMark))
    text_.remove_prefix(kByteOrderMark.size());
}

Token Lexer::next() {
  skipBlanksAndComments();
  if (offset_ == text_.size())
    return {TokenKind::End, {}, place()};
  const char first = text_[offset_];
  if (isPunctuation(first))
    return cut(TokenKind::Punctuation, 1);
  if (beginsNumber(first))
    return cut(TokenKind::Number, lengthOf(rest(), isOfNumber));
  if (isOfWord(first))
    return cut(TokenKind::Word, lengthOfWord(rest()));
  if (first == '"')
    return string();
  throw malformed(place(),
                  "expected a keyword, a number or a bracket, found " + describeByte(first),
                  "Names with other characters than letters, digits and _ stand in quotes");
}

void Lexer::skipBlanksAndComments() {
  while (offset_ < text_.size()) {
    const char c = text_[offset_];
    if (endsLine(text_, offset_)) {
      ++offset_;
      ++line_;
      lineOffset_ = offset_;
    } else if (planetree::detail::isBlank(c)) {
      ++offset_;
    } else if (rest().starts_with("//")) {
      offset_ = std::min(text_.find_first_of(kLineEnds, offset_), text_.size());
    } else if (rest().starts_with("/*")) {
      skipLongComment();
    } else {
      return;
    }
  }
}

void Lexer::skipLongComment() {
  const std::size_t end = text_.find("*/", offset_ + 2);
  if (end == std::string_view::npos)
    throw malformed(place(), "expected the end of the comment, found the end of the file",
                    "Close the comment that begins here with */");
  for (; offset_ < end; ++offset_) {
    if (endsLine(text_, offset_)) {
      ++line_;
      lineOffset_ = offset_ + 1;
    }
  }
  offset_ = end + 2;
}

Token Lexer::string() {
  const std::string_view behindQuote = rest().substr(1);
  const std::size_t length = std::min(behindQuote.find_first_of("\"\r\n"), behindQuote.size());
  if (length == behindQuote.size() || behindQuote[length] != '"') {
    throw malformed(place(), "expected a closing quote in the line of the opening one, found none",
                    "Close the text that begins here with \"");
  }
  const std::string_view content = behindQuote.substr(0, length);
  const auto control = std::find_if(content.begin(), content.end(),
                                    [](char c) { return static_cast<unsigned char>(c) < ' '; });
  if (control != content.end()) {
    TextPlace inside = place();
    inside.column += control - content.begin() + 1;
    throw malformed(inside, "expected a text that can be read, found " + describeByte(*control),
                    "Take control characters out of the quotes");
  }
  Token token = cut(TokenKind::String, length + 2);
  token.text = content;
  return token;
}

Token Lexer::cut(TokenKind kind, std::size_t length) noexcept {
  const Token token = {kind, text_.substr(offset_, length), place()};
  offset_ += length;
  return token;
}

TextPlace Lexer::place() const noexcept {
  return {line_, static_cast<std::int64_t>(offset_ - lineOffset_) + 1};
}

Error Lexer::malformed(TextPlace place, const std::string& problem,
                       const std::string& advice) const {
  return Error(ErrorCode::MalformedFile, problem, advice,
               Error::Place{.file = *name_, .line = place.line, .column = place.column});
}

std::string Lexer::remark(TextPlace place, const std::string& text) const {
  return *name_ + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": " +
         text;
}

}  // namespace planetree::scene::ray_format
