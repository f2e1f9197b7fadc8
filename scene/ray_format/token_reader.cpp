#include "scene/ray_format/token_reader.hpp"

#include "scene/value_ranges.hpp"
#include "support/nearest_name.hpp"
#include "support/parse_number.hpp"
#include "support/text_lines.hpp"

#include <cmath>
#include <optional>

namespace planetree::scene::ray_format {

using planetree::detail::quoted;

Token TokenReader::take() {
  const Token token = next_;
  next_ = lexer_.next();
  return token;
}

bool TokenReader::takeIf(char punctuation) {
  if (!next_.is(punctuation))
    return false;
  take();
  return true;
}

void TokenReader::skipSemicolons() {
  while (takeIf(';')) {
  }
}

void TokenReader::expect(char punctuation, std::string_view where, std::string_view advice) {
  if (!next_.is(punctuation)) {
    throw unexpected(
        next_,
        std::string("'") + punctuation + "'" + (where.empty() ? "" : " ") + std::string(where),
        std::string(advice));
  }
  take();
}

void TokenReader::expectEquals(const Token& keyword) {
  if (!next_.is('=')) {
    const std::string word(keyword.text);
    throw unexpected(next_, "'=' behind " + quoted(word), "Write " + word + " = ...");
  }
  take();
}

double TokenReader::number() {
  if (next_.kind != TokenKind::Number)
    throw unexpected(next_, "a number", "Numbers look like 2, -0.5 or 1e-3");
  const Token token = take();
  const std::optional<double> value = planetree::detail::parseNumber<double>(token.text);
  if (!value)
    throw unexpected(token, "a number", "Numbers look like 2, -0.5 or 1e-3");
  if (!std::isfinite(*value))
    throw unexpected(token, "a number", "It must be finite, and less than 1.8e308 in magnitude");
  return *value;
}

template <std::size_t count, class ReadNumber>
std::array<double, count> TokenReader::numbers(ReadNumber readNumber) {
  constexpr std::string_view kAdvice = count == 2   ? "Two numbers belong here: (u, v)"
                                       : count == 3 ? "Three numbers belong here: (x, y, z)"
                                                    : "Four numbers belong here: (a, b, c, d)";
  std::array<double, count> values;
  expect('(', "", kAdvice);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0)
      expect(',', "", kAdvice);
    values[i] = readNumber();
  }
  expect(')', "", kAdvice);
  return values;
}

std::array<double, 4> TokenReader::fourNumbers() {
  return numbers<4>([this] { return number(); });
}
std::array<double, 2> TokenReader::twoNumbers() {
  return numbers<2>([this] { return number(); });
}

Vec3d TokenReader::vector() {
  const std::array<double, 3> values = numbers<3>([this] { return number(); });
  return {values[0], values[1], values[2]};
}

double TokenReader::amount(std::string_view what) {
  const Token token = next_;
  const double value = number();
  if (!isAmount(value))
    throw unexpected(token, std::string(what) + " of 0 or more", "It cannot be negative");
  return value;
}

double TokenReader::positiveNumber(std::string_view what) {
  const Token token = next_;
  const double value = number();
  if (!isPositive(value)) {
    throw unexpected(token, std::string(what) + " above 0", "It can be neither negative nor 0");
  }
  return value;
}

Vec3d TokenReader::colour() {
  const std::array<double, 3> values = numbers<3>([this] { return amount("a part of a colour"); });
  return {values[0], values[1], values[2]};
}

bool TokenReader::boolean() {
  const bool isTrue = next_.isWord(kTrue);
  if (!isTrue && !next_.isWord(kFalse))
    throw unexpected(next_, "true or false", "Write one of the two");
  take();
  return isTrue;
}

Token TokenReader::name(std::string_view whose) {
  if (!next_.isName())
    throw unexpected(next_, "the name of " + std::string(whose),
                     "Names with other characters than letters, digits and _ stand in quotes");
  if (next_.text.empty())
    throw unexpected(next_, "the name of " + std::string(whose), "Put a name between the quotes");
  return take();
}

