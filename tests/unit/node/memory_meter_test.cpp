#include "support/memory_meter.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace planetree::detail {
namespace {

TEST(MemoryMeter, RemembersTheMostThatWasHeldAtATime) {
  MemoryMeter meter(1000);
  EXPECT_EQ(meter.peak(), 0u);
  meter.add(600);
  meter.remove(500);
  meter.add(300);
  EXPECT_EQ(meter.peak(), 600u);
  meter.add(400);
  EXPECT_EQ(meter.peak(), 800u);
}

TEST(MemoryMeter, GivesAllOfTheLimitAndNotAByteMore) {
  MemoryMeter meter(1000);
  meter.add(999);
  EXPECT_THROW(meter.add(2), Error);
  meter.add(1);
  EXPECT_THROW(meter.add(1), Error);
  EXPECT_EQ(meter.peak(), 1000u);
}

TEST(MemoryMeter, CountsNothingOfWhatItRefuses) {
  MemoryMeter meter(1000);
  meter.add(10);
  EXPECT_THROW(meter.add(5000), Error);
  EXPECT_EQ(meter.peak(), 10u);
  meter.add(990);
  EXPECT_EQ(meter.peak(), 1000u);
}

TEST(MemoryMeter, NamesTheLimitAndWaysOut) {
  MemoryMeter meter(50'000'000);
  try {
    meter.add(50'000'001);
    FAIL() << "was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::MemoryLimitExceeded);
    EXPECT_EQ(std::string(error.what()).find("the build needs more than 50 MB of memory. Raise "),
              0u)
        << error.what();
  }
}

TEST(MemoryMeter, WithoutALimitRefusesWhatNoMachineHas) {
  MemoryMeter meter(0);
  meter.add(1'000'000);
  constexpr std::size_t kMoreThanAnyMachineHas = std::numeric_limits<std::size_t>::max() / 2;
  EXPECT_THROW(meter.add(kMoreThanAnyMachineHas), Error);
}

TEST(MemoryMeter, LosesNothingBetweenThreads) {
  constexpr std::size_t kThreadCount = 4;
  constexpr std::size_t kStepCount = 10'000;
  // Each thread holds two more for a moment.
  constexpr std::size_t kLimit = kThreadCount * (kStepCount + 2);
  MemoryMeter meter(kLimit);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < kThreadCount; ++i) {
    threads.emplace_back([&meter] {
      for (std::size_t step = 0; step < kStepCount; ++step) {
        meter.add(3);
        meter.remove(2);
      }
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  meter.add(2 * kThreadCount);
  EXPECT_THROW(meter.add(1), Error) << "all of it is taken";
  EXPECT_EQ(meter.peak(), kLimit);
}

TEST(MemoryCharge, LastsAsLongAsItsOwner) {
  MemoryMeter meter(100);
  {
    const MemoryCharge charge(meter, 80);
    EXPECT_THROW(meter.add(21), Error);
  }
  meter.add(100);
}

TEST(MemoryCharge, IsCountedOnceWhenItMoves) {
  MemoryMeter meter(100);
  {
    MemoryCharge first(meter, 60);
    MemoryCharge second(std::move(first));
    MemoryCharge third;
    third = std::move(second);
    EXPECT_THROW(meter.add(41), Error);
    third = MemoryCharge();
    meter.add(100);
    meter.remove(100);
  }
  meter.add(100);
  EXPECT_EQ(meter.peak(), 100u);
}

TEST(MemoryCharge, GrowsAndShrinksWithinTheLimit) {
  MemoryMeter meter(100);
  {
    MemoryCharge charge;
    charge.resize(meter, 30);
    charge.resize(meter, 90);
    EXPECT_EQ(meter.peak(), 90u);
    EXPECT_THROW(charge.resize(meter, 101), Error);
    EXPECT_THROW(meter.add(11), Error);
    charge.resize(meter, 10);
    meter.add(90);
    meter.remove(90);
  }
  meter.add(100);
}

TEST(MemoryCharge, ThatWasRefusedTakesNothing) {
  MemoryMeter meter(100);
  EXPECT_THROW(MemoryCharge(meter, 101), Error);
  meter.add(100);
}

}  // namespace
}  // namespace planetree::detail
