#pragma once

#include "bench/support/result.hpp"
#include "bench/support/table.hpp"

#include <vector>

namespace planetree::bench {

/// What results say when they are looked at across columns, threads and scenes. Tables for which
/// nothing was measured are left out:
///
/// - each preset of planetree beside the quality of Embree that is its counterpart, for each
///   measure: the geometric mean, over scenes and kinds of rays, of how many times better planetree
///   is;
/// - for batches: how many times more rays planetree's default traces than the mode of Embree that
///   is best for the scene and the kind of rays, and the mean and the worst of each kind, and of
///   all kinds but primary rays together;
/// - for small batches: what they take more than their rays one by one;
/// - for builds and batches with one thread and with more: how many times faster more threads are,
///   for each scene, over all kinds of rays;
/// - for builds of `sizedSceneName` scenes: the time for each triangle, and how it grows beside the
///   logarithm of their number, which is what sorting costs;
/// - for pictures: what they take, and how many times faster more threads are.
[[nodiscard]] std::vector<Table> comparisons(const std::vector<Result>& results);

}  // namespace planetree::bench
