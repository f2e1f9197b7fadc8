#pragma once

#include "bench/support/result.hpp"
#include "bench/support/summary.hpp"
#include "bench/support/table.hpp"

#include <vector>

namespace planetree::bench {

/// What small batches take more than their rays one by one, beside what is allowed, and how many
/// cells of each size are as they should be. Without rows if no small batches were measured.
[[nodiscard]] Table smallBatchTable(const std::vector<Summary>& summaries);

/// All results but those that the table puts together.
[[nodiscard]] std::vector<Result> withoutSmallBatches(std::vector<Result> results);

}  // namespace planetree::bench
