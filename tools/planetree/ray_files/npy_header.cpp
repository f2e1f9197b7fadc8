#include "ray_files/npy_header.hpp"

#include <planetree/error.hpp>

#include "support/text_lines.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <limits>
#include <optional>
#include <system_error>

namespace planetree::tool {

namespace {

/// Reads the few Python literals that such a dictionary is made of.
class HeaderParser {
 public:
  HeaderParser(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  NpyHeader parse() {
    expect('{');
    while (!accept('}')) {
      parseEntry();
      if (!accept(',')) {
        expect('}');
        break;
      }
    }
    skipBlanks();
    if (!rest_.empty() || !hasType_ || !hasOrder_ || !hasShape_)
      refuse();
    return header_;
  }

 private:
  [[noreturn]] void refuse() const {
    refuseNpy(name_, "the header is not that of an array",
              "It may be damaged: save the rays again with numpy.save.");
  }

  void skipBlanks() {
    while (!rest_.empty() && (detail::isBlank(rest_.front()) || rest_.front() == '\n'))
      rest_.remove_prefix(1);
  }

  bool accept(char c) {
    skipBlanks();
    if (rest_.empty() || rest_.front() != c)
      return false;
    rest_.remove_prefix(1);
    return true;
  }

  void expect(char c) {
    if (!accept(c))
      refuse();
  }

  bool acceptWord(std::string_view word) {
    skipBlanks();
    if (rest_.substr(0, word.size()) != word)
      return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  void parseEntry() {
    const std::string key = parseString();
    expect(':');
    if (key == "descr" && !hasType_) {
      hasType_ = true;
      parseType();
    } else if (key == "fortran_order" && !hasOrder_) {
      hasOrder_ = true;
      header_.isFortranOrder = parseTruth();
    } else if (key == "shape" && !hasShape_) {
      hasShape_ = true;
      parseShape();
    } else {
      refuse();
    }
  }

  std::string parseString() {
    const char quote = accept('\'') ? '\'' : '"';
    if (quote == '"')
      expect('"');
    const std::size_t end = rest_.find(quote);
    if (end == std::string_view::npos)
      refuse();
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return text;
  }

  bool parseTruth() {
    if (acceptWord("True"))
      return true;
    if (!acceptWord("False"))
      refuse();
    return false;
  }

  /// The type of a record is a list, of which nothing is wanted but its end.
  void parseType() {
    if (!accept('[')) {
      header_.type = parseString();
      return;
    }
    for (int depth = 1; depth > 0; rest_.remove_prefix(1)) {
      if (rest_.empty())
        refuse();
      depth += rest_.front() == '[' ? 1 : rest_.front() == ']' ? -1 : 0;
    }
  }

  void parseShape() {
    expect('(');
    while (!accept(')')) {
      header_.shape.push_back(parseLength());
      if (!accept(',')) {
        expect(')');
        break;
      }
    }
  }

  std::uint64_t parseLength() {
    skipBlanks();
    std::uint64_t length = 0;
    const char* const end = rest_.data() + rest_.size();
    const auto [parsedEnd, error] = std::from_chars(rest_.data(), end, length);
    if (error != std::errc{})
      refuse();
    rest_.remove_prefix(static_cast<std::size_t>(parsedEnd - rest_.data()));
    accept('L');  // Python 2 wrote long integers so.
    return length;
  }

  std::string_view rest_;
  const std::string& name_;
  NpyHeader header_;
  bool hasType_ = false;
  bool hasOrder_ = false;
  bool hasShape_ = false;
};

std::string dictionary(std::string_view type, std::uint64_t count) {
  return fmt::format("{{'descr': {}, 'fortran_order': False, 'shape': ({},), }}", type, count);
}

}  // namespace

void refuseNpy(const std::string& name, const std::string& problem, const std::string& advice) {
  throw Error(ErrorCode::MalformedFile, problem, advice, {.file = name});
}

NpyHeader parseNpyHeader(std::string_view dictionary, const std::string& name) {
  return HeaderParser(dictionary, name).parse();
}

std::string makeNpyHeader(std::string_view type, std::uint64_t count) {
  constexpr std::size_t kAlignment = 64;  // of the records, so that they can be mapped
  const std::string prefix = std::string(kNpyMagic) + std::string("\x01\x00", 2);
  const std::size_t start = prefix.size() + sizeof(std::uint16_t);
  const std::size_t longest =
      start + dictionary(type, std::numeric_limits<std::uint64_t>::max()).size() + 1;
  const std::size_t size = (longest + kAlignment - 1) / kAlignment * kAlignment;

  const std::size_t length = size - start;
  std::string header = prefix;
  header += static_cast<char>(length & 0xFF);
  header += static_cast<char>(length >> 8);
  header += dictionary(type, count);
  header.resize(size - 1, ' ');
  return header + '\n';
}

}  // namespace planetree::tool
