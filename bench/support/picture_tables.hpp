#pragma once

#include "bench/support/result.hpp"
#include "bench/support/table.hpp"

#include <vector>

namespace planetree::bench {

/// What pictures take, with each number of threads and how many times faster than with one: their
/// rendering alone, and everything from reading to the bytes of the file. Empty if no pictures were
/// measured.
[[nodiscard]] std::vector<Table> pictureTables(const std::vector<Result>& results);

/// All results but those that the tables put together.
[[nodiscard]] std::vector<Result> withoutPictures(std::vector<Result> results);

}  // namespace planetree::bench
