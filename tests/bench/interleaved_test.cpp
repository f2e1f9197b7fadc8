#include "bench/support/interleaved.hpp"

#include "bench/support/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <vector>

namespace planetree::bench {
namespace {

TEST(BestOfRounds, MeasuresAllOnceARoundAndBeginsWithAnotherEachTime) {
  std::vector<std::size_t> order;
  (void)bestOfRounds(3, 3, [&](std::size_t i) {
    order.push_back(i);
    return 1.0;
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 1, 2, 0, 2, 0, 1}));
}

TEST(BestOfRounds, KeepsTheLeastOfEach) {
  const std::vector<std::vector<double>> times = {{3.0, 1.0, 2.0}, {5.0, 6.0, 4.0}};
  std::vector<std::size_t> turns(2, 0);
  const auto best = bestOfRounds(2, 3, [&](std::size_t i) { return times[i][turns[i]++]; });
  EXPECT_EQ(best, (std::vector<double>{1.0, 4.0}));
}

TEST(ParallelFor, CoversEachIndexOnceOnAnyNumberOfThreads) {
  for (const unsigned threadCount : {1u, 2u, 5u}) {
    for (const std::size_t count : {0u, 1u, 99u, 1000u}) {
      std::vector<std::atomic<int>> visits(count);
      parallelFor(count, 7, threadCount, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          ++visits[i];
      });
      for (const auto& visit : visits)
        ASSERT_EQ(visit, 1);
    }
  }
}

}  // namespace
}  // namespace planetree::bench
