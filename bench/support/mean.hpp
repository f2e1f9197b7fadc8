#pragma once

#include "bench/support/summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace planetree::bench {

/// In a table, where there is no number.
inline constexpr const char* kNotMeasured = "-";

/// The geometric mean of the numbers added to it, and the least of them.
class Mean {
 public:
  void add(double number) {
    logSum_ += std::log(number);
    ++count_;
    least_ = std::min(least_, number);
  }
  [[nodiscard]] std::string text() const { return isEmpty() ? kNotMeasured : ratioText(value()); }
  [[nodiscard]] std::string leastText() const {
    return isEmpty() ? kNotMeasured : ratioText(least_);
  }
  // Of these there must be one number at least.
  [[nodiscard]] double value() const { return std::exp(logSum_ / count_); }
  [[nodiscard]] double least() const noexcept { return least_; }
  [[nodiscard]] bool isEmpty() const noexcept { return count_ == 0; }

 private:
  double logSum_ = 0.0;
  double count_ = 0.0;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace planetree::bench
