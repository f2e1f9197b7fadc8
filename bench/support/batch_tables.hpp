#pragma once

#include "bench/support/summary.hpp"
#include "bench/support/table.hpp"

#include <vector>

namespace planetree::bench {

/// For each number of threads with which batches were measured: how many times more rays
/// planetree's default traces than the mode of Embree that is best for the scene and the kind of
/// rays. Below the scenes stand the geometric mean and the worst of each kind, and of all kinds but
/// primary rays together. A table without rows says that there was nothing to compare.
[[nodiscard]] std::vector<Table> batchTables(const std::vector<Summary>& summaries);

}  // namespace planetree::bench
