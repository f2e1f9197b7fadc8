#pragma once

#include "import/message_reader.hpp"

#include <cstdint>
#include <vector>

namespace planetree::importing {

/// Polygons as they come in words, over any number of messages: a count, and so many corners.
class PolygonWords {
 public:
  /// Takes the words of a message, and calls `use(corners)` for each polygon that ends in it.
  template <class Use>
  void take(Message& message, const Use& use) {
    while (!message.payload.empty()) {
      const auto word = message.take<std::uint32_t>();
      if (missing_ == 0) {
        missing_ = word;
        corners_.clear();
      } else {
        corners_.push_back(word);
        --missing_;
      }
      if (missing_ == 0)
        use(corners_);
    }
  }

  /// Throws `BrokenMessages` if the last polygon is not complete.
  void requireEnd() const {
    if (missing_ != 0)
      throw BrokenMessages("the last polygon lacks corners");
  }

 private:
  std::vector<std::uint32_t> corners_;
  std::uint64_t missing_ = 0;  ///< how many corners are still to come
};

}  // namespace planetree::importing
