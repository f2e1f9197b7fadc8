#include "threads/library_work.hpp"

#include <gtest/gtest.h>

#if defined(_OPENMP)
#include <omp.h>
#endif

#include <atomic>
#include <cstdint>

/// The library inside of a program's own OpenMP regions.
namespace planetree::test {
namespace {

class InsideOpenMp : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
#if !defined(_OPENMP)
    GTEST_SKIP() << "the tests were built without OpenMP";
#endif
  }

  const LibraryWork& work_ = libraryWork();
  std::atomic<int> failures_ = 0;
};

TEST_P(InsideOpenMp, AllIsAsOutsideInALoop) {
#if defined(_OPENMP)
#pragma omp parallel for num_threads(GetParam()) schedule(dynamic)
  for (int turn = 0; turn < 12; ++turn)
    failures_ += work_.doesTheSame(turn) ? 0 : 1;
#endif
  EXPECT_EQ(failures_, 0);
}

TEST_P(InsideOpenMp, AllIsAsOutsideInTheSectionsOfALock) {
#if defined(_OPENMP)
#pragma omp parallel for num_threads(GetParam()) schedule(dynamic)
  for (int turn = 0; turn < 8; ++turn) {
#pragma omp critical
    failures_ += work_.doesTheSame(turn) ? 0 : 1;
  }
#endif
  EXPECT_EQ(failures_, 0);
}

TEST_P(InsideOpenMp, AllIsAsOutsideInTasks) {
#if defined(_OPENMP)
#pragma omp parallel num_threads(GetParam())
#pragma omp single
  for (int turn = 0; turn < 8; ++turn) {
#pragma omp task firstprivate(turn)
    failures_ += work_.doesTheSame(turn) ? 0 : 1;
  }
#endif
  EXPECT_EQ(failures_, 0);
}

INSTANTIATE_TEST_SUITE_P(Threads, InsideOpenMp, testing::Values(1, 2, 8),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace planetree::test
