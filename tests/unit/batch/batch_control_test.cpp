#include <planetree/batch/batch_options.hpp>

#include <planetree/planetree.hpp>

#include "support/batch_rays.hpp"
#include "support/batch_scenes.hpp"
#include "support/compare_batches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace planetree {
namespace {

/// Makes a batch as slow as a test wants it: the filter of a query that waits for each hit it is
/// shown. It accepts every hit.
class SlowFilter {
 public:
  explicit SlowFilter(std::chrono::microseconds wait) : wait_(wait) {}

  /// Asks for a stop when so many hits have been shown.
  void stopAfter(std::size_t count, std::stop_source source) {
    stopCount_ = count;
    source_ = std::move(source);
  }
  [[nodiscard]] std::size_t shownCount() const noexcept { return shownCount_; }

  [[nodiscard]] HitFilter filter() {
    return HitFilter(
        [](const Hitf& /*hit*/, void* context) noexcept {
          SlowFilter& self = *static_cast<SlowFilter*>(context);
          if (++self.shownCount_ == self.stopCount_)
            self.source_.request_stop();
          const auto end = std::chrono::steady_clock::now() + self.wait_;
          while (std::chrono::steady_clock::now() < end)
            std::this_thread::yield();
          return true;
        },
        this);
  }

 private:
  std::chrono::microseconds wait_;
  std::size_t stopCount_ = 0;
  std::stop_source source_;
  std::atomic<std::size_t> shownCount_ = 0;
};

/// Long enough for progress to be told before the end, even if each thread has but one portion.
constexpr std::chrono::microseconds kLongWait(25);

class BatchControlTest : public testing::TestWithParam<std::uint32_t> {
 protected:
  [[nodiscard]] BatchOptions options(const QueryOptions& query = {}) const {
    return {.query = query, .threadCount = GetParam()};
  }

  /// Some hits must be what the rays say alone, and all others what stood there before. Returns how
  /// many were answered.
  [[nodiscard]] std::size_t countAnswered(std::span<const Hitf> hits) const {
    const Hitf untouched = test::untouchedHit<float>();
    std::size_t count = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (test::hasSameBits(hits[i], untouched))
        continue;
      ++count;
      EXPECT_TRUE(test::hasSameBits(hits[i], alone_.hits[i])) << i;
    }
    return count;
  }

  /// That a batch ended early. A machine with very many threads is at work on all rays at once.
  void expectSomeAreMissing() const {
    const std::size_t count = countAnswered(hits_);
    EXPECT_TRUE(GetParam() == 0 || count < rays_.size());
  }

  KdTree<Face<float>> tree_ = buildTree(test::room<float>());
  std::vector<Rayf> rays_ = test::randomRays<float>(tree_.bounds(), 30'000, 701);
  test::SingleAnswers<float> alone_{tree_.view(), rays_};
  std::vector<Hitf> hits_ = std::vector<Hitf>(rays_.size(), test::untouchedHit<float>());
};

TEST_P(BatchControlTest, ProgressNeverFallsAndEndsWithOne) {
  SlowFilter slow(kLongWait);
  std::vector<double> told;
  std::atomic<int> tellingCount = 0;
  std::atomic<bool> toldAtOnce = false;
  const auto onProgress = [&](double done) {
    if (++tellingCount != 1)
      toldAtOnce = true;
    told.push_back(done);
    --tellingCount;
  };
  tree_.findIntersections(rays_, hits_, options({.filter = slow.filter()}),
                          {.onProgress = onProgress});
  EXPECT_FALSE(toldAtOnce);
  ASSERT_GT(told.size(), 1u) << "it took more than a tenth of a second";
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.front(), 0.0);
  EXPECT_EQ(told.back(), 1.0);
  EXPECT_EQ(std::count(told.begin(), told.end(), 1.0), 1);
  EXPECT_EQ(countAnswered(hits_), rays_.size());
}

TEST_P(BatchControlTest, ProgressOfAnyBatchEndsWithOne) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{100}, rays_.size()}) {
    double last = 0.0;
    const BatchControl control = {.onProgress = [&last](double done) {
      EXPECT_GE(done, last);
      last = done;
    }};
    const auto rays = std::span<const Rayf>(rays_).first(count);
    tree_.findIntersections(rays, std::span(hits_).first(count), options(), control);
    EXPECT_EQ(last, 1.0) << count;
    last = 0.0;
    std::vector<std::uint8_t> flags(count);
    tree_.areOccluded(rays, flags, options(), control);
    EXPECT_EQ(last, 1.0) << count;
  }
}

