#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace planetree::detail {

/// Walks over the lines of a text and counts them. Lines end with "\n"; a "\r" before it belongs to
/// the blanks. The last line needs no end.
class TextLines {
 public:
  explicit TextLines(std::span<const std::byte> text) noexcept
      : text_(reinterpret_cast<const char*>(text.data()), text.size()) {}

  /// Goes to the next line, from the start to the first; false if there is none.
  [[nodiscard]] bool next() noexcept {
    if (nextOffset_ == text_.size())
      return false;
    const char* const begin = text_.data() + nextOffset_;
    const std::size_t rest = text_.size() - nextOffset_;
    const void* const newline = std::memchr(begin, '\n', rest);
    const std::size_t length =
        newline ? static_cast<std::size_t>(static_cast<const char*>(newline) - begin) : rest;
    line_ = {begin, length};
    nextOffset_ += length + (newline ? 1 : 0);
    ++number_;
    return true;
  }

  /// The present line without its end.
  [[nodiscard]] std::string_view line() const noexcept { return line_; }
  /// The number of the present line, counted from 1.
  [[nodiscard]] std::int64_t number() const noexcept { return number_; }
  /// Where the next line begins.
  [[nodiscard]] std::size_t nextOffset() const noexcept { return nextOffset_; }
  /// Bytes behind the present line.
  [[nodiscard]] std::size_t remaining() const noexcept { return text_.size() - nextOffset_; }

 private:
  std::string_view text_;
  std::string_view line_;
  std::size_t nextOffset_ = 0;
  std::int64_t number_ = 0;
};

[[nodiscard]] constexpr bool isBlank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Cuts the first word off a line and returns it; it is empty if there are only blanks.
[[nodiscard]] inline std::string_view takeWord(std::string_view& line) noexcept {
  std::size_t begin = 0;
  while (begin < line.size() && isBlank(line[begin]))
    ++begin;
  std::size_t end = begin;
  while (end < line.size() && !isBlank(line[end]))
    ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

/// A word of the input for an error text: in quotes, shortened, and without unprintable bytes.
[[nodiscard]] std::string quoted(std::string_view word);

}  // namespace planetree::detail
