#include "scene/json_format/parse_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planetree::scene::json_format {

namespace {

/// Walks over the text and tells how far it has come, from which follows where a value stands: the
/// parser itself does not say.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, const char** farthest) noexcept : at_(at), farthest_(farthest) {}

  reference operator*() const noexcept { return *at_; }
  CountingIterator& operator++() noexcept {
    *farthest_ = ++at_;
    return *this;
  }
  CountingIterator operator++(int) noexcept {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) noexcept {
    return a.at_ == b.at_;
  }

 private:
  const char* at_;
  const char** farthest_;
};

std::string_view viewOf(const JsonText& text) noexcept {
  return {reinterpret_cast<const char*>(text.bytes().data()), text.bytes().size()};
}

/// What the library says, without its own name for it, the place, and the text that it read, which
/// may be long: "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error
/// while parsing value - invalid literal; last read: '...'; expected end of input".
std::string plainProblem(std::string_view what) {
  if (const std::size_t end = what.find("] "); end != std::string_view::npos)
    what.remove_prefix(end + 2);
  if (what.starts_with("parse error")) {
    if (const std::size_t colon = what.find(": "); colon != std::string_view::npos)
      what.remove_prefix(colon + 2);
  }
  std::string problem(what);
  const std::size_t read = problem.find("; last read: '");
  const std::size_t end = problem.rfind('\'');
  if (read != std::string::npos)
    problem.erase(read, std::max(end, read) + 1 - read);
  constexpr std::size_t kLongest = 160;
  if (problem.size() > kLongest)
    problem = problem.substr(0, kLongest) + "...";
  return problem;
}

/// Whether the parser knows the token from its first byte to its last, rather than what it has read
/// up to the byte that it stumbled over.
bool isWholeToken(std::string_view token) noexcept {
  if (token.empty())
    return false;
  const bool isString = token.size() > 1 && token.front() == '"' && token.back() == '"';
  return isString || token.find_first_not_of("+-.0123456789Ee") == std::string_view::npos;
}

/// Builds the tree of values from what the parser meets, which calls each of these functions by
/// its name. The parser keeps a stack of its own, and so does this: depth costs no recursion.
class TreeBuilder {
 public:
  explicit TreeBuilder(const JsonText& text)
      : text_(text), view_(viewOf(text)), farthest_(view_.data()) {
    // A byte order mark is no part of the text.
    if (view_.starts_with("\xEF\xBB\xBF"))
      farthest_ += 3;
    end_ = static_cast<std::size_t>(farthest_ - view_.data());
  }

  Value parsed() {
    nlohmann::json::sax_parse(CountingIterator(view_.data(), &farthest_),
                              CountingIterator(view_.data() + view_.size(), &farthest_), this);
    return std::move(root_);
  }

  bool null() { return add({}); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return add(static_cast<double>(value)); }
  bool number_float(double value, const std::string& /*text*/) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(std::vector<std::uint8_t>& /*value*/) { return false; }

  bool start_object(std::size_t /*size*/) { return open(Object()); }
  bool start_array(std::size_t /*size*/) { return open(Array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    const std::size_t offset = takeOffset();
    auto& object = std::get<Object>(open_.back()->content);
    if (!seen_.back().insert(name).second) {
      throw text_.malformed(offset, "the key \"" + name + "\" is there twice",
                            "Leave one of them out.");
    }
    object.push_back({.key = std::move(name), .keyOffset = offset, .value = {}});
    return true;
  }

  bool parse_error(std::size_t position, const std::string& lastToken,
                   const nlohmann::json::exception& error) {
    // The position is behind the last byte that was read; at the end of the text it is one more.
    const std::size_t end = std::min(position, view_.size() + 1);
    const std::size_t length = isWholeToken(lastToken) ? lastToken.size() : 1;
    throw text_.malformed(end - std::min(length, end), plainProblem(error.what()),
                          "Mend the JSON there, or just before.");
  }

 private:
  /// Where the next token begins: behind the one before it and the blanks and marks between them.
  /// Of a number one byte more has been read, which is a blank or a mark that ends it.
  std::size_t takeOffset() {
    const std::size_t offset = std::min(view_.find_first_not_of(" \t\r\n,:]}", end_), view_.size());
    end_ = static_cast<std::size_t>(farthest_ - view_.data());
    return offset;
  }

  Value& place(std::size_t offset) {
    if (++valueCount_ > kMaxValueCount) {
      throw Error(ErrorCode::CapacityExceeded,
                  "the file has more than " + std::to_string(kMaxValueCount) + " values",
                  "Keep large meshes in model files, and name those in the scene.",
                  text_.placeOf(offset));
    }
    if (open_.empty())
      return root_;
    if (auto* array = std::get_if<Array>(&open_.back()->content))
      return array->emplace_back();
    return std::get<Object>(open_.back()->content).back().value;
  }

  template <class Content>
  Value& put(Content content) {
    const std::size_t offset = takeOffset();
    Value& value = place(offset);
    value.offset = offset;
    value.content = std::move(content);
    return value;
  }

  bool add(decltype(Value::content) content) {
    put(std::move(content));
    return true;
  }

  template <class Content>
  bool open(Content content) {
    Value& value = put(std::move(content));
    if (open_.size() >= kMaxNestingDepth) {
      throw text_.malformed(
          value.offset,
          "the file is nested deeper than " + std::to_string(kMaxNestingDepth) + " levels",
          "Take groups apart, or leave brackets out: " + std::to_string(kMaxGroupDepth) +
              " groups may stand in each other.");
    }
    // Nothing is added beside an open value, so it stays where it is.
    open_.push_back(&value);
    seen_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    seen_.pop_back();
    end_ = static_cast<std::size_t>(farthest_ - view_.data());
    return true;
  }

  const JsonText& text_;
  std::string_view view_;
  const char* farthest_;  ///< behind the last byte that was read
  std::size_t end_ = 0;   ///< of the last token
  Value root_;
  std::vector<Value*> open_;
  std::vector<std::set<std::string>> seen_;  ///< keys of the open objects
  std::size_t valueCount_ = 0;
};

}  // namespace

Value parseJson(const JsonText& text) {
  return TreeBuilder(text).parsed();
}

}  // namespace planetree::scene::json_format