TEST_P(BatchControlTest, AStopBeforeTheStartCancelsTheBatch) {
  std::stop_source source;
  source.request_stop();
  double told = 0.0;
  const BatchControl control = {.onProgress = [&told](double done) { told = done; },
                                .stopToken = source.get_token()};
  EXPECT_THROW(tree_.findIntersections(rays_, hits_, options(), control), Cancelled);
  EXPECT_EQ(countAnswered(hits_), 0u);
  std::vector<std::uint8_t> flags(rays_.size(), test::kUntouchedFlag);
  EXPECT_THROW(tree_.areOccluded(rays_, flags, options(), control), Cancelled);
  EXPECT_EQ(flags, std::vector<std::uint8_t>(rays_.size(), test::kUntouchedFlag));
  EXPECT_EQ(told, 0.0);
}

TEST_P(BatchControlTest, AStopInTheMiddleCancelsTheRest) {
  SlowFilter slow(std::chrono::microseconds(1));
  std::stop_source source;
  slow.stopAfter(100, source);
  double told = 0.0;
  const BatchControl control = {.onProgress = [&told](double done) { told = done; },
                                .stopToken = source.get_token()};
  EXPECT_THROW(tree_.findIntersections(rays_, hits_, options({.filter = slow.filter()}), control),
               Cancelled);
  expectSomeAreMissing();
  EXPECT_GE(slow.shownCount(), 100u);
  EXPECT_LT(told, 1.0);
}

TEST_P(BatchControlTest, AStopAskedForByProgressCancelsTheRest) {
  SlowFilter slow(kLongWait);
  std::stop_source source;
  double told = 0.0;
  const BatchControl control = {.onProgress =
                                    [&](double done) {
                                      told = done;
                                      source.request_stop();
                                    },
                                .stopToken = source.get_token()};
  std::vector<std::uint8_t> flags(rays_.size());
  EXPECT_THROW(tree_.areOccluded(rays_, flags, options({.filter = slow.filter()}), control),
               Cancelled);
  EXPECT_GT(told, 0.0);
  EXPECT_LT(told, 1.0);
}

// Queries without choices take other ways than those with a filter, which the tests above slow
// down: these batches have to be long by themselves.
TEST_P(BatchControlTest, AStopFromAnotherThreadCancelsALongBatchOfPlainRays) {
  std::vector<Rayf> rays;
  while (rays.size() < 1'000'000)
    rays.insert(rays.end(), rays_.begin(), rays_.end());
  std::vector<std::uint8_t> flags(rays.size(), test::kUntouchedFlag);
  std::stop_source source;
  std::thread stopper([&source] {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    source.request_stop();
  });
  bool isCancelled = false;
  try {
    tree_.areOccluded(rays, flags, options(), {.stopToken = source.get_token()});
  } catch (const Cancelled&) {
    isCancelled = true;
  }
  stopper.join();
  // A machine may let the batch come to its end before the other thread stops it.
  const auto untouched = std::count(flags.begin(), flags.end(), test::kUntouchedFlag);
  EXPECT_TRUE(isCancelled || untouched == 0);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_TRUE(flags[i] == test::kUntouchedFlag || flags[i] == alone_.flags[i % rays_.size()])
        << i;
  }
}

struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

TEST_P(BatchControlTest, WhatProgressThrowsEndsTheBatchAndComesOut) {
  SlowFilter slow(kLongWait);
  const auto throwAtOnce = [](double done) {
    if (done < 1.0)
      throw Refusal("not now");
  };
  EXPECT_THROW(tree_.findIntersections(rays_, hits_, options({.filter = slow.filter()}),
                                       {.onProgress = throwAtOnce}),
               Refusal);
  expectSomeAreMissing();
}

TEST_P(BatchControlTest, WhatProgressThrowsAtTheEndComesOutToo) {
  const auto throwAtEnd = [](double done) {
    if (done == 1.0)
      throw Refusal("too late");
  };
  EXPECT_THROW(tree_.findIntersections(rays_, hits_, options(), {.onProgress = throwAtEnd}),
               Refusal);
  EXPECT_EQ(countAnswered(hits_), rays_.size());
}

TEST_P(BatchControlTest, ATreeAnswersOnAfterABatchWasCancelled) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(tree_.findIntersections(rays_, hits_, options(), {.stopToken = source.get_token()}),
               Cancelled);
  test::expectAnswers<float>(tree_.view(), rays_, alone_, options());
}

INSTANTIATE_TEST_SUITE_P(Threads, BatchControlTest, testing::Values(0u, 1u, 2u),
                         [](const auto& count) { return std::to_string(count.param); });

}  // namespace
}  // namespace planetree