double TokenReader::numberOf(const Token& keyword) {
  expectEquals(keyword);
  return number();
}

Vec3d TokenReader::vectorOf(const Token& keyword) {
  expectEquals(keyword);
  return vector();
}

double TokenReader::amountOf(const Token& keyword, std::string_view what) {
  expectEquals(keyword);
  return amount(what);
}

Vec3d TokenReader::colourOf(const Token& keyword) {
  expectEquals(keyword);
  return colour();
}

Token TokenReader::nameOf(std::string_view whose) {
  takeIf('=');
  return name(whose);
}

TokenReader::OpenBlock TokenReader::beginBlock(const BlockSyntax& syntax) {
  if (!next_.is('{')) {
    throw unexpected(next_, "'{' behind " + quoted(syntax.name),
                     "Write " + std::string(syntax.name) + " { ... }");
  }
  return {syntax, take().place};
}

bool TokenReader::endsBlock() {
  skipSemicolons();
  return takeIf('}');
}

Token TokenReader::keyword(OpenBlock& block) {
  const BlockSyntax& syntax = block.syntax;
  for (std::size_t i = 0; i < syntax.keywords.size(); ++i) {
    const std::string_view known = syntax.keywords[i];
    if (next_.kind != TokenKind::Word || !isSpelling(next_.text, known))
      continue;
    Token keyword = take();
    keyword.text = known;
    if (block.seen[i])
      noteRepeat(syntax, keyword, *block.seen[i]);
    block.seen[i] = keyword.place;
    return keyword;
  }
  if (next_.kind == TokenKind::End) {
    throw unexpected(next_,
                     "the '}' that ends " + quoted(syntax.name) + " at " + describe(block.begin),
                     "Add it where the block is to end");
  }
  throw unexpected(
      next_, "'}' or a keyword of " + quoted(syntax.name),
      adviseNearest(next_, syntax.keywords, "It may hold " + enumerate(syntax.keywords)));
}

void TokenReader::noteRepeat(const BlockSyntax& syntax, const Token& keyword, TextPlace before) {
  const std::string what = quoted(keyword.text) + " of " + quoted(syntax.name);
  if (syntax.repeats == Repeats::Refused) {
    throw malformed(keyword.place, what + " is given a second time, after " + describe(before),
                    "Leave out one of them");
  }
  remark(keyword.place,
         what + " is given a second time, after " + describe(before) + "; the later one counts");
}

void TokenReader::beginList(std::string_view what) {
  expect('(', "before " + std::string(what), "A list looks like (..., ...)");
}

void TokenReader::endList(std::string_view what) {
  expect(')', "or ',' between " + std::string(what), "A list looks like (..., ...)");
}

Error TokenReader::unexpected(const Token& found, std::string_view expected,
                              const std::string& advice) const {
  return malformed(found.place, "expected " + std::string(expected) + ", found " + describe(found),
                   advice);
}

std::string describe(TextPlace place) {
  return "line " + std::to_string(place.line) + ", column " + std::to_string(place.column);
}

std::string describe(const Token& token) {
  switch (token.kind) {
    case TokenKind::Word:
    case TokenKind::Number:
      return quoted(token.text);
    case TokenKind::String:
      return "the text " + quoted(token.text);
    case TokenKind::Punctuation:
      return std::string("'").append(token.text).append("'");
    case TokenKind::End:
      break;
  }
  return "the end of the file";
}

std::string adviseNearest(const Token& found, std::span<const std::string_view> known,
                          const std::string& otherwise) {
  // What is that long was not meant to be a name, and the search takes time with its length.
  constexpr std::size_t kLongest = 40;
  if (!found.isName() || found.text.size() > kLongest)
    return otherwise;
  const std::optional<std::string> nearest = planetree::detail::nearestName(
      found.text, std::vector<std::string>(known.begin(), known.end()));
  return nearest ? "Did you mean " + quoted(*nearest) + "?" : otherwise;
}

std::string enumerate(std::span<const std::string_view> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0)
      text += i + 1 < words.size() ? ", " : " and ";
    text += words[i];
  }
  return text;
}

}  // namespace planetree::scene::ray_format
