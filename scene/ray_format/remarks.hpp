#pragma once

#include "scene/ray_format/lexer.hpp"

#include <string>
#include <vector>

namespace planetree::scene::ray_format {

/// Collects what is odd about a scene but no error; not without end, for what is wrong a thousand
/// times is read once.
class Remarks {
 public:
  explicit Remarks(std::vector<std::string>& lines) noexcept : lines_(lines) {}

  void add(const Lexer& lexer, TextPlace place, const std::string& text) {
    constexpr std::size_t kMost = 100;
    if (lines_.size() < kMost)
      lines_.push_back(lexer.remark(place, text));
    else if (lines_.size() == kMost)
      lines_.push_back(lexer.name() + ": there is more like this");
  }

 private:
  std::vector<std::string>& lines_;
};

}  // namespace planetree::scene::ray_format
