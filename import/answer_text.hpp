#pragma once

#include "import/message_reader.hpp"

#include <planetree/error.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Texts in messages, fit to be shown to a person.
namespace planetree::importing {

/// A text from outside, fit to be shown in a line: without control characters, and not too long.
[[nodiscard]] std::string presentable(const std::string& text);

/// The first few remarks, each once; the others are only counted.
class RemarkList {
 public:
  void add(const std::string& text);

  [[nodiscard]] const std::vector<std::string>& remarks() const noexcept { return remarks_; }
  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }

 private:
  static constexpr std::size_t kKept = 16;

  std::vector<std::string> remarks_;
  std::uint64_t count_ = 0;
};

/// The error that a message of the kind `Failure` tells of. Throws `BrokenMessages` if it tells of
/// none.
[[nodiscard]] Error failureOf(Message& message, const std::string& fileName);

}  // namespace planetree::importing
