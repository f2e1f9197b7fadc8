#pragma once

#include "bits_of.hpp"
#include "fault_tally.hpp"
#include "memory_faults.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <exception>
#include <new>
#include <string>

namespace planetree::test {

/// How many requests for memory `work` makes.
template <class Work>
[[nodiscard]] std::uint64_t requestCountOf(const Work& work) {
  const MemoryFaults counting(FaultKind::None, 0);
  static_cast<void>(work());
  counting.end();
  return MemoryFaults::requestCount();
}

/// Lets requests for memory fail while `work` runs: `std::bad_alloc` or `Error` must come out, or
/// what comes out without a fault, bit for bit, where there is another way.
template <class Work>
void tryFault(const std::string& what, const Work& work, const std::string& expected,
              FaultKind kind, std::uint64_t number) {
  const std::string name = what + ", request " + std::to_string(number) +
                           (kind == FaultKind::FromThenOn ? " and all behind it" : "");
  const HeldMemory before = heldMemory();
  const MemoryFaults faults(kind, number);
  try {
    const auto result = work();
    faults.end();
    if (bitsOf(result) != expected)
      reportLost(name + ": another result");
  } catch (const std::bad_alloc&) {
  } catch (const Error&) {
  } catch (const std::exception& error) {
    faults.end();
    reportLost(name + ": " + error.what());
  }
  faults.end();
  faultTally().injectedCount += MemoryFaults::failedCount();
  if (heldMemory() != before)
    reportLeak(name);
}

/// Tries faults at every request for memory that `work` makes, or about `most` of them, one by one
/// and from there on. Between them `work` is done without, about `checks` times.
template <class Work>
void tryFaults(const std::string& what, const Work& work, std::uint64_t most = 100'000,
               std::uint64_t checks = 100'000) {
  SCOPED_TRACE(what);
  // What is made once and kept is made here.
  const std::string expected = bitsOf(work());
  const std::uint64_t count = requestCountOf(work);
  const std::size_t fileCount = openFileCount();
  for (const FaultKind kind : {FaultKind::One, FaultKind::FromThenOn}) {
    const std::vector<std::uint64_t> numbers = someOf(count, most);
    const std::size_t stepOfChecks = 1 + numbers.size() / checks;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      tryFault(what, work, expected, kind, numbers[i]);
      if (i % stepOfChecks == 0 || i + 1 == numbers.size()) {
        if (bitsOf(work()) != expected)
          reportLost(what + ": another result after a fault");
      }
      if (testing::Test::HasFailure())
        return;
    }
  }
  EXPECT_EQ(openFileCount(), fileCount);
}

}  // namespace planetree::test
